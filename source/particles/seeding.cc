#include <magmpm/base/exceptions.h>
#include <magmpm/base/number_text.h>
#include <magmpm/geometry/point_cloud_shape.h>
#include <magmpm/particles/seeding.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace magmpm
{
  namespace
  {
    /** SplitMix64: a random number in [-1/2, 1/2) that depends on the key alone. */
    double
    random_offset(std::uint64_t key)
    {
      key += 0x9e3779b97f4a7c15ull;
      key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9ull;
      key = (key ^ (key >> 27)) * 0x94d049bb133111ebull;
      key ^= key >> 31;
      return static_cast<double>(key >> 11) / 9007199254740992. - 0.5;
    }

    /** The grid of places where particles of a body can be. */
    template <int dim>
    struct Places
    {
      double spacing;
      Index<dim> first; ///< place in the lower corner of the bounding box
      Index<dim> count;

      Places(const BoundingBox<dim> &box, const int particles_per_edge, const Lattice<dim> &lattice)
        : spacing(lattice.spacing / particles_per_edge)
      {
        const Vector<dim> lower = (1. / spacing) * (box.lower - lattice.lower_corner);
        const Vector<dim> upper = (1. / spacing) * (box.upper - lattice.lower_corner);
        for (int d = 0; d < dim; ++d)
          {
            first[d] = static_cast<int>(std::floor(lower[d] + 1e-6));
            count[d] = std::max(0, static_cast<int>(std::ceil(upper[d] - 1e-6)) - first[d]);
          }
      }
    };

    /** The start of a particle in the motion of its body: v = v_0 + omega x r, C = grad v. */
    template <int dim>
    void
    set_motion(const BodyParameters<dim> &parameters,
               const Vector<dim> &centre,
               const std::size_t p,
               ParticleSet<dim> &particles)
    {
      const Vector<dim> r        = particles.position(p) - centre;
      const Vector<dim> velocity = parameters.velocity +
                                   rotation_velocity<dim>(parameters.angular_velocity, r);
      for (int d = 0; d < dim; ++d)
        {
          particles.component(ParticleProperty::velocity, d)[p] = velocity[d];
          Vector<dim> direction;
          direction[d]                 = 1.;
          const Vector<dim> derivative = rotation_velocity<dim>(parameters.angular_velocity,
                                                                direction);
          for (int c = 0; c < dim; ++c)
            particles.component(ParticleProperty::affine_velocity, dim * c + d)[p] = derivative[c];
        }
    }

    /** One more particle, undeformed, in the motion of its body about @p centre. */
    template <int dim>
    void
    add_particle(const BodyParameters<dim> &parameters,
                 const Vector<dim> &centre,
                 const std::uint64_t id,
                 const Vector<dim> &position,
                 const double volume,
                 ParticleSet<dim> &particles)
    {
      const std::size_t p = particles.size();
      particles.resize(p + 1);
      particles.ids()[p] = id;
      for (int d = 0; d < dim; ++d)
        particles.component(ParticleProperty::position, d)[p] = position[d];
      set_motion(parameters, centre, p, particles);
      particles.component(ParticleProperty::volume, 0)[p] = volume;
      particles.component(ParticleProperty::mass, 0)[p]   = parameters.density * volume;
      // The undeformed state: the identity, or J = 1.
      const int n_deformation = particles.n_components(ParticleProperty::deformation);
      for (int c = 0; c < n_deformation; c += dim + 1)
        particles.component(ParticleProperty::deformation, c)[p] = 1.;
    }

    /** A number of a particle is that of its body and one of these; below 2^53 messages hold it exactly. */
    constexpr int id_bits = 40, body_bits = 13;

    /**
     * The id of the first particle of a body, or an InputError if there are too many bodies, or more
     * places for particles than ids.
     */
    template <int dim>
    std::uint64_t
    first_id_of(const BodyParameters<dim> &parameters,
                const unsigned int body_number,
                const double n_places)
    {
      if (body_number >= (1u << body_bits))
        throw InputError("there are more bodies than the " + std::to_string(1u << body_bits) +
                         " that particles can be told apart by. Make one body of several: a mesh "
                         "may have many parts.");
      if (n_places > static_cast<double>(std::uint64_t(1) << id_bits))
        throw InputError("body '" + parameters.name + "' has places for " + to_text(n_places) +
                         " particles; at most 2^40, 1.1e+12, can be told apart. Choose larger "
                         "cells ('Box/Cell size'), or fewer particles per cell.");
      return static_cast<std::uint64_t>(body_number) << id_bits;
    }

    /** A particle at each point of the file that is this rank's. */
    template <int dim>
    void
    seed_points(const BodyParameters<dim> &parameters,
                const double volume_without,
                const unsigned int body_number,
                const unsigned int rank,
                const unsigned int n_ranks,
                ParticleSet<dim> &particles)
    {
      const PointCloudShape<dim> shape(read_point_cloud(parameters.shape));
      const PointCloud<dim> &cloud = shape.cloud();
      const Vector<dim> centre     = shape.volume_moments().centroid;
      const std::uint64_t n        = cloud.points.size();
      const std::uint64_t first_id = first_id_of(parameters, body_number, static_cast<double>(n));
      for (std::uint64_t i = n * rank / n_ranks; i < n * (rank + 1) / n_ranks; ++i)
        add_particle(parameters,
                     centre,
                     first_id + i,
                     cloud.points[i],
                     cloud.volumes.empty() ? volume_without : cloud.volumes[i],
                     particles);
    }
  } // namespace

  template <int dim>
  void
  seed_particles(const BodyParameters<dim> &parameters,
                 const Lattice<dim> &lattice,
                 const unsigned int body_number,
                 const unsigned int rank,
                 const unsigned int n_ranks,
                 Body<dim> &body)
  {
    const double volume = parameters.particle_volume(lattice);
    if (parameters.shape.type == ShapeType::points)
      return seed_points(parameters, volume, body_number, rank, n_ranks, body.particles);

    const std::unique_ptr<Shape<dim>> shape = make_shape(parameters.shape);
    const Places<dim> places(shape->bounding_box(), parameters.particles_per_edge, lattice);
    const Vector<dim> centre = shape->volume_moments().centroid;

    const std::uint64_t row_length = static_cast<std::uint64_t>(places.count[0]);
    std::uint64_t n_rows           = 1;
    for (int d = 1; d < dim; ++d)
      n_rows *= places.count[d];
    const std::uint64_t first_id =
      first_id_of(parameters, body_number, static_cast<double>(n_rows) * row_length);
    for (std::uint64_t row = n_rows * rank / n_ranks; row < n_rows * (rank + 1) / n_ranks; ++row)
      for (std::uint64_t i = 0; i < row_length; ++i)
        {
          const std::uint64_t id = first_id + row * row_length + i;
          Vector<dim> position;
          std::uint64_t rest = row;
          int sum_of_places  = 0;
          for (int d = 0; d < dim; ++d)
            {
              const int place = places.first[d] +
                                static_cast<int>(d == 0 ? i : rest % places.count[d]);
              if (d > 0)
                rest /= places.count[d];
              sum_of_places += place;
              position[d] = lattice.lower_corner[d] + places.spacing * (place + 0.5);
            }
          if (parameters.arrangement == Arrangement::face_centred && sum_of_places % 2 != 0)
            continue;
          // Inside or not is asked of the regular place, so that jitter does not change how many.
          if (!shape->contains(position))
            continue;
          for (int d = 0; d < dim; ++d)
            position[d] += parameters.jitter * places.spacing * random_offset(dim * id + d);
          add_particle(parameters, centre, id, position, volume, body.particles);
        }
  }

  template void
  seed_particles(const BodyParameters<2> &,
                 const Lattice<2> &,
                 unsigned int,
                 unsigned int,
                 unsigned int,
                 Body<2> &);
  template void
  seed_particles(const BodyParameters<3> &,
                 const Lattice<3> &,
                 unsigned int,
                 unsigned int,
                 unsigned int,
                 Body<3> &);
} // namespace magmpm
