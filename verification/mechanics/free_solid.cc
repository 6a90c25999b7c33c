
#include <magmpm/boundary/momentum_update.h>
#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/materials/parameter_conversion.h>
#include <magmpm/particles/make_material.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_state.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/particles/seeding.h>
#include <magmpm/particles/velocity_filter.h>

#include <verification/mechanics/free_solid.h>
#include <verification/particles/random_bodies.h>

#include <algorithm>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    template <int dim>
    Body<dim>
    make_body(const FreeSolidParameters<dim> &parameters, const Lattice<dim> &lattice)
    {
      BodyParameters<dim> body;
      body.name               = "solid";
      body.density            = parameters.density;
      body.shape.lower_corner = parameters.lower_corner;
      body.shape.upper_corner = parameters.upper_corner;
      MaterialParameters material;
      const LameModuli moduli = lame_moduli(parameters.youngs_modulus, parameters.poisson_ratio);
      material.shear_modulus  = moduli.shear_modulus;
      material.lame_lambda    = moduli.lame_lambda;
      material.transfer       = parameters.transfer;
      Body<dim> result(body, material);
      seed_particles(body, lattice, 0, 0, 1, result);
      return result;
    }
  } // namespace

  template <int dim>
  FreeSolid<dim>::FreeSolid(const FreeSolidParameters<dim> &parameters)
    : parameters(parameters)
  {
    lattice.spacing = parameters.spacing;
    for (int d = 0; d < dim; ++d)
      lattice.n_cells[d] = 1 << 20; // without boundaries
    bodies.push_back(make_body(parameters, lattice));
    ParticleSet<dim> &particles = bodies[0].particles;
    for (std::size_t p = 0; p < particles.size(); ++p)
      {
        particles.ids()[p] = p;
        starts.push_back(particles.position(p));
        for (int d = 0; d < dim; ++d)
          particles.component(ParticleProperty::velocity, d)[p] = parameters.frame_velocity[d];
      }
    speed_of_sound = undeformed_wave_speed(bodies[0].material);
    sort();
  }

  template <int dim>
  void
  FreeSolid<dim>::sort()
  {
    const bool is_filtered = (parameters.transfer == Transfer::fmpm);
    blocks                 = active_blocks(bodies, lattice);
    sort_all(blocks, lattice, bodies);
    motion.reinit(blocks.size());
    filtered.reinit(is_filtered ? blocks.size() : 0);
    taken.reinit(is_filtered ? blocks.size() : 0);
    strain.reinit(blocks.size());
    way = 0.;
  }

  template <int dim>
  void
  FreeSolid<dim>::smooth_volume()
  {
    for (const SmoothedMaterial &material : smoothed_materials(bodies))
      {
        sum_strain(bodies, material, blocks, lattice, strain);
        divide_by_weight(blocks, strain);
        find_volumetric_stress(strain, material, blocks, lattice, bodies);
      }
  }

  template <int dim>
  void
  FreeSolid<dim>::set_velocity(const std::function<Vector<dim>(const Vector<dim> &)> &velocity,
                               const std::function<Matrix<dim>(const Vector<dim> &)> &gradient)
  {
    ParticleSet<dim> &particles = bodies[0].particles;
    for (std::size_t p = 0; p < particles.size(); ++p)
      {
        const Vector<dim> position = particles.position(p);
        const Vector<dim> v        = velocity(position);
        max_speed                  = std::max(max_speed, norm(v));
        store_vector<dim>(v, particles.arrays().velocity, p);
        store_matrix<dim>(gradient(position), particles.arrays().affine_velocity, p);
      }
  }

  template <int dim>
  void
  FreeSolid<dim>::set_stress(
    const std::function<Matrix<dim>(const Vector<dim> &, const Matrix<dim> &)> &stress)
  {
    stress_from_outside = stress;
  }

  template <int dim>
  void
  FreeSolid<dim>::set_grips(const std::function<Grips(double, double)> &grips)
  {
    grips_at = grips;
  }

  template <int dim>
  void
  FreeSolid<dim>::add_stress(const double time_step)
  {
    for (const Point &point : points())
      {
        const Matrix<dim> impulse = (-time_step * point.volume) *
                                    stress_from_outside(point.start, point.deformation);
        const Index<dim> base = lattice.base_node(point.position);
        const Vector<dim> x   = lattice.reduced(point.position);
        double weights[dim][stencil_width], slopes[dim][stencil_width];
        for (int d = 0; d < dim; ++d)
          {
            quadratic_bspline(x[d] - base[d], weights[d]);
            quadratic_bspline_derivative(x[d] - base[d], slopes[d]);
          }
        for_stencil(lattice, point.position, [&](const Index<dim> &node, const double) {
          Vector<dim> gradient;
          int number = 0;
          for (int d = dim - 1; d >= 0; --d)
            {
              number      = block_edge * number + (node[d] & (block_edge - 1));
              gradient[d] = 1. / lattice.spacing;
              for (int e = 0; e < dim; ++e)
                gradient[d] *= (d == e ? slopes : weights)[e][node[e] - base[e]];
            }
          motion.add(
            NodeMotion::momentum, blocks.slot(block_of<dim>(node)), number, impulse * gradient);
        });
      }
  }

  template <int dim>
  void
  FreeSolid<dim>::divide(const NodeField<dim> &mass, NodeField<dim> &momentum) const
  {
    for_nodes(blocks, [&](const int slot, const int n) {
      const double m = mass.get(NodeMotion::mass, slot, n);
      if (m > 1e-12 * parameters.density * std::pow(lattice.spacing, dim))
        momentum.set(
          NodeMotion::velocity, slot, n, (1. / m) * momentum.get(NodeMotion::momentum, slot, n));
      else
        momentum.set(NodeMotion::velocity, slot, n, Vector<dim>());
    });
  }

  template <int dim>
  typename FreeSolid<dim>::Effect
  FreeSolid<dim>::drive(const Grips &grips, NodeField<dim> &velocity) const
  {
    Effect effect;
    for_nodes(blocks, [&](const int slot, const int n) {
      const double x = lattice.node_position(node_of_block<dim>(blocks.block(slot), n))[0];
      if (x > grips.lower && x < grips.upper)
        return;
      const double side    = (x >= grips.upper ? 1. : -1.);
      Vector<dim> v        = velocity.get(NodeMotion::velocity, slot, n);
      const double mass    = motion.get(NodeMotion::mass, slot, n);
      const double impulse = mass * (side * grips.speed - v[0]);
      v[0]                 = side * grips.speed;
      effect.work += impulse * v[0];
      effect.impulse += side * impulse;
      velocity.set(NodeMotion::velocity, slot, n, v);
    });
    return effect;
  }

  template <int dim>
  void
  FreeSolid<dim>::filter(const double time_step)
  {
    filter_velocity(bodies, {1.}, blocks, lattice, motion, filtered);
    divide(motion, filtered);
    give_back(
      blocks, share_given_back(bodies[0], lattice.spacing, time_step), motion, filtered, taken);
  }

  template <int dim>
  void
  FreeSolid<dim>::step()
  {
    const bool is_filtered = (parameters.transfer == Transfer::fmpm);
    const double dt = parameters.elastic_factor * lattice.spacing / (speed_of_sound + max_speed);
    if (way + max_speed * dt > 0.5 * lattice.spacing)
      sort();
    smooth_volume();
    particles_to_lattice(bodies, blocks, lattice, dt, motion);
    if (stress_from_outside)
      add_stress(dt);
    divide(motion, motion);
    const double remaining = std::exp(-parameters.damping_rate * dt);
    for_nodes(blocks, [&](const int slot, const int n) {
      const Vector<dim> velocity = motion.get(NodeMotion::velocity, slot, n);
      motion.set(NodeMotion::velocity,
                 slot,
                 n,
                 parameters.frame_velocity + remaining * (velocity - parameters.frame_velocity));
    });
    std::vector<Effect> effects;
    const Grips grips = (grips_at ? grips_at(now, dt) : Grips());
    if (grips_at)
      effects.push_back(drive(grips, motion));
    if (is_filtered)
      filter(dt);
    if (grips_at && is_filtered)
      {
        drive(grips, filtered); // moves nothing: P v is not the momentum of anything
        effects.push_back(drive(grips, taken));
      }
    force = 0.;
    for (const Effect &effect : effects)
      {
        work += effect.work;
        force += 0.5 * effect.impulse / dt;
      }
    max_speed =
      lattice_to_particles<dim>({motion, filtered, taken}, blocks, lattice, dt, bodies)[0].speed;
    way += max_speed * dt;
    now += dt;
  }

  template <int dim>
  double
  FreeSolid<dim>::energy()
  {
    smooth_volume();
    const ParticleSums<dim> sums =
      particle_sums(bodies[0], lattice, Vector<dim>(), MagnetizationLaw::linear);
    double affine        = 0.;
    const auto particles = bodies[0].particles.arrays();
    for (std::size_t p = 0; p < bodies[0].particles.size(); ++p)
      {
        const double c = frobenius_norm(load_matrix<dim>(particles.affine_velocity, p));
        affine += 0.5 * particles.mass[p] * 0.25 * lattice.spacing * lattice.spacing * c * c;
      }
    return sums.kinetic_energy + affine + sums.elastic_energy;
  }

  template <int dim>
  Vector<n_axial_components<dim>>
  FreeSolid<dim>::angular_momentum() const
  {
    return particle_sums(bodies[0], lattice, Vector<dim>(), MagnetizationLaw::linear)
      .angular_momentum;
  }

  template <int dim>
  std::vector<typename FreeSolid<dim>::Point>
  FreeSolid<dim>::points() const
  {
    const ParticleSet<dim> &particles = bodies[0].particles;
    const auto arrays                 = particles.arrays();
    std::vector<Point> points;
    const auto &law = std::get<NeoHookean<dim>>(bodies[0].material);
    for (std::size_t p = 0; p < particles.size(); ++p)
      {
        const Matrix<dim> deformation = load_matrix<dim>(arrays.deformation, p);
        const Matrix<dim> stress      = arrays.volumetric_stress != nullptr
                                          ? law.stress_with_pressure(deformation,
                                                                arrays.volumetric_stress[p])
                                          : law.kirchhoff_stress(deformation, {});
        points.push_back({starts[particles.ids()[p]],
                          particles.position(p),
                          load_vector<dim>(arrays.velocity, p),
                          deformation,
                          stress,
                          arrays.volume[p]});
      }
    return points;
  }

  template class FreeSolid<2>;
  template class FreeSolid<3>;
} // namespace magmpm::verification
