#pragma once

#include <magmpm/boundary/solid_contact.h>
#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/lattice/wall_columns.h>

#include <vector>

namespace magmpm
{
  /**
   * Walls as mirrors. A particle within dx/2 of a wall reaches a node behind it. What it gives to that node
   * belongs, as the gift of the particle's image, to the node in front,
   *   m_1 <- m_1 + m_-1,   (m v)_1 <- (m v)_1 + R (m v)_-1,   and in G2P   v_-1 = R v_1,
   * where R turns around the velocity normal to the wall, or, where material sticks, all of it. So a
   * B-spline that the wall cuts has its full support: N_1 - N_-1 for what is turned around and N_1 + N_-1
   * for the rest; a clamp is where the wall is, and a floor carries the pressure of what stands on it.
   *
   * At walls that stick all material has images. At those that slip or separate fluids have: solids touch them
   * by their gap (solid_contact.h), and where these are the larger part of a node on the wall its column is
   * left to them. There are no images either where a fluid leaves a wall that separates.
   */
  template <int dim>
  class WallImages
  {
  public:
    /** @param has_fluids  without them slipping and separating walls need no images. */
    WallImages(const Lattice<dim> &lattice,
               const WallParameters<dim> &walls,
               const bool has_fluids);

    /**
     * Folds at walls that stick. It is linear, so on what one rank's particles gave, on owned nodes and ghosts,
     * before they are summed over the ranks.
     */
    void
    fold_sticking(const BlockSet<dim> &blocks, NodeField<dim> &momentum) const;

    /** Whether there are walls at which it depends on the motion whether there are images. */
    bool
    are_chosen() const
    {
      return any_chosen;
    }

    /**
     * Chooses the images at walls that slip or separate, and folds there. Where a wall separates a fluid leaves
     * if the node on it, alone, moves inward after forces.
     *
     * @param contact        with sums of solids; ghosts up to date.
     * @param velocity_gain  by gravity in a step [m/s].
     * @param momentum       summed over ranks, ghosts up to date.
     */
    void
    choose_and_fold(const BlockSet<dim> &blocks,
                    const SolidContact<dim> &contact,
                    const Vector<dim> &velocity_gain,
                    NodeField<dim> &momentum);

    /** Folds another field where choose_and_fold() did. Ghosts up to date. */
    void
    fold_chosen(NodeField<dim> &momentum) const;

    /** Gives nodes behind walls, those of ghosts too, the image of the velocity in front. Ghosts up to date. */
    void
    unfold(const BlockSet<dim> &blocks, NodeField<dim> &velocity) const;

  private:
    /** A line with images, and across which face. */
    struct ChosenColumn
    {
      WallColumn column;
      int face;
    };

    /** R of a face. */
    Vector<dim>
    reflected(const int face, Vector<dim> vector) const;

    void
    fold(const WallColumn &column, const int face, NodeField<dim> &momentum) const;

    void
    unfold(const WallColumn &column, const int face, NodeField<dim> &velocity) const;

    /** Whether what is at a node on a wall that separates leaves it. */
    bool
    leaves(const LatticeNode &on_wall,
           const int face,
           const Vector<dim> &velocity_gain,
           const NodeField<dim> &momentum) const;

    bool
    is_chosen(const int face) const
    {
      return any_chosen && walls.condition[face] != WallCondition::stick &&
             walls.condition[face] != WallCondition::open;
    }

    const Lattice<dim> lattice;
    const WallParameters<dim> walls;
    bool any_chosen = false;
    std::vector<ChosenColumn> chosen;
  };
} // namespace magmpm
