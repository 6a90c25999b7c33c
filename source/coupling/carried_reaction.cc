#include <magmpm/coupling/carried_reaction.h>
#include <magmpm/parallel/numbers.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    constexpr double largest_change = 0.5; // as of the force on particles

    template <int dim>
    constexpr int n_numbers = dim + n_axial_components<dim>;

    /** The rate of the components from @p first to before @p last, with their change limited. */
    void
    set_rate(const std::vector<double> &before,
             const int first,
             const int last,
             const double way,
             CarriedReactions &reactions)
    {
      double size = 0., change = 0.;
      for (int i = first; i < last; ++i)
        {
          size += reactions.now[i] * reactions.now[i];
          change += (reactions.now[i] - before[i]) * (reactions.now[i] - before[i]);
        }
      const double allowed = largest_change * std::sqrt(size);
      const double factor  = std::sqrt(change) > allowed ? allowed / std::sqrt(change) : 1.;
      for (int i = first; i < last; ++i)
        reactions.rate[i] = factor * (reactions.now[i] - before[i]) / way;
    }
  } // namespace

  template <int dim>
  void
  set_reactions(std::vector<ForceAndTorque<dim>> found,
                const double way,
                CarriedReactions &reactions)
  {
    // What the last solve found.
    advance_reactions(-way, reactions);
    const std::vector<double> before = reactions.now;

    reactions.now.clear();
    parallel::for_each_number(found, [&](const double number) { reactions.now.push_back(number); });
    reactions.rate.assign(reactions.now.size(), 0.);
    if (!(way > 0.) || before.size() != reactions.now.size())
      return;
    for (int i = 0; i < static_cast<int>(before.size()); i += n_numbers<dim>)
      {
        set_rate(before, i, i + dim, way, reactions);
        set_rate(before, i + dim, i + n_numbers<dim>, way, reactions);
      }
  }

  void
  advance_reactions(const double way, CarriedReactions &reactions)
  {
    for (std::size_t i = 0; i < reactions.now.size(); ++i)
      reactions.now[i] += way * reactions.rate[i];
  }

  void
  hold_reactions(const double way, CarriedReactions &reactions)
  {
    advance_reactions(-way, reactions);
    std::fill(reactions.rate.begin(), reactions.rate.end(), 0.);
  }

  template <int dim>
  ForceAndTorque<dim>
  reaction_on(const std::size_t source, const CarriedReactions &reactions)
  {
    ForceAndTorque<dim> result = {};
    std::size_t next           = source * n_numbers<dim>;
    if (next < reactions.now.size())
      parallel::for_each_number(result, [&](double &number) { number = reactions.now[next++]; });
    return result;
    for (int d = 0; d < dim; ++d)
      result.force[d] = reactions.now[first + d];
    for (int k = 0; k < n_axial_components<dim>; ++k)
      result.torque[k] = reactions.now[first + dim + k];
    return result;
  }

#define INSTANTIATE(dim)                                                                           \
  template void set_reactions(std::vector<ForceAndTorque<dim>>, const double, CarriedReactions &); \
  template ForceAndTorque<dim> reaction_on(const std::size_t, const CarriedReactions &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
