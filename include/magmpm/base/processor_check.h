#pragma once

#include <cstddef>

namespace magmpm
{
  /*
   * A program compiled with -march=native dies of an illegal instruction on an older processor.
   * So the first code of the program to run, before all constructors, compares what the program was
   * compiled for with what the processor has; if something is missing, it says so in one sentence
   * on standard error and ends the program with exit code 1. On architectures other than x86-64 it
   * does nothing.
   */

  /** The extensions of x86-64 this program was compiled for ("avx2", ...); ends with a null. */
  extern const char *const compiled_instruction_sets[];

  /** Whether the processor that runs this has an extension; true for a name unknown to the check. */
  bool
  processor_has(const char *instruction_set);

  /**
   * Writes the names in @p required (null-terminated) that @p has denies into @p text, separated by
   * ", " and cut where @p size characters, the closing zero included, are full.
   *
   * @return how many are missing.
   */
  int
  list_missing_instruction_sets(const char *const *required,
                                bool (*has)(const char *),
                                char *text,
                                std::size_t size);
} // namespace magmpm
