#pragma once

#include <magmpm/lattice/lattice_node.h>
#include <magmpm/lattice/node_field.h>

#include <array>
#include <vector>

namespace magmpm
{
  /** Nodes that are given what stands elsewhere, such as the image of it behind a surface. */
  template <int dim>
  class NodeImages
  {
  public:
    struct Image
    {
      LatticeNode node; ///< an owned one
      std::array<LatticeNode, power(2, dim)> originals;
      std::array<double, power(2, dim)> weights; ///< of the originals; they sum to one, or are zero
    };

    void
    add(const Image &image)
    {
      images.push_back(image);
    }

    /** Gives all lanes of the nodes the weighted sum of the originals, which are no images. */
    void
    fill(NodeNumbers<dim> &field) const
    {
      for (const Image &image : images)
        for (int lane = 0; lane < field.layout().n_lanes; ++lane)
          {
            double sum = 0.;
            for (std::size_t i = 0; i < image.originals.size(); ++i)
              if (image.weights[i] != 0.)
                sum += image.weights[i] *
                       field.node(image.originals[i].slot, image.originals[i].number)[lane];
            field.node(image.node.slot, image.node.number)[lane] = sum;
          }
    }

  private:
    std::vector<Image> images;
  };
} // namespace magmpm
