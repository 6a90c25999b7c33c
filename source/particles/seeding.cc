#include <magmpm/base/exceptions.h>
#include <magmpm/base/number_text.h>
#include <magmpm/base/symmetric_root.h>
#include <magmpm/geometry/point_cloud_shape.h>
#include <magmpm/particles/cell_parts.h>
#include <magmpm/particles/cell_places.h>
#include <magmpm/particles/seeding.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <variant>

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

    template <int dim>
    constexpr unsigned int all_faces = (1u << (2 * dim)) - 1;

    /** What a particle of a solid fills of the undeformed body. */
    template <int dim>
    struct ParticleExtent
    {
      /** Symmetric: its columns go from the place of the particle to the sides of what it fills [m]. */
      Matrix<dim> half;

      unsigned int exposed_faces = 0; ///< a bit for each of -x, +x, -y, ..
    };

    /** One more particle, undeformed, in the motion of its body about @p centre. */
    template <int dim>
    void
    add_particle(const BodyParameters<dim> &parameters,
                 const Vector<dim> &centre,
                 const std::uint64_t id,
                 const Vector<dim> &position,
                 const double volume,
                 const ParticleExtent<dim> &extent,
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
      for (int i = 0, c = 0; c < particles.n_components(ParticleProperty::half_extent); ++i)
        for (int j = 0; j <= i; ++j, ++c)
          particles.component(ParticleProperty::half_extent, c)[p] = extent.half(i, j);
      if (particles.n_components(ParticleProperty::exposed_faces) > 0)
        particles.component(ParticleProperty::exposed_faces, 0)[p] = extent.exposed_faces;
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
        {
          const double volume = cloud.volumes.empty() ? volume_without : cloud.volumes[i];
          add_particle(parameters,
                       centre,
                       first_id + i,
                       cloud.points[i],
                       volume,
                       {0.5 * std::pow(volume, 1. / dim) * identity<dim>(), all_faces<dim>},
                       particles);
        }
    }

    /**
     * A position out of walls and obstacles: one that is behind a wall or a little inside an obstacle goes to
     * the nearest point of its surface. What is deeper in an obstacle than half a cell overlaps with it.
     */
    template <int dim>
    Vector<dim>
    kept_clear(Vector<dim> position,
               const Lattice<dim> &lattice,
               const std::vector<Obstacle<dim>> &obstacles)
    {
      constexpr int n_rounds    = 4; // where obstacles meet each other or a wall
      const double margin       = 1e-6 * lattice.spacing;
      const Vector<dim> highest = lattice.upper_corner();
      for (int round = 0; round < n_rounds; ++round)
        {
          for (const Obstacle<dim> &obstacle : obstacles)
            {
              const SurfaceDistance<dim> found = obstacle(position);
              if (margin > found.distance && found.distance > -0.5 * lattice.spacing)
                position += (margin - found.distance) * found.normal;
            }
          for (int d = 0; d < dim; ++d)
            position[d] =
              std::clamp(position[d], lattice.lower_corner[d] + margin, highest[d] - margin);
          if (obstacles.empty())
            break;
        }
      return position;
    }

    /** Sets the particles of one part of a body after another. */
    template <int dim>
    class PartSeeder
    {
    public:
      PartSeeder(const BodyParameters<dim> &parameters,
                 const Lattice<dim> &lattice,
                 const PlaceRule rule,
                 const Vector<dim> &centre)
        : parameters(parameters)
        , lattice(lattice)
        , centre(centre)
      {
        for (const int parity : {0, 1})
          places[parity] =
            cell_places<dim>(rule, parameters.particles_per_edge, parameters.arrangement, parity);
        for (const CellPlace<dim> &place : places[0])
          to_face = std::min(to_face, 0.5 - place.position[0]);
      }

      /** @param first_id  that of the first place in the cell. */
      void
      seed(const CellPart<dim> &part,
           const std::uint64_t first_id,
           const std::vector<Obstacle<dim>> &obstacles,
           ParticleSet<dim> &particles) const
      {
        Vector<dim> middle = lattice.node_position(part.cell);
        for (int d = 0; d < dim; ++d)
          middle[d] += 0.5 * lattice.spacing;
        const VolumeMoments<dim> moments = about_centroid(part.moments, middle);
        const Matrix<dim> map            = 2. * std::sqrt(3.) *
                                symmetric_root((1. / moments.volume) * moments.second);
        const double jitter = parameters.jitter / parameters.particles_per_edge;
        for (const CellPlace<dim> &place : places[parity_of(part.cell)])
          {
            const std::uint64_t id = first_id + place.number;
            Vector<dim> local      = place.position;
            for (int d = 0; d < dim; ++d)
              local[d] += jitter * random_offset(dim * id + d);
            add_particle(parameters,
                         centre,
                         id,
                         kept_clear(moments.centroid + map * local, lattice, obstacles),
                         place.weight * moments.volume,
                         {to_face * map, exposed_faces(part, place)},
                         particles);
          }
      }

    private:
      const BodyParameters<dim> &parameters;
      const Lattice<dim> &lattice;
      const Vector<dim> centre;                          ///< of the body's motion [m]
      std::array<std::vector<CellPlace<dim>>, 2> places; ///< by parity
      double to_face = 0.5;                              ///< from the outermost place of a cell [1]

      /** Those of the part that a place is next to. */
      unsigned int
      exposed_faces(const CellPart<dim> &part, const CellPlace<dim> &place) const
      {
        unsigned int faces = 0;
        for (int face = 0; face < 2 * dim; ++face)
          {
            const double outward = (face % 2 == 0 ? -1. : 1.) * place.position[face / 2];
            if (part.is_exposed[face] && outward > 0.5 - to_face - 1e-9)
              faces |= 1u << face;
          }
        return faces;
      }

      int
      parity_of(const Index<dim> &cell) const
      {
        int sum = 0;
        for (int d = 0; d < dim; ++d)
          sum += cell[d] * parameters.particles_per_edge;
        return sum & 1;
      }
    };

    template <int dim>
    PlaceRule
    rule_of(const Body<dim> &body)
    {
      const bool is_solid = std::visit(
        [](const auto &law) { return std::decay_t<decltype(law)>::stores_deformation_gradient; },
        body.material);
      return is_solid ? PlaceRule::gauss : PlaceRule::centres;
    }
  } // namespace

  template <int dim>
  void
  seed_particles(const BodyParameters<dim> &parameters,
                 const Lattice<dim> &lattice,
                 const unsigned int body_number,
                 const unsigned int rank,
                 const unsigned int n_ranks,
                 Body<dim> &body,
                 const std::vector<Obstacle<dim>> &obstacles)
  {
    const double volume = parameters.particle_volume(lattice);
    if (parameters.shape.type == ShapeType::points)
      return seed_points(parameters, volume, body_number, rank, n_ranks, body.particles);

    const std::unique_ptr<Shape<dim>> shape = make_shape(parameters.shape);
    const CellRange<dim> range(shape->bounding_box(), lattice);
    const std::uint64_t places_per_cell = power(parameters.particles_per_edge, dim);
    const std::uint64_t first_id =
      first_id_of(parameters, body_number, range.size() * places_per_cell);
    const PartSeeder<dim> seeder(
      parameters, lattice, rule_of(body), shape->volume_moments().centroid);

    const int along  = static_cast<int>(std::max_element(range.count.begin(), range.count.end()) -
                                       range.count.begin());
    const auto layer = [&](const std::uint64_t rank_there) {
      return static_cast<int>(range.count[along] * rank_there / n_ranks);
    };
    for (const CellPart<dim> &part :
         cell_parts<dim>(*shape, lattice, range, along, {layer(rank), layer(rank + 1)}))
      seeder.seed(
        part, first_id + places_per_cell * range.number(part.cell), obstacles, body.particles);
  }

#define INSTANTIATE(dim)                                    \
  template void seed_particles(const BodyParameters<dim> &, \
                               const Lattice<dim> &,        \
                               unsigned int,                \
                               unsigned int,                \
                               unsigned int,                \
                               Body<dim> &,                 \
                               const std::vector<Obstacle<dim>> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
