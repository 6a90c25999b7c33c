#include <magmpm/coupling/carried_reaction.h>
#include <magmpm/coupling/extrapolation.h>

namespace magmpm
{
  template <int dim>
  void
  CarriedReactions<dim>::note_solve(const double way)
  {
    way_since_set += way;
    is_up_to_date = false;
  }

  template <int dim>
  void
  CarriedReactions<dim>::set(const std::vector<ForceAndTorque<dim>> &found, const bool has_rate)
  {
    advance(-advanced);
    const std::vector<ForceAndTorque<dim>> before = now;

    now = found;
    rate.assign(found.size(), {});
    for (std::size_t s = 0; s < found.size() && has_rate && before.size() == found.size(); ++s)
      rate[s] = {extrapolation_rate(before[s].force, now[s].force, way_since_set),
                 extrapolation_rate(before[s].torque, now[s].torque, way_since_set)};
    way_since_set = 0.;
    is_up_to_date = true;
  }

  template <int dim>
  void
  CarriedReactions<dim>::advance(const double way)
  {
    for (std::size_t s = 0; s < now.size(); ++s)
      {
        now[s].force += way * rate[s].force;
        now[s].torque += way * rate[s].torque;
      }
    advanced += way;
  }

  template <int dim>
  void
  CarriedReactions<dim>::freeze()
  {
    advance(-advanced);
    rate.assign(now.size(), {});
  }

  template <int dim>
  ForceAndTorque<dim>
  CarriedReactions<dim>::on(const std::size_t source) const
  {
    return source < now.size() ? now[source] : ForceAndTorque<dim>();
  }

  template class CarriedReactions<2>;
  template class CarriedReactions<3>;
} // namespace magmpm
