#include <deal.II/base/exceptions.h>
#include <deal.II/base/function_parser.h>

#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/motion/expression.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iostream>
#include <memory>
#include <sstream>
#include <vector>

namespace magmpm
{
  namespace
  {
    /** Splits at semicolons, and at commas that are not between the arguments of a function. */
    std::vector<std::string>
    split_components(const std::string &expression)
    {
      std::vector<std::string> components(1);
      int depth = 0;
      for (const char c : expression)
        {
          depth += (c == '(') - (c == ')');
          if (c == ';' || (c == ',' && depth == 0))
            components.emplace_back();
          else
            components.back() += c;
        }
      return components;
    }

    /** Names of variables, constants and functions that occur in the expression. */
    std::vector<std::string>
    identifiers(const std::string &expression)
    {
      std::vector<std::string> names;
      for (auto character = expression.begin(); character != expression.end();)
        {
          const auto end = std::find_if_not(character, expression.end(), [](const unsigned char c) {
            return std::isalnum(c) || c == '_' || c == '.';
          });
          // What starts with a digit is a number, whose exponent (1e5) is no name.
          if (end != character && !std::isdigit(static_cast<unsigned char>(*character)))
            names.emplace_back(character, end);
          character = std::max(end, character + 1);
        }
      return names;
    }

    bool
    contains(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }

    [[noreturn]] void
    refuse(const std::string &subject, const std::string &expression, const std::string &complaint)
    {
      throw InputError(subject + ": '" + expression + "' " + complaint);
    }

    template <int dim>
    std::string
    advice()
    {
      if (dim == 1)
        return "one expression of the time t [s], such as '0.2 + 0.1*t'";
      return std::to_string(dim) +
             " expressions of the time t [s], separated by semicolons, such as '" +
             (dim == 3 ? "0.5; 0.5; 0.2 + 0.1*t" : "0.5; 0.2 + 0.1*t") + "'";
    }

    /** What the parser said, without what deal.II puts around it (which names a wrong column). */
    std::string
    reason(const dealii::ExceptionBase &error)
    {
      std::ostringstream stream;
      error.print_info(stream);
      std::string text       = stream.str();
      const std::string mark = "The parser said: ";
      const auto said        = text.find(mark);
      text                   = said == std::string::npos ? text : text.substr(said + mark.size());
      std::replace(text.begin(), text.end(), '\n', ' ');
      return text.substr(0, text.find_last_not_of(" .") + 1) + '.';
    }

    /** As long as it lives, deal.II throws parser errors without printing them as well. */
    class QuietErrorStream
    {
    public:
      QuietErrorStream()
        : terminal(std::cerr.rdbuf(unheard.rdbuf()))
      {
      }

      ~QuietErrorStream()
      {
        std::cerr.rdbuf(terminal);
      }

      QuietErrorStream(const QuietErrorStream &) = delete;

    private:
      std::ostringstream unheard;
      std::streambuf *terminal;
    };

    /** The parser of the components, and what its messages name. */
    template <int n>
    class Expression
    {
    public:
      Expression(const std::string &text, const std::string &subject)
        : text(text)
        , subject(subject)
      {
        const std::vector<std::string> components = split_components(text);
        if (components.size() != n)
          refuse(subject,
                 text,
                 "has " + std::to_string(components.size()) + " component" +
                   (components.size() == 1 ? "" : "s") + ", not " + std::to_string(n) + ". Give " +
                   advice<n>() + ".");

        const std::vector<std::string> names = identifiers(text);
        changes                              = contains(names, "t");
        // Every rank would draw its own.
        if (contains(names, "rand") || contains(names, "rand_seed"))
          refuse(subject, text, "draws random numbers. Give " + advice<n>() + " alone.");

        try
          {
            const QuietErrorStream quiet;
            parser.initialize("t", components, {{"pi", constants::pi}});
            // The parser reads an expression only when it is asked for its value.
            value(0.);
          }
        catch (const dealii::ExceptionBase &error)
          {
            refuse(subject,
                   text,
                   "cannot be read: " + reason(error) + " Give " + advice<n>() + "; pi is known.");
          }
      }

      Vector<n>
      value(const double time) const
      {
        Vector<n> result;
        for (int i = 0; i < n; ++i)
          {
            result[i] = parser.value(dealii::Point<1>(time), i);
            if (!std::isfinite(result[i]))
              {
                std::ostringstream when;
                when << time;
                refuse(subject,
                       text,
                       "is not a finite number at t = " + when.str() + " s (component " +
                         std::to_string(i + 1) +
                         "). It must be one from t = 0 to the end of the run.");
              }
          }
        return result;
      }

      /** Whether t occurs. */
      bool
      changes_in_time() const
      {
        return changes;
      }

    private:
      const std::string text;
      const std::string subject;
      bool changes;
      dealii::FunctionParser<1> parser{n};
    };
  } // namespace

  template <int n>
  TimeFunction<Vector<n>>
  read_expression(const std::string &text, const std::string &subject)
  {
    const auto expression = std::make_shared<const Expression<n>>(text, subject);
    if (!expression->changes_in_time())
      return expression->value(0.);
    return TimeFunction<Vector<n>>(
      [expression](const double time) { return expression->value(time); });
  }

  TimeFunction<double>
  read_scalar_expression(const std::string &text, const std::string &subject)
  {
    return read_expression<1>(text, subject).transformed([](const Vector<1> &value) {
      return value[0];
    });
  }

  template TimeFunction<Vector<1>>
  read_expression(const std::string &, const std::string &);
  template TimeFunction<Vector<2>>
  read_expression(const std::string &, const std::string &);
  template TimeFunction<Vector<3>>
  read_expression(const std::string &, const std::string &);
} // namespace magmpm
