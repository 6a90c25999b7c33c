#pragma once

#include <string>
#include <vector>

namespace magmpm
{
  /**
   * The number of letters to insert, delete, replace, or swap with their neighbour to turn one name
   * into the other; upper and lower case do not differ.
   */
  int
  edit_distance(const std::string &a, const std::string &b);

  /**
   * The known name that the user most probably meant by @p name: the one at the smallest edit
   * distance, if that is at most a third of its length (but always 1); else an empty string.
   */
  std::string
  closest_name(const std::string &name, const std::vector<std::string> &known_names);

  /** "; did you mean 'Density'?", or "." if no known name is close: the end of a message. */
  std::string
  did_you_mean(const std::string &name, const std::vector<std::string> &known_names);

  /** "a, b, c" at commas: {"a", "b", "c"}; without space at the ends of a part. Nothing: no parts. */
  std::vector<std::string>
  split(const std::string &text, const char delimiter);

  /** "a, b, c" */
  std::string
  comma_separated(const std::vector<std::string> &names);
} // namespace magmpm
