#pragma once

namespace magmpm
{
  /** How a run deals with what an earlier one left in its output directory. */
  enum class Start
  {
    afresh,    ///< refused if a checkpoint lies there; other results are replaced
    overwrite, ///< all results of the earlier run are replaced
    resume     ///< goes on from the latest checkpoint
  };
} // namespace magmpm
