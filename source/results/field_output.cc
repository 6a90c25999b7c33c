#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/results/field_output.h>
#include <magmpm/results/vtu_file.h>
#include <magmpm/magnetics/material_points.h>
#include <magmpm/elliptic/potential_space.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <filesystem>

namespace magmpm
{
  namespace
  {
    const std::string subfolder = "fields";

    template <int dim>
    constexpr int n_cell_nodes = power(potential_degree + 1, dim);

    /** The fields at one node. */
    template <int dim>
    struct NodeValues
    {
      double potential;
      double number_density;
      Vector<dim> self_field, field, magnetization;
      Vector<dim> magnetization_of_magnets;
    };

    struct Quantity
    {
      std::string name, unit;
      bool is_vector;
    };

    const std::vector<Quantity> &
    all_quantities()
    {
      static const std::vector<Quantity> list = {{"potential", "A", false},
                                                 {"H_int", "A/m", true},
                                                 {"H", "A/m", true},
                                                 {"M", "A/m", true},
                                                 {"B", "T", true},
                                                 {"number_density", "1/m^3", false}};
      return list;
    }

    /** One quantity at all nodes, in single precision; vectors get a third component in 2D. */
    template <int dim>
    VtuQuantity
    written_quantity(const Quantity &quantity, const std::vector<NodeValues<dim>> &nodes)
    {
      VtuQuantity written = {
        quantity.name + " [" + quantity.unit + "]", quantity.is_vector ? 3 : 1, {}};
      written.values.assign(written.n_components * nodes.size(), 0.f);
      const auto scalars = [&](const auto &value) {
        for (std::size_t i = 0; i < nodes.size(); ++i)
          written.values[i] = static_cast<float>(value(nodes[i]));
      };
      const auto vectors = [&](const auto &value) {
        for (std::size_t i = 0; i < nodes.size(); ++i)
          {
            const Vector<dim> vector = value(nodes[i]);
            for (int d = 0; d < dim; ++d)
              written.values[3 * i + d] = static_cast<float>(vector[d]);
          }
      };
      using Node = NodeValues<dim>;
      if (quantity.name == "potential")
        scalars([](const Node &at) { return at.potential; });
      else if (quantity.name == "H_int")
        vectors([](const Node &at) { return at.self_field; });
      else if (quantity.name == "H")
        vectors([](const Node &at) { return at.field; });
      else if (quantity.name == "M")
        vectors([](const Node &at) { return at.magnetization; });
      else if (quantity.name == "B")
        vectors([](const Node &at) {
          return constants::vacuum_permeability *
                 (at.field + at.magnetization + at.magnetization_of_magnets);
        });
      else if (quantity.name == "number_density")
        scalars([](const Node &at) { return at.number_density; });
      return written;
    }

    /** Derivatives of the shape functions of FE_Q(2) at its nodes on [0, 1]: (node, function). */
    constexpr double derivative_1d[3][3] = {{-3., 4., -1.}, {-1., 0., 1.}, {1., -4., 3.}};

    int
    place(const int node, const int axis)
    {
      return node / power(3, axis) % 3;
    }

    /** Means over the cells around a node, continuous also at hanging nodes. */
    template <int dim, int n_components>
    class NodalMean
    {
    public:
      using Values = std::array<double, n_components>;

      explicit NodalMean(const PotentialSpace<dim> &space)
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
      const PotentialSpace<dim> &space;
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

      NodeValues<dim>
      operator()(const dealii::types::global_dof_index dof, const Vector<dim> &position) const
      {
        NodeValues<dim> values;
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
      const PotentialSpace<dim> &space;
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

      /**
       * Each node of a cell takes the quadrature point next to it: those of all cells around lie
       * symmetrically about it.
       */
      void
      add_medium(const Dofs &dofs, const unsigned int lattice_cell)
      {
        static_assert(n_points<dim> == n_cell_nodes<dim>);
        const unsigned int first = lattice_cell == invalid_entry
                                     ? material.none
                                     : material.first_point(lattice_cell);
        for (int node = 0; node < n_cell_nodes<dim>; ++node)
          {
            std::array<double, dim + 1> values = {};
            if (first != material.none)
              {
                const MaterialSample<dim> &sample = samples[first + node];
                std::copy_n(sample.magnetization.values, dim, values.begin());
                values[dim] = sample.number_density;
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
      explicit NodeGrid(const NodalFields<dim> &fields, const PotentialSpace<dim> &space);

      /** Points and cells. */
      VtuPiece piece;

      /** What is known at the points. */
      std::vector<NodeValues<dim>> values;

    private:
      const NodalFields<dim> &fields;
      const dealii::IndexSet &relevant_dofs;
      std::vector<int> points; ///< number of the point, by relevant degree of freedom, or -1

      int
      point(const dealii::types::global_dof_index dof, const Vector<dim> &position);
    };

    template <int dim>
    NodeGrid<dim>::NodeGrid(const NodalFields<dim> &fields, const PotentialSpace<dim> &space)
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
  const std::vector<std::string> &
  FieldOutput<dim>::quantity_names()
  {
    static const std::vector<std::string> names = [] {
      std::vector<std::string> list;
      for (const Quantity &quantity : all_quantities())
        list.push_back(quantity.name);
      return list;
    }();
    return names;
  }

  template <int dim>
  FieldOutput<dim>::FieldOutput(const MPI_Comm communicator,
                                const std::string &directory,
                                const std::vector<std::string> &quantities)
    : communicator(communicator)
    , directory(directory)
    , quantities(quantities)
    , record(directory + "/" + subfolder + ".pvd")
  {
    std::string allowed;
    for (const std::string &name : quantity_names())
      allowed += (allowed.empty() ? "" : ", ") + name;
    for (const std::string &name : quantities)
      if (std::count(quantity_names().begin(), quantity_names().end(), name) == 0)
        throw InputError("The field quantity '" + name + "' is unknown. Allowed are: " + allowed +
                         ".");

    // All ranks learn of a failure: one that threw alone would leave the others waiting.
    const std::filesystem::path folder = std::filesystem::path(directory) / subfolder;
    int is_made                        = 1;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        is_made = !error;
      }
    if (dealii::Utilities::MPI::min(is_made, communicator) == 0)
      throw RunError("The folder '" + folder.string() +
                     "' for the fields cannot be made. Are you allowed to write there?");
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
    for (const Quantity &quantity : all_quantities())
      if (std::count(quantities.begin(), quantities.end(), quantity.name) > 0)
        grid.piece.quantities.push_back(written_quantity(quantity, grid.values));

    const std::string file =
      write_vtu(communicator, directory + "/" + subfolder, subfolder, {frame, time}, grid.piece);
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      record.add(time, subfolder + "/" + file);
  }

  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace magmpm
