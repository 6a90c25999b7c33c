#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>

#include <magmpm/elliptic/elliptic_space.h>
#include <magmpm/lattice/cell_quadrature.h>

namespace magmpm
{
  template <int dim, typename Number>
  std::shared_ptr<const CellBatches<dim, Number>>
  make_cell_batches(const dealii::Mapping<dim> &mapping,
                    const dealii::DoFHandler<dim> &dof_handler,
                    const dealii::AffineConstraints<double> &constraints,
                    const unsigned int level)
  {
    typename CellBatches<dim, Number>::AdditionalData data;
    data.tasks_parallel_scheme = CellBatches<dim, Number>::AdditionalData::none;
    data.mapping_update_flags  = dealii::update_gradients | dealii::update_JxW_values;
    data.mg_level              = level;
    auto cells                 = std::make_shared<CellBatches<dim, Number>>();
    // As lists: of one space, several rules would be alternatives.
    const std::vector<const dealii::DoFHandler<dim> *> spaces               = {&dof_handler};
    const std::vector<const dealii::AffineConstraints<double> *> conditions = {&constraints};
    const std::vector<dealii::QGauss<1>> rules = {dealii::QGauss<1>(n_points_1d),
                                                  dealii::QGauss<1>(n_octants_1d)};
    cells->reinit(mapping, spaces, conditions, rules, data);
    return cells;
  }

  template <int dim>
  EllipticSpace<dim>::EllipticSpace(const BackgroundMesh<dim> &mesh, const bool with_levels)
    : mesh(mesh)
    , fe(potential_degree)
    , dof_handler(mesh.triangulation())
  {
    dof_handler.distribute_dofs(fe);
    if (with_levels)
      dof_handler.distribute_mg_dofs();
    dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, relevant_dofs);
    constraints.reinit(relevant_dofs);
    dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
    constraints.close();

    matrix_free = make_cell_batches<dim, double>(
      mapping, dof_handler, constraints, dealii::numbers::invalid_unsigned_int);
    find_lattice_cells();
  }

  template <int dim>
  void
  EllipticSpace<dim>::find_lattice_cells()
  {
    const Lattice<dim> &lattice = mesh.lattice();
    const auto &triangulation   = mesh.triangulation();
    const double edge           = mesh.parameters().cell_edge * lattice.spacing;

    lattice_cell_of_active_cell.assign(triangulation.n_active_cells(), invalid_entry);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && std::abs(cell->extent_in_direction(0) - edge) < 0.1 * edge)
        {
          Vector<dim> corner;
          for (int d = 0; d < dim; ++d)
            corner[d] = cell->vertex(0)[d];
          lattice_cell_of_active_cell[cell->active_cell_index()] = lattice_cells.size();
          lattice_cells.push_back(lattice.nearest_node(corner));
        }

    const unsigned int n_lanes = CellLanes<double>::size();
    lattice_cell_of_lane.assign(matrix_free->n_cell_batches() * n_lanes, invalid_entry);
    for (unsigned int batch = 0; batch < matrix_free->n_cell_batches(); ++batch)
      for (unsigned int lane = 0; lane < matrix_free->n_active_entries_per_cell_batch(batch);
           ++lane)
        lattice_cell_of_lane[batch * n_lanes + lane] =
          lattice_cell_of_active_cell[matrix_free->get_cell_iterator(batch, lane)
                                        ->active_cell_index()];

    // Every rank knows the coarse mesh, and it fills the box.
    bool first = true;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      {
        const auto lower = cell->vertex(0);
        const auto upper = cell->vertex(dealii::GeometryInfo<dim>::vertices_per_cell - 1);
        for (int d = 0; d < dim; ++d)
          {
            lower_corner[d] = first ? lower[d] : std::min(lower_corner[d], lower[d]);
            upper_corner[d] = first ? upper[d] : std::max(upper_corner[d], upper[d]);
          }
        first = false;
      }
  }

  template <int dim>
  PotentialVector
  EllipticSpace<dim>::make_vector() const
  {
    PotentialVector vector;
    matrix_free->initialize_dof_vector(vector);
    return vector;
  }

  template <int dim>
  PotentialVector
  EllipticSpace<dim>::with_ghosts(const PotentialVector &potential) const
  {
    PotentialVector copy(
      dof_handler.locally_owned_dofs(), relevant_dofs, mesh.triangulation().get_communicator());
    copy.copy_locally_owned_data_from(potential);
    constraints.distribute(copy);
    copy.update_ghost_values();
    return copy;
  }

#define INSTANTIATE_BATCHES(dim, Number)                                                   \
  template std::shared_ptr<const CellBatches<dim, Number>> make_cell_batches<dim, Number>( \
    const dealii::Mapping<dim> &,                                                          \
    const dealii::DoFHandler<dim> &,                                                       \
    const dealii::AffineConstraints<double> &,                                             \
    const unsigned int);

#define INSTANTIATE(dim)             \
  template class EllipticSpace<dim>; \
  INSTANTIATE_BATCHES(dim, double)   \
  INSTANTIATE_BATCHES(dim, float)

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
#undef INSTANTIATE_BATCHES
} // namespace magmpm
