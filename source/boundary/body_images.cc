#include <magmpm/boundary/body_images.h>
#include <magmpm/boundary/body_share.h>
#include <magmpm/lattice/node_window.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** How far below a surface nodes have images that count, and how far from nodes these are, in dx. */
    constexpr double deepest_image  = 4.;
    constexpr double farthest_image = 4.;
  } // namespace

  double
  cosine_of_angle(const double angle)
  {
    constexpr double degree = 3.14159265358979323846 / 180.;
    return angle == 90. ? 0. : std::cos(degree * angle);
  }

  template <int dim>
  BodyImages<dim>::BodyImages(const std::vector<RigidBody<dim>> &bodies,
                              const BlockSet<dim> &blocks,
                              const Lattice<dim> &lattice)
    : share(blocks.size())
    , wetting(blocks.size())
    , lattice(lattice)
  {
    for (const RigidBody<dim> &body : bodies)
      is_wetted = is_wetted || (body.contact().condition != ContactCondition::none &&
                                cosine_of_angle(body.contact().contact_angle) != 0.);
    for_nodes(blocks, [&](const int slot, const int n) {
      look_at(bodies, lattice.node_position(node_of_block<dim>(blocks.block(slot), n)), {slot, n});
    });
  }

  template <int dim>
  void
  BodyImages<dim>::look_at(const std::vector<RigidBody<dim>> &bodies,
                           const Vector<dim> &position,
                           const LatticeNode &node)
  {
    const double dx            = lattice.spacing;
    SurfaceDistance<dim> least = {bspline_reach * dx, {}};
    double in_all = 0., wetted = 0.;
    for (const RigidBody<dim> &body : bodies)
      if (body.contact().condition != ContactCondition::none &&
          body.is_near(position, bspline_reach * dx))
        {
          const SurfaceDistance<dim> found = body.surface_distance(position);
          const double part                = share_inside(found.distance / dx);
          in_all += part;
          wetted += part * cosine_of_angle(body.contact().contact_angle);
          if (found.distance < least.distance)
            least = found;
        }
    share.set(SingleScalar::value, node.slot, node.number, in_all);
    wetting.set(SingleScalar::value, node.slot, node.number, wetted);
    const double depth = -least.distance;
    if (!is_in_front(node) && depth >= 0. && depth <= deepest_image * dx)
      inside.push_back({node, position + std::min(2. * depth, farthest_image * dx) * least.normal});
  }

  template <int dim>
  bool
  BodyImages<dim>::is_in_front(const LatticeNode &node) const
  {
    constexpr double rounding = 1e-9; // of a node on the surface
    return share.get(SingleScalar::value, node.slot, node.number) <= 0.5 + rounding;
  }

  template <int dim>
  NodeImages<dim>
  BodyImages<dim>::images(const BlockSet<dim> &blocks) const
  {
    NodeImages<dim> images;
    for (const Reflected &reflected : inside)
      images.add(image_of(reflected, blocks));
    return images;
  }

  template <int dim>
  typename NodeImages<dim>::Image
  BodyImages<dim>::image_of(const Reflected &reflected, const BlockSet<dim> &blocks) const
  {
    typename NodeImages<dim>::Image image = {reflected.node, {}, {}};
    const Vector<dim> x                   = lattice.reduced(reflected.place);
    double sum                            = 0.;
    for (std::size_t i = 0; i < image.weights.size(); ++i)
      {
        Index<dim> node;
        double weight = 1.;
        for (int d = 0; d < dim; ++d)
          {
            const int upper = static_cast<int>(i >> d) & 1;
            const double at = std::floor(x[d]);
            node[d]         = static_cast<int>(at) + upper;
            weight *= (upper == 1 ? x[d] - at : 1. - x[d] + at);
          }
        image.originals[i] = lattice_node<dim>(blocks, node);
        const bool counts  = image.originals[i].slot != invalid_slot &&
                            is_in_front(image.originals[i]);
        image.weights[i] = (counts ? weight : 0.);
        sum += image.weights[i];
      }
    for (double &weight : image.weights)
      weight = (sum > 0. ? weight / sum : 0.);
    return image;
  }

  template class BodyImages<2>;
  template class BodyImages<3>;
} // namespace magmpm
