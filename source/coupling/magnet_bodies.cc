#include <magmpm/coupling/magnet_bodies.h>

#include <utility>

namespace magmpm
{
  template <int dim>
  std::vector<MovedBody<dim>>
  make_magnet_bodies(const std::vector<SourceParameters<dim>> &sources,
                     const std::vector<RigidBodyProperties<dim>> &properties,
                     const ExternalField<dim> &field)
  {
    std::vector<MovedBody<dim>> result;
    for (std::size_t s = 0; s < sources.size(); ++s)
      {
        if (!properties[s].is_free && properties[s].contact.condition == ContactCondition::none)
          continue;
        const MagneticSource<dim> &magnet = *field.sources()[s];
        // The source owns its shape.
        const std::shared_ptr<const Shape<dim>> shape(std::shared_ptr<void>(), magnet.shape());
        result.push_back({make_rigid_body(magnet.name(), shape, properties[s], magnet.pose()),
                          sources[s].pose,
                          MovedBody<dim>::Frame::shape,
                          s});
      }
    return result;
  }

  template <int dim>
  void
  move_free_sources(const RigidBodies<dim> &bodies, ExternalField<dim> &field)
  {
    for (std::size_t b = 0; b < bodies.all().size(); ++b)
      if (bodies.all()[b].is_free() && bodies.source_of(b))
        field.set_pose(*bodies.source_of(b), bodies.all()[b].pose_of_shape());
  }

#define MAGMPM_INSTANTIATE(dim)                            \
  template std::vector<MovedBody<dim>> make_magnet_bodies( \
    const std::vector<SourceParameters<dim>> &,            \
    const std::vector<RigidBodyProperties<dim>> &,         \
    const ExternalField<dim> &);                           \
  template void move_free_sources(const RigidBodies<dim> &, ExternalField<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
#undef MAGMPM_INSTANTIATE
} // namespace magmpm
