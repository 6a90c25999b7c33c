#pragma once

#include <magmpm/elliptic/elliptic_space.h>

namespace magmpm
{
  /**
   * Where to start the next solve: the last two solutions continued, if their like was nearer to the
   * last one than the one before it; otherwise the last one. Of one mesh.
   */
  class StartingGuess
  {
  public:
    void
    record(const PotentialVector &solution)
    {
      if (n_solutions > 1)
        is_nearer = distance(solution, continued) < distance(solution, last);
      if (n_solutions > 0)
        {
          continued = solution;
          continued.sadd(2., -1., last);
        }
      last = solution;
      ++n_solutions;
    }

    void
    put_into(PotentialVector &potential) const
    {
      if (is_nearer)
        potential = continued;
    }

  private:
    int n_solutions = 0;
    bool is_nearer  = false;
    PotentialVector last, continued;

    static double
    distance(PotentialVector one, const PotentialVector &other)
    {
      one -= other;
      return one.l2_norm();
    }
  };
} // namespace magmpm
