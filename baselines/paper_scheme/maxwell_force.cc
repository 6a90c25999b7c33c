#include <magmpm/base/constants.h>

#include <baselines/paper_scheme/maxwell_force.h>

#include <algorithm>
#include <array>

namespace magmpm::paper_scheme
{
  namespace
  {
    /** The nodes with material and two layers around them. */
    template <int dim>
    struct Surroundings
    {
      Index<dim> lowest;
      NodeGrid<dim> box;

      Index<dim>
      local(Index<dim> node) const
      {
        for (int a = 0; a < dim; ++a)
          node[a] -= lowest[a];
        return node;
      }
    };

    template <int dim>
    Surroundings<dim>
    find_surroundings(const NodeGrid<dim> &grid, const std::vector<MaterialNode<dim>> &nodes)
    {
      Index<dim> low = nodes.front().node, high = low, extent;
      for (const MaterialNode<dim> &node : nodes)
        for (int a = 0; a < dim; ++a)
          {
            low[a]  = std::min(low[a], node.node[a]);
            high[a] = std::max(high[a], node.node[a]);
          }
      for (int a = 0; a < dim; ++a)
        {
          low[a] -= 2;
          extent[a] = high[a] + 3 - low[a];
        }
      return {low, NodeGrid<dim>(grid.node_position(low), extent, grid.spacing)};
    }

    /** H B - mu_0/2 |H|^2 I [Pa]. */
    template <int dim>
    Matrix<dim>
    maxwell_stress(const Vector<dim> &field, const Vector<dim> &magnetization)
    {
      return constants::vacuum_permeability *
             (outer(field, field + magnetization) + (-0.5 * norm_square(field)) * identity<dim>());
    }

    /** On the reached nodes and their neighbours along the axes; zero elsewhere. */
    template <int dim>
    std::vector<Matrix<dim>>
    compute_stress(const NodeGrid<dim> &grid,
                   const Surroundings<dim> &around,
                   const NodeVector &phi,
                   const std::vector<MaterialNode<dim>> &nodes,
                   const MagnetizationLaw law,
                   const ExternalField<dim> &sources)
    {
      std::vector<Matrix<dim>> stress(around.box.size());
      std::vector<char> is_known(around.box.size(), false);
      for (const MaterialNode<dim> &node : nodes)
        {
          const std::ptrdiff_t i = around.box.number(around.local(node.node));
          stress[i] = maxwell_stress(node.field(), magnetization(law, node.content, node.field()));
          is_known[i] = true;
        }
      for (const MaterialNode<dim> &node : nodes)
        for (int a = 0; a < dim; ++a)
          for (const int side : {-1, 1})
            {
              Index<dim> neighbour = node.node;
              neighbour[a] += side;
              const std::ptrdiff_t i = around.box.number(around.local(neighbour));
              if (is_known[i])
                continue;
              const Vector<dim> field = sources.field(grid.node_position(neighbour)) -
                                        central_difference<dim>(grid, phi, neighbour);
              stress[i]   = maxwell_stress<dim>(field, {});
              is_known[i] = true;
            }
      return stress;
    }

    /** R_ij of the nodes around @p i. */
    template <int dim>
    Vector<dim>
    restricted(const NodeGrid<dim> &box,
               const std::vector<Vector<dim>> &values,
               const std::ptrdiff_t i)
    {
      constexpr double weights[3] = {1. / 6., 2. / 3., 1. / 6.};
      Vector<dim> sum;
      for (int k = 0; k < power(3, dim); ++k)
        {
          double weight    = 1.;
          std::ptrdiff_t j = i;
          for (int a = 0, rest = k; a < dim; ++a, rest /= 3)
            {
              weight *= weights[rest % 3];
              j += (rest % 3 - 1) * box.stride(a);
            }
          sum += weight * values[j];
        }
      return sum;
    }
  } // namespace

  template <int dim>
  std::vector<Vector<dim>>
  maxwell_forces(const NodeGrid<dim> &grid,
                 const NodeVector &phi,
                 const std::vector<MaterialNode<dim>> &nodes,
                 const MagnetizationLaw law,
                 const ExternalField<dim> &sources,
                 const ForceRegion region)
  {
    if (nodes.empty())
      return {};
    const Surroundings<dim> around         = find_surroundings(grid, nodes);
    const NodeGrid<dim> &box               = around.box;
    const std::vector<Matrix<dim>> &stress = compute_stress(grid, around, phi, nodes, law, sources);

    const double factor = std::pow(grid.spacing, dim) / (2. * grid.spacing);
    std::vector<Vector<dim>> divergence(box.size());
    for (const MaterialNode<dim> &node : nodes)
      {
        if (region == ForceRegion::full_cells && !node.has_particle)
          continue;
        const std::ptrdiff_t i = box.number(around.local(node.node));
        for (int a = 0; a < dim; ++a)
          for (int b = 0; b < dim; ++b)
            divergence[i][a] += factor *
                                (stress[i + box.stride(b)](a, b) - stress[i - box.stride(b)](a, b));
      }

    std::vector<Vector<dim>> forces;
    for (const MaterialNode<dim> &node : nodes)
      forces.push_back(restricted(box, divergence, box.number(around.local(node.node))));
    return forces;
  }

  template <int dim>
  Vector<dim>
  total_force(const std::vector<Vector<dim>> &forces)
  {
    Vector<dim> sum;
    for (const Vector<dim> &force : forces)
      sum += force;
    return sum;
  }

  template <int dim>
  Matrix<dim>
  virial(const std::vector<MaterialNode<dim>> &nodes,
         const std::vector<Vector<dim>> &forces,
         const Vector<dim> &centre)
  {
    Matrix<dim> sum;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      sum += outer(forces[i], nodes[i].position - centre);
    return sum;
  }

  template <int dim>
  Vector<n_axial_components<dim>>
  torque(const std::vector<MaterialNode<dim>> &nodes,
         const std::vector<Vector<dim>> &forces,
         const Vector<dim> &centre)
  {
    Vector<n_axial_components<dim>> sum;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      sum += cross(nodes[i].position - centre, forces[i]);
    return sum;
  }

#define MAGMPM_INSTANTIATE(dim)                                                            \
  template std::vector<Vector<dim>> maxwell_forces(const NodeGrid<dim> &,                  \
                                                   const NodeVector &,                     \
                                                   const std::vector<MaterialNode<dim>> &, \
                                                   const MagnetizationLaw,                 \
                                                   const ExternalField<dim> &,             \
                                                   const ForceRegion);                     \
  template Vector<dim> total_force(const std::vector<Vector<dim>> &);                      \
  template Matrix<dim> virial(const std::vector<MaterialNode<dim>> &,                      \
                              const std::vector<Vector<dim>> &,                            \
                              const Vector<dim> &);                                        \
  template Vector<n_axial_components<dim>> torque(const std::vector<MaterialNode<dim>> &,  \
                                                  const std::vector<Vector<dim>> &,        \
                                                  const Vector<dim> &);
  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
#undef MAGMPM_INSTANTIATE
} // namespace magmpm::paper_scheme
