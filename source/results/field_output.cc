#include <magmpm/elliptic/elliptic_space.h>
#include <magmpm/magnetics/material_points.h>
#include <magmpm/magnetics/potential_problem.h>
#include <magmpm/results/field_output.h>
#include <magmpm/results/written_values.h>

#include <deal.II/fe/fe_tools.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    template <int dim>
    constexpr int n_cell_nodes = power(potential_degree + 1, dim);

    /** Derivatives of the shape functions of FE_Q(2) at its nodes on [0, 1]: (node, function). */
    constexpr double derivative_1d[3][3] = {{-3., 4., -1.}, {-1., 0., 1.}, {1., -4., 3.}};

    int
    place(const int node, const int axis)
    {
      return node / power(3, axis) % 3;
    }

    /** Whether a node of a cell lies at an octant of it: its corners, and what lies between these. */
    template <int dim>
    bool
    touches(const int node, const int octant)
    {
      for (int axis = 0; axis < dim; ++axis)
        if (place(node, axis) == (octant >> axis & 1 ? 0 : 2))
          return false;
      return true;
    }

    /** Means over the cells around a node, continuous also at hanging nodes. */
    template <int dim, int n_components>
    class NodalMean
    {
    public:
      using Values = std::array<double, n_components>;

      explicit NodalMean(const EllipticSpace<dim> &space)
        : space(space)
      {
        for (PotentialVector &sum : sums)
          sum.reinit(
            space.dof_handler.locally_owned_dofs(), space.relevant_dofs, space.mesh.communicator());
        count.reinit(sums[0]);
      }

      void
      add(const dealii::types::global_dof_index dof, const Values &values)
      {
        for (int c = 0; c < n_components; ++c)
          sums[c](dof) += values[c];
        count(dof) += 1.;
      }

      /** Collective. */
      void
      finish()
      {
        count.compress(dealii::VectorOperation::add);
        for (PotentialVector &sum : sums)
          {
            sum.compress(dealii::VectorOperation::add);
            for (unsigned int i = 0; i < sum.locally_owned_size(); ++i)
              if (count.local_element(i) > 0.)
                sum.local_element(i) /= count.local_element(i);
            space.constraints.distribute(sum);
            sum.update_ghost_values();
          }
      }

      Values
      operator()(const dealii::types::global_dof_index dof) const
      {
        Values values;
        for (int c = 0; c < n_components; ++c)
          values[c] = sums[c](dof);
        return values;
      }

    private:
      const EllipticSpace<dim> &space;
      std::array<PotentialVector, n_components> sums;
      PotentialVector count;
    };

    /** What is known at the nodes of the mesh: potential, its mean gradient, and the medium. */
    template <int dim>
    class NodalFields
    {
    public:
      NodalFields(const PotentialProblem<dim> &problem, const ExternalField<dim> &sources)
        : space(*problem.solution().space)
        , material(problem.material())
        , samples(problem.material_samples())
        , sources(sources)
        , lexicographic(
            dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(potential_degree))
        , potential(space.with_ghosts(problem.solution().potential))
        , self_field(space)
        , medium(space)
      {
        for (const auto &cell : space.dof_handler.active_cell_iterators())
          if (cell->is_locally_owned())
            {
              add_self_field(dofs_of(cell), cell->extent_in_direction(0));
              add_medium(dofs_of(cell),
                         space.lattice_cell_of_active_cell[cell->active_cell_index()]);
            }
        self_field.finish();
        medium.finish();
      }

      using Dofs = std::array<dealii::types::global_dof_index, n_cell_nodes<dim>>;

      /** Degrees of freedom of a cell, lexicographic. */
      template <typename Cell>
      Dofs
      dofs_of(const Cell &cell) const
      {
        std::vector<dealii::types::global_dof_index> hierarchic(n_cell_nodes<dim>);
        cell->get_dof_indices(hierarchic);
        Dofs dofs;
        for (int i = 0; i < n_cell_nodes<dim>; ++i)
          dofs[i] = hierarchic[lexicographic[i]];
        return dofs;
      }

      FieldValues<dim>
      operator()(const dealii::types::global_dof_index dof, const Vector<dim> &position) const
      {
        FieldValues<dim> values;
        values.potential = potential(dof);
        std::copy_n(self_field(dof).data(), dim, values.self_field.values);
        values.field = values.self_field + sources.field(position);

        const auto of_medium = medium(dof);
        std::copy_n(of_medium.data(), dim, values.magnetization.values);
        values.number_density           = of_medium[dim];
        values.magnetization_of_magnets = sources.magnetization(position);
        return values;
      }

    private:
      const EllipticSpace<dim> &space;
      const MaterialPoints<dim> &material;
      const std::vector<MaterialSample<dim>> samples;
      const ExternalField<dim> &sources;
      const std::vector<unsigned int> lexicographic;

      PotentialVector potential;
      NodalMean<dim, dim> self_field;
      NodalMean<dim, dim + 1> medium; ///< M and the density of grains

      void
      add_self_field(const Dofs &dofs, const double edge)
      {
        std::array<double, n_cell_nodes<dim>> values;
        for (int i = 0; i < n_cell_nodes<dim>; ++i)
          values[i] = potential(dofs[i]);
        for (int node = 0; node < n_cell_nodes<dim>; ++node)
          {
            // Along an axis only the functions of the nodes on this line are not zero.
            std::array<double, dim> h = {};
            for (int axis = 0; axis < dim; ++axis)
              for (int k = 0; k < 3; ++k)
                h[axis] -= derivative_1d[place(node, axis)][k] / edge *
                           values[node + (k - place(node, axis)) * power(3, axis)];
            self_field.add(dofs[node], h);
          }
      }

      /** Each node of a cell takes the mean over the octants that it touches. */
      void
      add_medium(const Dofs &dofs, const unsigned int lattice_cell)
      {
        const unsigned int first = lattice_cell == invalid_entry
                                     ? material.none
                                     : material.first_point(lattice_cell);
        for (int node = 0; node < n_cell_nodes<dim>; ++node)
          {
            std::array<double, dim + 1> values = {};
            if (first != material.none)
              {
                int n_touched = 0;
                for (int octant = 0; octant < n_octants<dim>; ++octant)
                  if (touches<dim>(node, octant))
                    {
                      const MaterialSample<dim> &sample = samples[first + octant];
                      for (int d = 0; d < dim; ++d)
                        values[d] += sample.magnetization[d];
                      values[dim] += sample.number_density;
                      ++n_touched;
                    }
                for (double &value : values)
                  value /= n_touched;
              }
            medium.add(dofs[node], values);
          }
      }
    };

    /** The 2^dim parts of a cell, with its nodes (lexicographic) as corners in the order of VTK. */
    template <int dim>
    std::array<std::array<int, power(2, dim)>, power(2, dim)>
    parts_of_cell()
    {
      constexpr int corners[8] = {0, 1, 3, 2, 4, 5, 7, 6}; // around the lower face, then the upper
      std::array<std::array<int, power(2, dim)>, power(2, dim)> parts = {};
      for (int part = 0; part < power(2, dim); ++part)
        for (int c = 0; c < power(2, dim); ++c)
          for (int d = 0; d < dim; ++d)
            parts[part][c] += power(3, d) * (((part >> d) & 1) + ((corners[c] >> d) & 1));
      return parts;
    }

    /** The mesh of this rank, each cell cut in 2^dim, whose points are the nodes of FE_Q(2). */
    template <int dim>
    class NodeGrid
    {
    public:
      explicit NodeGrid(const NodalFields<dim> &fields, const EllipticSpace<dim> &space);

      /** Points and cells. */
      VtuPiece piece;

      /** What is known at the points. */
      std::vector<FieldValues<dim>> values;

    private:
      const NodalFields<dim> &fields;
      const dealii::IndexSet &relevant_dofs;
      std::vector<int> points; ///< number of the point, by relevant degree of freedom, or -1

      int
      point(const dealii::types::global_dof_index dof, const Vector<dim> &position);
    };

    template <int dim>
    NodeGrid<dim>::NodeGrid(const NodalFields<dim> &fields, const EllipticSpace<dim> &space)
      : fields(fields)
      , relevant_dofs(space.relevant_dofs)
      , points(space.relevant_dofs.n_elements(), -1)
    {
      constexpr int quadrilateral = 9, hexahedron = 12; // VTK's numbers
      piece.points_per_cell = power(2, dim);
      piece.cell_type       = (dim == 2 ? quadrilateral : hexahedron);
      const auto parts      = parts_of_cell<dim>();
      for (const auto &cell : space.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const auto dofs        = fields.dofs_of(cell);
            const double half_edge = 0.5 * cell->extent_in_direction(0);
            std::array<int, n_cell_nodes<dim>> nodes;
            for (int node = 0; node < n_cell_nodes<dim>; ++node)
              {
                Vector<dim> position;
                for (int d = 0; d < dim; ++d)
                  position[d] = cell->vertex(0)[d] + half_edge * place(node, d);
                nodes[node] = point(dofs[node], position);
              }
            for (const auto &part : parts)
              for (const int node : part)
                piece.cells.push_back(nodes[node]);
          }
    }

    template <int dim>
    int
    NodeGrid<dim>::point(const dealii::types::global_dof_index dof, const Vector<dim> &position)
    {
      int &number = points[relevant_dofs.index_within_set(dof)];
      if (number < 0)
        {
          number = static_cast<int>(values.size());
          values.push_back(fields(dof, position));
          for (int d = 0; d < 3; ++d)
            piece.points.push_back(d < dim ? static_cast<float>(position[d]) : 0.f);
        }
      return number;
    }
  } // namespace

  template <int dim>
  FieldOutput<dim>::FieldOutput(const MPI_Comm communicator,
                                const std::string &directory,
                                const std::vector<std::string> &quantities)
    : communicator(communicator)
    , quantities(chosen_quantities(field_quantities<dim>(), quantities, "field"))
    , series(communicator, directory, field_frames)
  {
    series.make_folder();
  }

  template <int dim>
  void
  FieldOutput<dim>::write_frame(const unsigned int frame,
                                const double time,
                                const PotentialProblem<dim> &potential,
                                const ExternalField<dim> &sources)
  {
    const NodalFields<dim> fields(potential, sources);
    NodeGrid<dim> grid(fields, *potential.solution().space);
    const auto for_each_node = [&](const auto &action) {
      for (const FieldValues<dim> &values : grid.values)
        action(values);
    };
    for (const FieldQuantity<dim> &quantity : quantities)
      grid.piece.quantities.push_back(written_values(quantity, grid.values.size(), for_each_node));
    const std::string file =
      write_vtu(communicator, series.folder(), series.name(), {frame, time}, grid.piece);
    series.add(time, file);
  }

  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace magmpm
