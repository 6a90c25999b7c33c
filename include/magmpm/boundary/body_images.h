#pragma once

#include <magmpm/boundary/rigid_body.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/lattice/node_images.h>

#include <vector>

namespace magmpm
{
  /**
   * Rigid bodies as mirrors of what is on nodes in front of them, whatever their shape: a node inside has the
   * image x + 2 d n in front, d its depth and n the normal. It is at most four nodes from it, as far as ghosts
   * reach: deeper nodes, of which no quantity next to the surface depends on much, look to x + 4 dx n.
   */
  template <int dim>
  class BodyImages
  {
  public:
    /** @param bodies  those with a surface count. */
    BodyImages(const std::vector<RigidBody<dim>> &bodies,
               const BlockSet<dim> &blocks,
               const Lattice<dim> &lattice);

    /** The part of the B-spline of owned nodes in bodies, share_inside(). Whoever asks for images updates ghosts. */
    NodeField<dim, SingleScalar> share;

    /** The same times the cosine of the contact angle. */
    NodeField<dim, SingleScalar> wetting;

    /** Whether any contact angle is another than 90 degrees. */
    bool
    are_wetted() const
    {
      return is_wetted;
    }

    /** Whether a node is in front of all bodies, or on their surface. */
    bool
    is_in_front(const LatticeNode &node) const;

    /** The images of nodes inside: by linear interpolation between nodes that are not. */
    NodeImages<dim>
    images(const BlockSet<dim> &blocks) const;

  private:
    /** A node inside a body, and where its image is. */
    struct Reflected
    {
      LatticeNode node;
      Vector<dim> place; ///< [m]
    };

    /** What bodies are at a node. */
    void
    look_at(const std::vector<RigidBody<dim>> &bodies,
            const Vector<dim> &position,
            const LatticeNode &node);

    typename NodeImages<dim>::Image
    image_of(const Reflected &reflected, const BlockSet<dim> &blocks) const;

    const Lattice<dim> lattice;
    bool is_wetted = false;
    std::vector<Reflected> inside;
  };

  /** @param angle  [degrees]; of a right one the cosine is zero, not 6e-17. */
  double
  cosine_of_angle(const double angle);
} // namespace magmpm
