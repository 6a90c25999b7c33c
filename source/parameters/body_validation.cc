#include <magmpm/geometry/point_cloud_shape.h>
#include <magmpm/geometry/shape_overlap.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/base/number_text.h>
#include <magmpm/parameters/parameter_names.h>
#include <magmpm/parameters/section_validation.h>
#include <magmpm/parameters/shape_section.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    template <int dim>
    void
    check_points(const ParameterRegister &declarations,
                 const std::string &section,
                 const BodyParameters<dim> &body,
                 const PointCloud<dim> &cloud,
                 const Lattice<dim> &lattice)
    {
      if (body.jitter > 0.)
        throw declarations.error(
          section + "/Jitter",
          "with Shape = points particles are where the file has them; set it "
          "to 0.");
      for (std::size_t i = 0; i < cloud.points.size(); ++i)
        for (int d = 0; d < dim; ++d)
          if (!(cloud.points[i][d] > lattice.lower_corner[d] &&
                cloud.points[i][d] < lattice.upper_corner()[d]))
            throw declarations.error(section + "/File",
                                     "the point of line " + std::to_string(cloud.lines[i]) +
                                       ", at " + components(cloud.points[i]) +
                                       " m in the scene, is not inside the box. Move the points "
                                       "with Scale, Rotation or Translation, or enlarge the box.");
    }
  } // namespace

  template <int dim>
  std::vector<std::unique_ptr<Shape<dim>>>
  check_bodies(const ParameterRegister &declarations,
               const ParameterInput<dim> &input,
               Parameters<dim> &parameters)
  {
    const std::string list = "Bodies/List of bodies";
    if (parameters.bodies.empty())
      throw declarations.error(list, "a scene needs at least one body.");

    std::vector<std::unique_ptr<Shape<dim>>> shapes;
    for (BodyParameters<dim> &body : parameters.bodies)
      {
        const std::string section = "Bodies/" + body.name;
        const auto &names         = input.material_names;
        if (std::find(names.begin(), names.end(), body.material) == names.end())
          throw declarations.error(section + "/Material",
                                   "there is no material of this name. Materials/List of "
                                   "materials is '" +
                                     comma_separated(names) + "'" +
                                     did_you_mean(body.material, names));
        shapes.push_back(check_shape(declarations, section, body.shape));
        if (body.shape.type == ShapeType::points)
          check_points(declarations,
                       section,
                       body,
                       static_cast<const PointCloudShape<dim> &>(*shapes.back()).cloud(),
                       parameters.lattice);
        check_inside_box(declarations,
                         section,
                         body.shape.type,
                         shapes.back()->bounding_box(),
                         parameters.lattice);
      }

    for (std::size_t i = 0; i < parameters.bodies.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (overlap(*shapes[i], *shapes[j], 0.5 * parameters.lattice.spacing))
          throw declarations.error(list,
                                   "the bodies '" + parameters.bodies[j].name + "' and '" +
                                     parameters.bodies[i].name +
                                     "' overlap at the start; move them apart.");
    return shapes;
  }

  template std::vector<std::unique_ptr<Shape<2>>>
  check_bodies(const ParameterRegister &, const ParameterInput<2> &, Parameters<2> &);
  template std::vector<std::unique_ptr<Shape<3>>>
  check_bodies(const ParameterRegister &, const ParameterInput<3> &, Parameters<3> &);
} // namespace magmpm
