// Kernels, as particle_grid_transfer.cc.

#include <magmpm/particles/quantity_transfer.h>
#include <magmpm/particles/surface_content.h>

#include <cmath>

namespace magmpm
{
  template <int dim>
  void
  surface_content_to_lattice(std::vector<Body<dim>> &bodies,
                             const BlockSet<dim> &blocks,
                             const Lattice<dim> &lattice,
                             NodeField<dim, SurfaceContent> &content)
  {
    const double per_cell = 1. / std::pow(lattice.spacing, dim);
    scatter(
      bodies,
      blocks,
      lattice,
      [](const Body<dim> &) { return true; },
      [per_cell](const Body<dim> &body, const auto &) {
        const double tension = body.surface_tension;
        const double fluid   = (is_fluid(body) ? 1. : 0.);
        return [per_cell, tension, fluid, particles = body.particles.arrays()](const auto place,
                                                                               auto &lanes) {
          const SimdDouble volume             = per_cell * load(particles.volume, place);
          lanes[SurfaceContent::volume.lane]  = volume;
          lanes[SurfaceContent::tension.lane] = tension * volume;
          lanes[SurfaceContent::square.lane]  = tension * tension * volume;
          lanes[SurfaceContent::fluid.lane]   = fluid * volume;
        };
      },
      content);
  }

#define INSTANTIATE(dim)                                             \
  template void surface_content_to_lattice(std::vector<Body<dim>> &, \
                                           const BlockSet<dim> &,    \
                                           const Lattice<dim> &,     \
                                           NodeField<dim, SurfaceContent> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
