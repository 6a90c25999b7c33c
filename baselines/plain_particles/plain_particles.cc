#include <magmpm/lattice/bspline.h>
#include <magmpm/particles/particle_state.h>

#include <baselines/plain_particles/plain_particles.h>

#include <algorithm>
#include <numeric>

namespace magmpm::baselines
{
  namespace
  {
    /** The nodes around a particle: the number of the first, weights and distances along each axis. */
    template <int dim>
    struct PlainStencil
    {
      std::size_t first = 0;
      double weights[dim][stencil_width];
      double slopes[dim][stencil_width];    ///< of the weights [1/m]
      double distances[dim][stencil_width]; ///< from the particle [m]

      PlainStencil(const Lattice<dim> &lattice,
                   const PlainLattice<dim> &nodes,
                   const Vector<dim> &position)
      {
        const Vector<dim> x   = lattice.reduced(position);
        const Index<dim> base = lattice.base_node(position);
        first                 = nodes.number(base);
        for (int d = 0; d < dim; ++d)
          {
            const double offset = x[d] - base[d];
            quadratic_bspline(offset, weights[d]);
            quadratic_bspline_derivative(offset, slopes[d]);
            for (int i = 0; i < stencil_width; ++i)
              {
                slopes[d][i] /= lattice.spacing;
                distances[d][i] = (i - offset) * lattice.spacing;
              }
          }
      }
    };

    /** f(number of the node, N_i, x_i - x_p, grad N_i) for the nodes of a stencil. */
    template <int dim, typename Function>
    inline void
    for_each_node(const PlainStencil<dim> &stencil,
                  const PlainLattice<dim> &nodes,
                  const Function &f)
    {
      for (int k = 0; k < (dim == 3 ? stencil_width : 1); ++k)
        for (int j = 0; j < stencil_width; ++j)
          for (int i = 0; i < stencil_width; ++i)
            {
              std::size_t n  = stencil.first + i + j * nodes.stride(1);
              const int at[] = {i, j, k};
              double weight  = 1.;
              Vector<dim> distance, gradient;
              for (int d = 0; d < dim; ++d)
                {
                  weight *= stencil.weights[d][at[d]];
                  distance[d] = stencil.distances[d][at[d]];
                  gradient[d] = 1.;
                  for (int e = 0; e < dim; ++e)
                    gradient[d] *= (d == e ? stencil.slopes : stencil.weights)[e][at[e]];
                }
              if constexpr (dim == 3)
                n += k * nodes.stride(2);
              f(n, weight, distance, gradient);
            }
    }

    template <int dim, typename Law>
    void
    scatter(const PlainBody<dim, Law> &body,
            const Lattice<dim> &lattice,
            const double time_step,
            PlainLattice<dim> &nodes)
    {
      const double mls_factor = 4. / (lattice.spacing * lattice.spacing);
      for (const PlainParticle<dim, Law> &particle : body.particles)
        {
          const Matrix<dim> stress  = body.law.kirchhoff_stress(particle.deformation,
                                                               particle.affine_velocity);
          const Matrix<dim> impulse = (-time_step * particle.volume) * stress;
          for_each_node(PlainStencil<dim>(lattice, nodes, particle.position),
                        nodes,
                        [&](const std::size_t n,
                            const double weight,
                            const Vector<dim> &distance,
                            const Vector<dim> &gradient) {
                          nodes[n].motion +=
                            (weight * particle.mass) *
                            (particle.velocity + particle.affine_velocity * distance);
                          nodes[n].motion += impulse * (Law::stores_deformation_gradient
                                                          ? gradient
                                                          : (mls_factor * weight) * distance);
                          nodes[n].mass += weight * particle.mass;
                        });
        }
    }

    template <int dim, typename Law>
    void
    gather(const PlainLattice<dim> &nodes,
           const Lattice<dim> &lattice,
           const double time_step,
           PlainBody<dim, Law> &body)
    {
      const double affine_factor = 4. / (lattice.spacing * lattice.spacing);
      for (PlainParticle<dim, Law> &particle : body.particles)
        {
          Vector<dim> velocity;
          Matrix<dim> moment, slope;
          for_each_node(PlainStencil<dim>(lattice, nodes, particle.position),
                        nodes,
                        [&](const std::size_t n,
                            const double weight,
                            const Vector<dim> &distance,
                            const Vector<dim> &gradient) {
                          const Vector<dim> part = weight * nodes[n].motion;
                          velocity += part;
                          moment += outer(part, distance);
                          if constexpr (Law::stores_deformation_gradient)
                            slope += outer(nodes[n].motion, gradient);
                        });
          particle.velocity        = velocity;
          particle.affine_velocity = affine_factor * moment;
          particle.deformation =
            body.law.advanced(particle.deformation,
                              Law::stores_deformation_gradient ? slope : particle.affine_velocity,
                              time_step);
          particle.position += time_step * velocity;
        }
    }

    /** Counting sort by the base nodes. */
    template <int dim, typename Particle>
    void
    sort_particles(const Lattice<dim> &lattice,
                   const PlainLattice<dim> &nodes,
                   std::vector<Particle> &particles)
    {
      std::vector<std::size_t> key(particles.size()), begin(nodes.size() + 1, 0);
      for (std::size_t p = 0; p < particles.size(); ++p)
        {
          key[p] = nodes.number(lattice.base_node(particles[p].position));
          ++begin[key[p] + 1];
        }
      std::partial_sum(begin.begin(), begin.end(), begin.begin());
      std::vector<Particle> sorted(particles.size());
      for (std::size_t p = 0; p < particles.size(); ++p)
        sorted[begin[key[p]]++] = particles[p];
      particles.swap(sorted);
    }

    /** Makes room for the nodes around all particles. */
    template <int dim, typename AnyBody>
    void
    fit(const Lattice<dim> &lattice, const std::vector<AnyBody> &bodies, PlainLattice<dim> &nodes)
    {
      constexpr double large = 1e300;
      Vector<dim> lower, upper;
      for (int d = 0; d < dim; ++d)
        {
          lower[d] = large;
          upper[d] = -large;
        }
      for (const AnyBody &any : bodies)
        std::visit(
          [&](const auto &body) {
            for (const auto &particle : body.particles)
              for (int d = 0; d < dim; ++d)
                {
                  lower[d] = std::min(lower[d], particle.position[d]);
                  upper[d] = std::max(upper[d], particle.position[d]);
                }
          },
          any);
      Index<dim> last = lattice.base_node(upper);
      for (int d = 0; d < dim; ++d)
        last[d] += stencil_width - 1;
      nodes.reinit(lattice.base_node(lower), last);
    }

    template <int dim, typename Law>
    PlainBody<dim, Law>
    plain_body(const Law &law, const ParticleSet<dim> &set)
    {
      const auto arrays = set.arrays();
      PlainBody<dim, Law> body{law, {}};
      for (std::size_t p = 0; p < set.size(); ++p)
        body.particles.push_back({load_vector<dim>(arrays.position, p),
                                  load_vector<dim>(arrays.velocity, p),
                                  load_matrix<dim>(arrays.affine_velocity, p),
                                  load_state<dim, Law>(arrays, p),
                                  arrays.mass[p],
                                  arrays.volume[p]});
      return body;
    }
  } // namespace

  template <int dim>
  PlainParticles<dim>::PlainParticles(const Lattice<dim> &lattice,
                                      const std::vector<Body<dim>> &originals)
    : lattice(lattice)
  {
    for (const Body<dim> &original : originals)
      std::visit([&](const auto &law) { bodies.push_back(plain_body(law, original.particles)); },
                 original.material);
  }

  template <int dim>
  std::size_t
  PlainParticles<dim>::size() const
  {
    std::size_t n = 0;
    for (const AnyBody &any : bodies)
      std::visit([&n](const auto &body) { n += body.particles.size(); }, any);
    return n;
  }

  template <int dim>
  void
  PlainParticles<dim>::sort()
  {
    fit(lattice, bodies, plain_lattice);
    for (AnyBody &any : bodies)
      std::visit([this](auto &body) { sort_particles(lattice, plain_lattice, body.particles); },
                 any);
  }

  template <int dim>
  void
  PlainParticles<dim>::particles_to_lattice(const double time_step)
  {
    fit(lattice, bodies, plain_lattice);
    for (const AnyBody &any : bodies)
      std::visit([&](const auto &body) { scatter(body, lattice, time_step, plain_lattice); }, any);
  }

  template <int dim>
  void
  PlainParticles<dim>::update_lattice(const double time_step, const double gravity, const int floor)
  {
    for (std::size_t n = 0; n < plain_lattice.size(); ++n)
      {
        PlainNode<dim> &node = plain_lattice[n];
        if (node.mass == 0.)
          continue;
        node.motion *= 1. / node.mass;
        node.motion[dim - 1] += time_step * gravity;
        if (plain_lattice.node(n)[dim - 1] <= floor && node.motion[dim - 1] < 0.)
          node.motion[dim - 1] = 0.;
      }
  }

  template <int dim>
  void
  PlainParticles<dim>::lattice_to_particles(const double time_step)
  {
    for (AnyBody &any : bodies)
      std::visit([&](auto &body) { gather(plain_lattice, lattice, time_step, body); }, any);
  }

  template <int dim>
  void
  PlainParticles<dim>::copy_to(std::vector<Body<dim>> &copies) const
  {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      std::visit(
        [arrays = copies[b].particles.arrays()](const auto &body) {
          using Law = std::decay_t<decltype(body.law)>;
          for (std::size_t p = 0; p < body.particles.size(); ++p)
            {
              const auto &particle = body.particles[p];
              store_vector<dim>(particle.position, arrays.position, p);
              store_vector<dim>(particle.velocity, arrays.velocity, p);
              store_matrix<dim>(particle.affine_velocity, arrays.affine_velocity, p);
              store_state<dim, Law>(particle.deformation, arrays, p);
            }
        },
        bodies[b]);
  }

  template class PlainParticles<2>;
  template class PlainParticles<3>;
} // namespace magmpm::baselines
