#include <mechanics/scene_run.h>

#include "program/scene.h"

#include <sstream>
#include <stdexcept>

namespace magmpm::benchmarks
{
  std::string
  run_scene(const std::string &name, const std::string &text)
  {
    const testing::Outcome run = testing::run_magmpm(testing::write_scene(name, text));
    if (run.exit_code != 0)
      throw std::runtime_error("The scene '" + name + "' failed: " + run.errors);
    return "output-" + name;
  }

  std::string
  as_text(const double number)
  {
    std::ostringstream text;
    text.precision(15);
    text << number;
    return text.str();
  }
} // namespace magmpm::benchmarks
