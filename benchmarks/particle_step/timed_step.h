#pragma once

#include <particle_step/falling_block.h>

#include <array>
#include <memory>
#include <vector>

namespace magmpm::benchmarks
{
  enum class Phase : int
  {
    sort,
    p2g,
    lattice,
    g2p
  };

  inline constexpr int n_phases = 4;

  inline constexpr std::array<const char *, n_phases> phase_names = {
    {"sort", "P2G", "lattice", "G2P"}};

  /** Seconds spent in each phase. */
  struct PhaseTimes
  {
    std::array<double, n_phases> seconds = {};

    double
    total() const;
  };

  /** One way of advancing the particles of a block, phase by phase. */
  class TimedStep
  {
  public:
    virtual ~TimedStep() = default;

    virtual void
    run(const Phase phase) = 0;
  };

  /** The plain loops of plain_particles.h. */
  std::unique_ptr<TimedStep>
  make_plain_step(const FallingBlock &block);

  /** The kernels of magmpm on one rank. @param transfer  FMPM for solids only; the plain loops have APIC. */
  std::unique_ptr<TimedStep>
  make_kernel_step(const FallingBlock &block, const Transfer transfer = Transfer::apic);

  /** Sorts once, then takes steps. */
  PhaseTimes
  time_of_steps(TimedStep &step, const int n_steps);

  /** The least and the median of several values. */
  struct Spread
  {
    double least, median;
  };

  Spread
  spread(std::vector<double> values);
} // namespace magmpm::benchmarks
