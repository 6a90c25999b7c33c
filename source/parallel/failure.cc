#include <magmpm/parallel/failure.h>

#include <deal.II/base/exceptions.h>

#include <sstream>

namespace magmpm::parallel
{
  namespace
  {
    /** What deal.II says about an error of its own, on one line and without its banner. */
    std::string
    in_one_line(const dealii::ExceptionBase &error)
    {
      std::ostringstream information;
      error.print_info(information);
      std::istringstream words(information.str());
      std::string text, word;
      while (words >> word)
        text += " " + word;
      return "an error in deal.II (" + std::string(error.get_exc_name()) + "):" + text;
    }
  } // namespace

  Failure
  failure_of(const std::function<void()> &action)
  {
    try
      {
        action();
        return {};
      }
    catch (const InputError &error)
      {
        return {ExitCode::wrong_input, error.what()};
      }
    catch (const dealii::ExceptionBase &error)
      {
        return {ExitCode::failed_run, in_one_line(error)};
      }
    catch (const std::bad_alloc &)
      {
        return {ExitCode::failed_run, "the memory is full. Use larger cells, or more machines."};
      }
    catch (const std::exception &error)
      {
        return {ExitCode::failed_run, error.what()};
      }
    catch (...)
      {
        return {ExitCode::failed_run, "an exception of unknown type."};
      }
  }
} // namespace magmpm::parallel
