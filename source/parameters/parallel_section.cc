#include <magmpm/parameters/parallel_section.h>

namespace magmpm
{
  void
  declare_ranks(ParameterRegister &declarations, double &imbalance_threshold)
  {
    const auto section = declarations.enter("Parallel");
    declarations.add("Imbalance threshold",
                     imbalance_threshold,
                     "-",
                     "Load of the most loaded rank over the mean above which cells and particles "
                     "are dealt out anew. The load is an estimate: a cell of the potential counts "
                     "as 30 particles.",
                     at_least_one);
  }
} // namespace magmpm
