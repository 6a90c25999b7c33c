#pragma once

#include <magmpm/materials/magnetization_curve.h>

#include <iosfwd>
#include <string>

namespace magmpm
{
  /**
   * Reads a magnetization curve: a line 'H, M' [A/m] a point, separated by a comma, semicolon or blanks.
   * H rises from line to line, M does not fall; the point 0, 0 may be there. Empty lines, what follows
   * a '#', and one heading before the first point are skipped.
   *
   * @param file        the text.
   * @param name        of the file, for messages.
   * @throw InputError  names file and line, what stands there, and what is allowed.
   */
  MagnetizationCurve
  read_magnetization_curve(std::istream &file, const std::string &name);
} // namespace magmpm
