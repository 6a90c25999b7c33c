#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/source_parts.h>

#include <cmath>
#include <sstream>

namespace magmpm
{
  template <int dim>
  TimeFunction<Vector<dim>>
  current_amplitude(const TimeFunction<double> &current)
  {
    return current.transformed([](const double value) {
      Vector<dim> amplitude;
      amplitude[0] = value;
      return amplitude;
    });
  }

  void
  check_positive(const double length, const std::string &what, const std::string &source)
  {
    if (length > 0. && std::isfinite(length))
      return;
    std::ostringstream message;
    message << "The " << what << " '" << source << "' is " << length << " m. Give a positive one.";
    throw InputError(message.str());
  }

  template TimeFunction<Vector<2>>
  current_amplitude(const TimeFunction<double> &);
  template TimeFunction<Vector<3>>
  current_amplitude(const TimeFunction<double> &);
} // namespace magmpm
