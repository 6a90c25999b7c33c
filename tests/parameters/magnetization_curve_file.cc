#include "../catch.h"

#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/magnetization_curve_file.h>

#include <sstream>

using namespace magmpm;

namespace
{
  MagnetizationCurve
  read(const std::string &text)
  {
    std::istringstream file(text);
    return read_magnetization_curve(file, "emg.csv");
  }

  std::string
  message_on(const std::string &text)
  {
    try
      {
        read(text);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST_CASE("a magnetization curve is read as people write it", "[parameters]")
{
  // A heading, comments, empty lines, commas, semicolons or blanks, with the origin or without it.
  const std::string plain = "1e3, 900\n2e3, 1500\n4e3, 2000\n";
  for (const std::string &text : {plain,
                                  "H [A/m], M [A/m]\n0, 0\n" + plain,
                                  std::string("# sheet 3\n\n1000;900\n  2000 1500 # twice\n"
                                              "4e3,\t2000")})
    {
      const MagnetizationCurve curve = read(text);
      CHECK(curve.evaluate(1e6).over_field == Approx(0.9));
      CHECK(curve.evaluate(16e6).over_field == Approx(0.5));
    }
}

// Tables with one fault each; a message has the line, the value and what is allowed.
TEST_CASE("a wrong magnetization curve is refused, by line", "[parameters]")
{
  CHECK(message_on("H, M\n1e3, 900\n2e3\n4e3, 2000\n") ==
        "emg.csv, line 3: 2e3: there must be two numbers, H and M [A/m]. Correct this line.");
  CHECK(message_on("1e3, 900\n2e3, 1500 A/m\n4e3, 2000\n") ==
        "emg.csv, line 2: 2e3, 1500 A/m: there must be two numbers, H and M [A/m]. Correct this "
        "line.");
  CHECK(message_on("0, 0\n1e3, 900\n\n1e3, 1500\n") ==
        "emg.csv, line 4: 1e3, 1500: H must be greater than that of the point before it (1000 A/m; "
        "the curve begins at 0, 0). Correct this line.");
  CHECK(
    message_on("1e3, 900\n2e3, 800\n") ==
    "emg.csv, line 2: 2e3, 800: M must be greater than 0 and not smaller than that of the point "
    "before it (900 A/m). Correct this line.");
  CHECK(message_on("0, 5\n1e3, 900\n") ==
        "emg.csv, line 1: 0, 5: H must be greater than that of the point before it (0 A/m; the "
        "curve begins at 0, 0). Correct this line.");
  CHECK(message_on("0, 0\n1e3, 900\n") ==
        "emg.csv: a magnetization curve needs 2 points or more beside 0, 0; there are 1. Add lines "
        "'H, M' [A/m].");
  CHECK(message_on("H, M\nfield, moment\n") ==
        "emg.csv, line 2: field, moment: there must be two numbers, H and M [A/m]. Correct this "
        "line.");
}
