#pragma once

#include <magmpm/surface/volume_fraction.h>

#include <deque>

namespace magmpm
{
  /**
   * The volume fractions of a step, each found when somebody asks for it first, and kept for all who ask
   * after him until particles move.
   */
  template <int dim>
  class MaterialFields
  {
  public:
    /** All of these must outlive this object. */
    MaterialFields(const BlockPartition<dim> &partition,
                   const Lattice<dim> &lattice,
                   const std::vector<Body<dim>> &bodies);

    /** The volume_fraction() of the selected material; valid until forget(). Collective. */
    const NodeField<dim, SingleScalar> &
    volume_fraction(const MaterialSelection &selection);

    /** To be called when particles have moved, or changed their volume, or the blocks are others. */
    void
    forget();

  private:
    struct Answer
    {
      MaterialSelection selection;
      NodeField<dim, SingleScalar> field;
    };

    const BlockPartition<dim> &partition;
    const Lattice<dim> lattice;
    const std::vector<Body<dim>> &bodies;
    std::deque<Answer> answers; ///< a deque, since fields must stay where they are
  };
} // namespace magmpm
