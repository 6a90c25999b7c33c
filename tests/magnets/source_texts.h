#pragma once

#include <magmpm/magnets/source_parameters.h>
#include <magmpm/motion/expression.h>
#include <magmpm/motion/pose_function.h>

/** Functions of time from what a user would write, so that tests of sources read like parameter files. */
namespace magmpm::testing
{
  template <int dim>
  inline TimeFunction<Vector<dim>>
  vector(const std::string &text)
  {
    return read_expression<dim>(text, "test");
  }

  inline TimeFunction<double>
  number(const std::string &text)
  {
    return read_scalar_expression(text, "test");
  }

  template <int dim>
  inline TimeFunction<Pose<dim>>
  at(const std::string &position, const std::string &rotation = dim == 3 ? "0; 0; 0" : "0")
  {
    return pose_function(vector<dim>(position), vector<n_axial_components<dim>>(rotation));
  }
} // namespace magmpm::testing
