#include <magmpm/parallel/ranks.h>
#include <magmpm/results/rigid_body_output.h>
#include <magmpm/results/vtu_file.h>

namespace magmpm
{
  namespace
  {
    /** The numbers that VTK gives lines and triangles. */
    constexpr int line = 3, triangle = 5;
  } // namespace

  template <int dim>
  RigidBodyOutput<dim>::RigidBodyOutput(const MPI_Comm communicator,
                                        const std::string &directory,
                                        const ExternalField<dim> &sources,
                                        const RigidBodies<dim> &bodies,
                                        const double spacing)
    : communicator(communicator)
    , sources(sources)
    , bodies(bodies)
    , series(communicator, directory, rigid_body_frames)
  {
    const int n_sources = static_cast<int>(sources.sources().size());
    for (int s = 0; s < n_sources; ++s)
      if (const Shape<dim> *shape = sources.sources()[s]->shape())
        things.push_back({s, shape->surface_mesh(spacing)});
    for (std::size_t b = 0; b < bodies.all().size(); ++b)
      if (!bodies.source_of(b))
        {
          things.push_back({n_sources + static_cast<int>(body_numbers.size()),
                            bodies.all()[b].shape().surface_mesh(spacing)});
          body_numbers.push_back(b);
        }

    if (!things.empty())
      series.make_folder();
  }

  template <int dim>
  Pose<dim>
  RigidBodyOutput<dim>::pose_of(const Thing &thing) const
  {
    const int n_sources = static_cast<int>(sources.sources().size());
    return thing.number < n_sources
             ? sources.sources()[thing.number]->pose()
             : bodies.all()[body_numbers[thing.number - n_sources]].pose_of_shape();
  }

  template <int dim>
  void
  RigidBodyOutput<dim>::write_frame(const unsigned int frame, const double time)
  {
    if (things.empty())
      return;
    VtuPiece piece;
    piece.points_per_cell = dim;
    piece.cell_type       = dim == 2 ? line : triangle;
    piece.quantities.push_back({"body [-]", 1, {}});
    const bool is_writer = parallel::rank(communicator) == 0;
    for (const Thing &thing : things)
      {
        if (!is_writer)
          break;
        const int first      = static_cast<int>(piece.points.size() / 3);
        const Pose<dim> pose = pose_of(thing);
        for (const Vector<dim> &own : thing.surface.points)
          {
            const Vector<dim> point = pose.to_world(own);
            for (int d = 0; d < 3; ++d)
              piece.points.push_back(d < dim ? static_cast<float>(point[d]) : 0.f);
            piece.quantities[0].values.push_back(static_cast<float>(thing.number));
          }
        for (const auto &facet : thing.surface.facets)
          for (const int corner : facet)
            piece.cells.push_back(first + corner);
      }
    const std::string file =
      write_vtu(communicator, series.folder(), series.name(), {frame, time}, piece);
    series.add(time, file);
  }

  template class RigidBodyOutput<2>;
  template class RigidBodyOutput<3>;
} // namespace magmpm
