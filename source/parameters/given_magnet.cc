#include <magmpm/base/constants.h>
#include <magmpm/motion/expression.h>
#include <magmpm/motion/pose_function.h>
#include <magmpm/parameters/given_magnet.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/source_kinds.h>

namespace magmpm
{
  template <int dim>
  TimeFunction<Vector<dim>>
  GivenMagnet<dim>::vector(const std::string &name, const std::string &text) const
  {
    return read_expression<dim>(text, declarations.where(section + "/" + name));
  }

  template <int dim>
  TimeFunction<double>
  GivenMagnet<dim>::scalar(const std::string &name, const std::string &text) const
  {
    return read_scalar_expression(text, declarations.where(section + "/" + name));
  }

  template <int dim>
  TimeFunction<Vector<dim>>
  GivenMagnet<dim>::position() const
  {
    return vector("Position", input.motion.position);
  }

  template <int dim>
  TimeFunction<Vector<n_axial_components<dim>>>
  GivenMagnet<dim>::rotation() const
  {
    if (!has("Rotation"))
      return {};
    return read_expression<n_axial_components<dim>>(input.motion.rotation,
                                                    declarations.where(section + "/Rotation"));
  }

  template <int dim>
  TimeFunction<Vector<dim>>
  GivenMagnet<dim>::magnetization() const
  {
    if (!has("Remanence"))
      return vector("Magnetization", input.magnetization);
    return vector("Remanence", input.remanence).transformed([](const Vector<dim> &remanence) {
      return (1. / constants::vacuum_permeability) * remanence;
    });
  }

  template <int dim>
  void
  GivenMagnet<dim>::read_motion(SourceParameters<dim> &source) const
  {
    if (has("Key frames"))
      {
        const auto others = given_of(declarations, section, {"Position", "Rotation", "Strength"});
        if (!others.empty())
          throw declarations.error(section + "/" + others.front(),
                                   "Key frames say this already. Give either of them.");
        const KeyFrames<dim> frames =
          read_key_frames<dim>(declarations, section + "/Key frames", input.motion);
        source.pose     = frames.pose;
        source.strength = frames.strength;
        return;
      }
    if (!has("Position"))
      throw declarations.error(section + "/Position",
                               "Type = " + input.kind->name + " needs it, or Key frames.");
    if (input.motion.interpolation != KeyFrameInterpolation::linear)
      throw declarations.error(section + "/Interpolation",
                               "it is used between Key frames only, which are not given.");
    if (dim == 2 && std::holds_alternative<StraightWireParameters<dim>>(source.kind))
      check_given(declarations, section, {}, {"Rotation"}, "a wire, which is along z in 2D,");
    source.pose = pose_function(position(), rotation());
    if (has("Strength"))
      source.strength = scalar("Strength", input.strength);
  }

  template struct GivenMagnet<2>;
  template struct GivenMagnet<3>;
} // namespace magmpm
