#include <magmpm/base/number_text.h>
#include <magmpm/parameters/parameter_names.h>
#include <magmpm/parameters/shape_section.h>
#include <magmpm/parameters/shapes_section.h>

#include <algorithm>

namespace magmpm
{
  template <int dim>
  void
  declare_shapes(ParameterRegister &declarations, NamedShapes<dim> &named)
  {
    for (std::size_t i = 0; i < named.names.size(); ++i)
      {
        const auto section = declarations.enter(named.names[i]);
        declare_shape(declarations, named.shapes[i]);
      }
  }

  namespace
  {
    /** The number of a shape that the one in @p section names as its part. */
    template <int dim>
    std::size_t
    number_of_part(const ParameterRegister &declarations,
                   const std::string &section,
                   const NamedShapes<dim> &named,
                   const std::string &name)
    {
      const auto found = std::find(named.names.begin(), named.names.end(), name);
      if (found == named.names.end())
        throw declarations.error(section + "/Of",
                                 "there is no shape '" + name + "'. Shapes/List of shapes is '" +
                                   comma_separated(named.names) + "'" +
                                   did_you_mean(name, named.names));
      return found - named.names.begin();
    }

    /** Goes from shapes to their parts, and checks parts first. */
    template <int dim>
    class PartsFirst
    {
    public:
      PartsFirst(const ParameterRegister &declarations, NamedShapes<dim> &named)
        : declarations(declarations)
        , named(named)
        , is_checked(named.names.size(), false)
      {
      }

      void
      check(const std::size_t i)
      {
        if (is_checked[i])
          return;
        const std::string section = "Shapes/" + named.names[i];
        way.push_back(named.names[i]);
        if (std::find(way.begin(), way.end() - 1, named.names[i]) != way.end() - 1)
          throw declarations.error(section + "/Of",
                                   "it is made of itself: " + comma_separated(way) + ".");
        for (const std::string &name : named.shapes[i].part_names)
          check(number_of_part(declarations, section, named, name));
        check_shape(declarations, section, named, named.shapes[i]);
        way.pop_back();
        is_checked[i] = true;
      }

    private:
      const ParameterRegister &declarations;
      NamedShapes<dim> &named;
      std::vector<bool> is_checked;
      std::vector<std::string> way; ///< from a shape to a part of a part
    };
  } // namespace

  template <int dim>
  void
  check_shapes(const ParameterRegister &declarations, NamedShapes<dim> &named)
  {
    PartsFirst<dim> parts(declarations, named);
    for (std::size_t i = 0; i < named.names.size(); ++i)
      parts.check(i);
  }

  template <int dim>
  void
  take_parts(const ParameterRegister &declarations,
             const std::string &section,
             const NamedShapes<dim> &named,
             ShapeParameters<dim> &shape)
  {
    if (shape.part_names.size() < 2)
      throw declarations.error(section + "/Of",
                               "it takes at least two names of Shapes/List of shapes, separated "
                               "by commas.");
    for (const std::string &name : shape.part_names)
      shape.parts.push_back(named.shapes[number_of_part(declarations, section, named, name)]);
  }

#define INSTANTIATE(dim)                                                     \
  template void declare_shapes(ParameterRegister &, NamedShapes<dim> &);     \
  template void check_shapes(const ParameterRegister &, NamedShapes<dim> &); \
  template void take_parts(const ParameterRegister &,                        \
                           const std::string &,                              \
                           const NamedShapes<dim> &,                         \
                           ShapeParameters<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
