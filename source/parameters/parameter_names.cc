#include <magmpm/parameters/parameter_names.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace magmpm
{
  int
  edit_distance(const std::string &a, const std::string &b)
  {
    const auto differ = [&](const std::size_t i, const std::size_t j) {
      return std::tolower(static_cast<unsigned char>(a[i])) !=
             std::tolower(static_cast<unsigned char>(b[j]));
    };

    // distance[i][j]: of the first i letters of a and the first j of b
    std::vector<std::vector<int>> distance(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
      for (std::size_t j = 0; j <= b.size(); ++j)
        if (i == 0 || j == 0)
          distance[i][j] = static_cast<int>(i + j);
        else
          {
            distance[i][j] = std::min({distance[i - 1][j] + 1,
                                       distance[i][j - 1] + 1,
                                       distance[i - 1][j - 1] + (differ(i - 1, j - 1) ? 1 : 0)});
            if (i > 1 && j > 1 && !differ(i - 1, j - 2) && !differ(i - 2, j - 1))
              distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
          }
    return distance[a.size()][b.size()];
  }

  std::string
  closest_name(const std::string &name, const std::vector<std::string> &known_names)
  {
    std::string closest;
    int smallest = 0;
    for (const std::string &known : known_names)
      {
        const int distance = edit_distance(name, known);
        const int allowed  = std::max(1, static_cast<int>(known.size()) / 3);
        if (distance <= allowed && (closest.empty() || distance < smallest))
          {
            closest  = known;
            smallest = distance;
          }
      }
    return closest;
  }

  std::string
  did_you_mean(const std::string &name, const std::vector<std::string> &known_names)
  {
    const std::string closest = closest_name(name, known_names);
    return closest.empty() ? "." : "; did you mean '" + closest + "'?";
  }

  std::vector<std::string>
  split(const std::string &text, const char delimiter)
  {
    const auto trimmed = [](const std::string &part) {
      const std::string space = " \t\r\n";
      const std::size_t first = part.find_first_not_of(space);
      if (first == std::string::npos)
        return std::string();
      return part.substr(first, part.find_last_not_of(space) - first + 1);
    };
    std::vector<std::string> parts;
    std::istringstream stream(trimmed(text));
    std::string part;
    while (std::getline(stream, part, delimiter))
      parts.push_back(trimmed(part));
    return parts;
  }

  std::string
  comma_separated(const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "" : ", ") + name;
    return text;
  }
} // namespace magmpm
