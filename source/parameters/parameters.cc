#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_listing.h>
#include <magmpm/parameters/parameter_sections.h>
#include <magmpm/parameters/parameters.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace magmpm
{
  namespace
  {
    /**
     * The names in a list of shapes, bodies, materials or magnets, which must be known before anything about
     * them can be declared.
     */
    std::vector<std::string>
    names_in_list(const ParameterFile &file, const std::string &path)
    {
      const std::string letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
      const ParameterEntry *entry = file.last_entry(path);
      std::vector<std::string> names;
      if (entry == nullptr || entry->value.empty())
        return names;

      const std::string start = entry->origin + ": " + path + " = " + entry->value + ": the name '";
      std::istringstream list(entry->value);
      std::string name;
      while (std::getline(list >> std::ws, name, ','))
        {
          name.erase(name.find_last_not_of(' ') + 1);
          if (name.empty() || name.find_first_not_of(letters) != std::string::npos)
            throw InputError(start + name +
                             "' must consist of letters, digits, _ and -, since it becomes part of "
                             "headings. Names are separated by commas.");
          if (std::find(names.begin(), names.end(), name) != names.end())
            throw InputError(start + name + "' is there twice; names must differ.");
          names.push_back(name);
        }
      return names;
    }
  } // namespace

  template <int dim>
  const MaterialParameters &
  Parameters<dim>::material_of(const BodyParameters<dim> &body) const
  {
    const auto material =
      std::find_if(materials.begin(), materials.end(), [&](const MaterialParameters &candidate) {
        return candidate.name == body.material;
      });
    if (material == materials.end())
      throw InputError("The body '" + body.name + "' is made of '" + body.material +
                       "', but there is no material of this name.");
    return *material;
  }

  template <int dim>
  std::vector<int>
  Parameters<dim>::contact_groups() const
  {
    std::set<int> groups;
    for (const BodyParameters<dim> &body : bodies)
      groups.insert(body.contact_group);
    return {groups.begin(), groups.end()};
  }

  int
  read_dimension(const ParameterFile &file)
  {
    const ParameterEntry *entry = file.last_entry("Dimension");
    if (entry == nullptr || entry->value == "3")
      return 3;
    if (entry->value == "2")
      return 2;
    throw InputError(entry->origin + ": Dimension = " + entry->value + ": must be 2 or 3.");
  }

  template <int dim>
  Parameters<dim>
  read_parameters(const ParameterFile &file)
  {
    ParameterInput<dim> input;
    input.shapes.names     = names_in_list(file, "Shapes/List of shapes");
    input.body_names       = names_in_list(file, "Bodies/List of bodies");
    input.material_names   = names_in_list(file, "Materials/List of materials");
    input.magnet_names     = names_in_list(file, "Magnets/List of magnets");
    input.rigid_body_names = names_in_list(file, "Rigid bodies/List of rigid bodies");
    input.contact_names    = names_in_list(file, "Contacts/List of contacts");

    Parameters<dim> parameters;
    ParameterRegister declarations;
    declare_parameters(declarations, input, parameters);
    declarations.apply(file);
    validate(declarations, input, parameters);

    if (parameters.output.directory.empty())
      parameters.output.directory = file.default_output_directory();
    declarations.set_value("Output directory", parameters.output.directory);
    parameters.original_text = file.text;
    parameters.complete_text = listing_of(declarations.parameters());
    return parameters;
  }

  template struct Parameters<2>;
  template struct Parameters<3>;
  template Parameters<2>
  read_parameters(const ParameterFile &);
  template Parameters<3>
  read_parameters(const ParameterFile &);
} // namespace magmpm
