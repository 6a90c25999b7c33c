#include <magmpm/base/number_text.h>
#include <magmpm/parameters/contact_section.h>

#include <algorithm>

namespace magmpm
{
  void
  declare_contact(ParameterRegister &declarations, const std::string &name, ContactInput &contact)
  {
    const auto section = declarations.enter(name);
    declarations.add("Groups",
                     contact.groups,
                     "-",
                     "The two contact groups ('Contact group' of bodies) that this is about.",
                     Presence::required);
    declarations.add("Condition",
                     contact.contact.condition,
                     {{"stick", ContactCondition::stick},
                      {"slip", ContactCondition::slip},
                      {"separate", ContactCondition::separate}},
                     "What bodies of the two groups do once they touch: move together, slide along "
                     "each other without parting, or slide and part.");
    declarations.add("Friction",
                     contact.contact.friction,
                     "-",
                     "Coulomb's coefficient, with Condition = slip or separate.",
                     not_negative);
  }

  namespace
  {
    template <int dim>
    bool
    is_group(const Parameters<dim> &parameters, const double group)
    {
      return std::any_of(
        parameters.bodies.begin(), parameters.bodies.end(), [&](const BodyParameters<dim> &body) {
          return body.contact_group == group;
        });
    }

    template <int dim>
    void
    check_groups_of_fluids(const ParameterRegister &declarations, const Parameters<dim> &parameters)
    {
      for (const BodyParameters<dim> &body : parameters.bodies)
        if (body.contact_group != 0 &&
            parameters.material_of(body).law == MechanicalLaw::viscoelastic_fluid)
          throw declarations.error("Bodies/" + body.name + "/Contact group",
                                   "the material '" + body.material +
                                     "' is a fluid, and fluids are in group 0. Leave it at 0; "
                                     "give what they are to slip along another group.");
    }

    /** The groups of a contact. @throw InputError  if they are none. */
    template <int dim>
    GroupContactParameters
    convert_contact(const ParameterRegister &declarations,
                    const std::string &section,
                    const ContactInput &input,
                    Parameters<dim> &parameters)
    {
      const std::string path = section + "/Groups";
      for (int i = 0; i < 2; ++i)
        if (!(input.groups[i] >= 0.) || input.groups[i] != static_cast<int>(input.groups[i]))
          throw declarations.error(path,
                                   "groups are whole numbers from 0 on, as 'Contact group' of "
                                   "bodies.");
      if (input.groups[0] == input.groups[1])
        throw declarations.error(path,
                                 "the two are the same: bodies of one group stick together. Name "
                                 "two groups.");
      for (int i = 0; i < 2; ++i)
        if (!is_group(parameters, input.groups[i]))
          parameters.warnings.push_back(declarations.where(path) +
                                        ": no body is in contact group " +
                                        to_text(input.groups[i]) + ".");
      return {static_cast<int>(input.groups[0]), static_cast<int>(input.groups[1]), input.contact};
    }
  } // namespace

  template <int dim>
  void
  check_contacts(const ParameterRegister &declarations,
                 const std::vector<std::string> &names,
                 const std::vector<ContactInput> &contacts,
                 Parameters<dim> &parameters)
  {
    check_groups_of_fluids(declarations, parameters);
    for (std::size_t i = 0; i < contacts.size(); ++i)
      {
        const std::string section = "Contacts/" + names[i];
        const GroupContactParameters contact =
          convert_contact(declarations, section, contacts[i], parameters);
        for (std::size_t j = 0; j < i; ++j)
          if (std::minmax(contact.first, contact.second) ==
              std::minmax(parameters.contacts[j].first, parameters.contacts[j].second))
            throw declarations.error(section + "/Groups",
                                     "the contact '" + names[j] +
                                       "' is about the same two groups. Leave one of them out.");
        parameters.contacts.push_back(contact);
      }
  }

#define INSTANTIATE(dim)                                          \
  template void check_contacts(const ParameterRegister &,         \
                               const std::vector<std::string> &,  \
                               const std::vector<ContactInput> &, \
                               Parameters<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
