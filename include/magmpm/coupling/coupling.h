#pragma once

#include <magmpm/coupling/column_table.h>
#include <magmpm/coupling/section.h>
#include <magmpm/coupling/step_conditions.h>
#include <magmpm/parallel/reduce.h>

#include <string>

namespace magmpm
{
  /**
   * What all couplings have in common besides their physics: limits of the time step, numbers that all
   * ranks must know, columns of the statistics, and a section of a checkpoint. Each owns its state.
   *
   * What a coupling does in a step is not here: Scene::step() calls it by name.
   */
  class Coupling
  {
  public:
    virtual ~Coupling() = default;

    /** Adds what of it limits the next step. */
    virtual void
    limit_step(StepConditions & /*conditions*/) const
    {
    }

    /**
     * Names the numbers of this step that concern all ranks. Those of all couplings go in one exchange
     * at the end of the step; take_reduced() follows.
     */
    virtual void
    reduce(parallel::Reduction & /*reduction*/)
    {
    }

    /** Draws conclusions from the numbers of all ranks. */
    virtual void
    take_reduced()
    {
    }

    /** Makes ready what a row of the statistics asks for. Collective. */
    virtual void
    prepare_row()
    {
    }

    /** A row was written: what counts from row to row begins anew. */
    virtual void
    end_row()
    {
    }

    /** Its columns of the statistics. The same whether a scene needs the coupling or not. */
    virtual void
    add_columns(ColumnTable & /*table*/) const
    {
    }

    /** A line on it for the log, when a scene has begun; empty if there is nothing to say. */
    virtual std::string
    description() const
    {
      return "";
    }

    /** Name and version of its section of a checkpoint. */
    virtual SectionTitle
    title() const = 0;

    /** Its state, packed; the same on all ranks. */
    virtual std::string
    save() const = 0;

    /** Takes the state that save() gave. */
    virtual void
    load(const std::string &bytes) = 0;
  };
} // namespace magmpm
