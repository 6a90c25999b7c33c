#pragma once

#include <magmpm/boundary/group_contact_parameters.h>
#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/parameters.h>

#include <string>
#include <vector>

/** The subsections of the section Contacts. */
namespace magmpm
{
  /** One contact as the user gives it. */
  struct ContactInput
  {
    Vector<2> groups       = {{0., 1.}};
    SurfaceContact contact = {ContactCondition::separate, 0.};
  };

  /** What bodies of two contact groups do to each other. */
  void
  declare_contact(ParameterRegister &declarations, const std::string &name, ContactInput &contact);

  /**
   * Checks that fluids are in group 0, and converts the contacts.
   *
   * @param names       of the contacts, in the order of @p contacts.
   * @param parameters  with its bodies and materials; gets its contacts, and warnings are added.
   * @throw InputError  says which line is wrong.
   */
  template <int dim>
  void
  check_contacts(const ParameterRegister &declarations,
                 const std::vector<std::string> &names,
                 const std::vector<ContactInput> &contacts,
                 Parameters<dim> &parameters);
} // namespace magmpm
