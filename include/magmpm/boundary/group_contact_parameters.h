#pragma once

#include <magmpm/boundary/surface_contact.h>

#include <utility>
#include <vector>

namespace magmpm
{
  /** What two contact groups of bodies do to each other where they touch. */
  struct GroupContactParameters
  {
    int first = 0, second = 0; ///< groups, which differ
    SurfaceContact contact = {ContactCondition::separate, 0.};
  };

  /** The contact between two groups, in any order: of those that are not listed it separates, without friction. */
  inline SurfaceContact
  contact_between(const std::vector<GroupContactParameters> &contacts, const int a, const int b)
  {
    for (const GroupContactParameters &listed : contacts)
      if (std::minmax(listed.first, listed.second) == std::minmax(a, b))
        return listed.contact;
    return GroupContactParameters().contact;
  }
} // namespace magmpm
