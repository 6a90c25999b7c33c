#include <magmpm/lattice/node_window.h>
#include <magmpm/mesh/node_filters.h>
#include <magmpm/surface/sharp_indicator.h>
#include <magmpm/surface/sharp_profile.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    constexpr double lowest_correction  = 0.5;
    constexpr double highest_correction = 5.;

    /** Nodes that hold less than this of their cell get no correction: f falls off faster than v. */
    constexpr double negligible_volume = 1e-9;

    /** A clipped correction counts where a node holds more than this of its cell. */
    constexpr double counted_volume = 1e-3;

    /** W and A. */
    struct TestedAndScattered
    {
      static constexpr NodeScalar<TestedAndScattered> tested    = {0};
      static constexpr NodeScalar<TestedAndScattered> scattered = {1};

      template <typename Function>
      static constexpr void
      for_each(Function &&f)
      {
        f(tested);
        f(scattered);
      }
    };

    /**
     * Where f has too much volume, as in thin sheets, it gives up what q takes from the density, which the
     * moment across a sheet hardly depends on: all of it where f is small, nothing where f = 1. Drops have
     * too little; their f, small as it is, is better left.
     */
    void
    move_correction_to_fraction(double &fraction, double &correction)
    {
      const double square = fraction * fraction;
      const double ratio  = 1. + (1. - square * square) * (std::min(correction, 1.) - 1.);
      fraction *= ratio;
      correction /= ratio;
    }

    /** S. */
    template <int dim>
    void
    smooth_thrice(const BlockPartition<dim> &partition, NodeNumbers<dim> &field)
    {
      for (int pass = 0; pass < 3; ++pass)
        smooth(partition, field);
    }
  } // namespace

  template <int dim>
  void
  SharpIndicator<dim>::reinit(const BlockPartition<dim> &partition,
                              const LatticeCells<dim> &cells,
                              const NodeField<dim, SingleScalar> &volumes,
                              const Check &check)
  {
    const Rule rule = cells.template quadrature<2 * n_octants_1d>();
    sharp.reinit(partition, volumes);

    octants.clear();
    fractions.clear();
    first_octant_of_cell.assign(cells.size(), none);
    NodeField<dim, SingleScalar> field(partition.blocks().size()); // int f N_i, then q
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      if (cells.is_active(cell))
        add_cell(cells, rule, cell, check, field);
    find_correction(partition, volumes, field);
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      if (first_octant_of_cell[cell] != none)
        {
          correct_octants(cells, rule, cell, field);
          find_normals(cells, rule, cell);
        }
  }

  template <int dim>
  bool
  SharpIndicator<dim>::find_fractions(const LatticeCells<dim> &cells,
                                      const Rule &rule,
                                      const unsigned int cell,
                                      const Check &check,
                                      PointFractions &f) const
  {
    using Nodes = typename SharpFraction<dim>::Nodes;
    StencilValues<dim> nodes;
    cells.gather(sharp.field(), cell, nodes);
    bool has_volume = false;
    for (int i = 0; i < n_stencil_nodes<dim> && !has_volume; ++i)
      has_volume = nodes.get(Nodes::volume, i) > 0.;
    if (!has_volume)
      return false;

    typename Rule::Values values;
    rule.interpolate(nodes, values);
    bool has_material = false;
    for (int q = 0; q < rule.size(); ++q)
      {
        f[q] = sharp_fraction(values.get(Nodes::volume, q), values.get(Nodes::full, q));
        if (f[q] > 0.)
          check(cells.position(cell) + rule.offset(q));
        has_material = has_material || f[q] > 0.;
      }
    return has_material;
  }

  template <int dim>
  void
  SharpIndicator<dim>::add_cell(const LatticeCells<dim> &cells,
                                const Rule &rule,
                                const unsigned int cell,
                                const Check &check,
                                NodeField<dim, SingleScalar> &tested_fraction)
  {
    PointFractions f;
    if (!find_fractions(cells, rule, cell, check, f))
      return;

    std::array<Octant, n_octants<dim>> here;
    std::array<Vector<dim>, n_octants<dim>> moments = {}, middles = {};
    for (int q = 0; q < rule.size(); ++q)
      {
        const int octant = octant_of_point<dim>(q);
        here[octant].fraction += f[q] / n_octants<dim>;
        moments[octant] += (f[q] / n_octants<dim>)*rule.offset(q);
        middles[octant] += (1. / n_octants<dim>)*rule.offset(q);
      }
    const auto points = cells.template quadrature<n_octants_1d>();
    for (int octant = 0; octant < n_octants<dim>; ++octant)
      if (here[octant].fraction > 0.)
        {
          const Vector<dim> centroid = (1. / here[octant].fraction) * moments[octant];
          here[octant].position      = cells.position(cell) + points.offset(octant) + centroid -
                                  middles[octant];
        }
    first_octant_of_cell[cell] = static_cast<unsigned int>(octants.size());
    octants.insert(octants.end(), here.begin(), here.end());
    fractions.push_back(f);

    const double per_volume      = 1. / std::pow(cells.spacing(), dim);
    typename Rule::Values values = {};
    StencilValues<dim> nodes     = {};
    for (int q = 0; q < rule.size(); ++q)
      values.set(SingleScalar::value, q, f[q] * rule.weight(q) * per_volume);
    rule.add_tested(values, nodes);
    cells.scatter_add(nodes, cell, tested_fraction);
  }

  template <int dim>
  void
  SharpIndicator<dim>::find_correction(const BlockPartition<dim> &partition,
                                       const NodeField<dim, SingleScalar> &volumes,
                                       NodeField<dim, SingleScalar> &field)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    partition.add_ghosts_to_owners(field, Parity());
    partition.update_ghosts(field);

    using Both = TestedAndScattered;
    NodeField<dim, Both> both(blocks.size());
    for_nodes_and_ghosts(blocks, [&](const int slot, const int node) {
      both.set(Both::tested, slot, node, field.get(SingleScalar::value, slot, node));
      both.set(Both::scattered, slot, node, volumes.get(SingleScalar::value, slot, node));
    });
    smooth_thrice(partition, both);

    clipped_corrections = 0;
    for_nodes_and_ghosts(blocks, [&](const int slot, const int node) {
      const double tested    = both.get(Both::tested, slot, node);
      const double scattered = both.get(Both::scattered, slot, node);
      const double ratio     = (tested > negligible_volume ? scattered / tested : 1.);
      const double clipped   = std::clamp(ratio, lowest_correction, highest_correction);
      clipped_corrections += slot < blocks.n_owned() && scattered > counted_volume &&
                             ratio != clipped;
      field.set(SingleScalar::value, slot, node, clipped);
    });
    smooth_thrice(partition, field);
  }

  template <int dim>
  void
  SharpIndicator<dim>::correct_octants(const LatticeCells<dim> &cells,
                                       const Rule &rule,
                                       const unsigned int cell,
                                       const NodeField<dim, SingleScalar> &correction)
  {
    Octant *here            = &octants[first_octant_of_cell[cell]];
    const PointFractions &f = fractions[first_octant_of_cell[cell] / n_octants<dim>];
    StencilValues<dim> nodes;
    typename Rule::Values values;
    cells.gather(correction, cell, nodes);
    rule.interpolate(nodes, values);

    std::array<double, n_octants<dim>> volumes = {};
    for (int q = 0; q < rule.size(); ++q)
      volumes[octant_of_point<dim>(q)] += f[q] * values.get(SingleScalar::value, q) /
                                          n_octants<dim>;
    for (int octant = 0; octant < n_octants<dim>; ++octant)
      if (here[octant].fraction > 0.)
        {
          here[octant].correction = volumes[octant] / here[octant].fraction;
          move_correction_to_fraction(here[octant].fraction, here[octant].correction);
        }
  }

  template <int dim>
  void
  SharpIndicator<dim>::find_normals(const LatticeCells<dim> &cells,
                                    const Rule &rule,
                                    const unsigned int cell)
  {
    // Where all is full, or empty, no normal is asked for.
    Octant *here = &octants[first_octant_of_cell[cell]];
    if (std::none_of(here, here + n_octants<dim>, [](const Octant &octant) {
          return octant.fraction > 0. && octant.fraction < 1.;
        }))
      return;

    StencilValues<dim> nodes;
    std::array<typename Rule::Values, dim> derivatives;
    cells.gather(sharp.field(), cell, nodes);
    for (int d = 0; d < dim; ++d)
      rule.interpolate_derivative(nodes, d, derivatives[d]);
    std::array<Matrix<dim>, n_octants<dim>> squares = {};
    for (int q = 0; q < rule.size(); ++q)
      {
        Vector<dim> gradient;
        for (int d = 0; d < dim; ++d)
          gradient[d] = derivatives[d].get(SharpFraction<dim>::Nodes::volume, q);
        squares[octant_of_point<dim>(q)] += (1. / n_octants<dim>)*outer(gradient, gradient);
      }
    for (int octant = 0; octant < n_octants<dim>; ++octant)
      here[octant].normal = SharpFraction<dim>::normal(squares[octant]);
  }

  template class SharpIndicator<2>;
  template class SharpIndicator<3>;
} // namespace magmpm
