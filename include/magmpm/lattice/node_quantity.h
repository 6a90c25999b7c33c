#pragma once

#include <magmpm/lattice/lattice.h>

#include <algorithm>

namespace magmpm
{
  /**
   * A scalar on the nodes of fields that hold @p Quantities, a list such as NodeMotion: its lane among
   * the numbers of a node. It is a key that opens the fields of its own list alone.
   */
  template <typename Quantities>
  struct NodeScalar
  {
    int lane;
  };

  /** A vector, likewise: the lane of its first component. */
  template <typename Quantities>
  struct NodeVector
  {
    int lane;
  };

  /** Momentum [kg m/s], later velocity [m/s], and mass [kg]: what P2G and G2P, in rows of four lanes, go by. */
  struct NodeMotion
  {
    static constexpr NodeVector<NodeMotion> momentum = {0};
    static constexpr NodeVector<NodeMotion> velocity = {0};
    static constexpr NodeScalar<NodeMotion> mass     = {n_lanes - 1};

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(velocity);
      f(mass);
    }
  };

  /** One scalar, or one vector, of which the name of the field says what it is. */
  struct SingleScalar
  {
    static constexpr NodeScalar<SingleScalar> value = {0};

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(value);
    }
  };

  struct SingleVector
  {
    static constexpr NodeVector<SingleVector> value = {0};

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(value);
    }
  };

  /**
   * The magnetic content of a cell around each node, sums over particles of N_i V_0 {J, M_s, chi_0, n}
   * over dx^dim.
   */
  struct NodeContent
  {
    static constexpr NodeScalar<NodeContent> volume         = {0}; ///< fraction [-]
    static constexpr NodeScalar<NodeContent> saturation     = {1}; ///< of the magnetization [A/m]
    static constexpr NodeScalar<NodeContent> susceptibility = {2}; ///< initial one [-]
    static constexpr NodeScalar<NodeContent> grains         = {3}; ///< [1/m^3]

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(volume);
      f(saturation);
      f(susceptibility);
      f(grains);
    }
  };

  /**
   * What solids near surfaces leave on nodes, so that contact acts where they touch (solid_contact.h): sums
   * over particles of N_i e^(-s/eps) and N_i e^(-s/eps) s, with the gap s of a particle; and of
   * J V_0 grad N_i, N_i m, N_i J V_0 and N_i J V_0 (lambda + 2 mu).
   */
  struct ContactSums
  {
    /** Of the gaps to the walls across an axis; to the nearest rigid body. */
    static constexpr int nearest_body = 3;

    static constexpr NodeScalar<ContactSums>
    weight(const int surface)
    {
      return {2 * surface};
    }

    /** [m] */
    static constexpr NodeScalar<ContactSums>
    weighted_gap(const int surface)
    {
      return {2 * surface + 1};
    }

    static constexpr NodeVector<ContactSums> volume_gradient = {8};  ///< outward [m^(dim-1)]
    static constexpr NodeScalar<ContactSums> mass            = {11}; ///< of solids [kg]
    static constexpr NodeScalar<ContactSums> volume          = {12}; ///< [m^dim]
    static constexpr NodeScalar<ContactSums> stiffness       = {13}; ///< [Pa m^dim]

    /** With the weights of the nearest body: normal n, and distance d less n.x, of the plane of the surface. */
    static constexpr NodeVector<ContactSums> normal = {14};
    static constexpr NodeScalar<ContactSums> plane  = {17}; ///< [m]

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      for (int surface = 0; surface <= nearest_body; ++surface)
        {
          f(weight(surface));
          f(weighted_gap(surface));
        }
      f(volume_gradient);
      f(mass);
      f(volume);
      f(stiffness);
      f(normal);
      f(plane);
    }
  };

  /**
   * What the lanes of a node hold, for what treats all fields alike: the exchange between ranks, images
   * behind walls, filters.
   */
  struct NodeLayout
  {
    static constexpr int max_lanes = 20;

    /** A number for each lane: the component of a vector, or one of these. */
    static constexpr int unused = -2, scalar = -1;

    int n_lanes                           = 0; ///< stored on a node
    int n_used                            = 0; ///< of them
    std::array<int, max_lanes> components = {};
  };

  /** The layout of a list of quantities. */
  template <int dim, typename Quantities>
  class MakeNodeLayout
  {
  public:
    static constexpr NodeLayout
    make()
    {
      MakeNodeLayout maker;
      for (int &component : maker.layout.components)
        component = NodeLayout::unused;
      Quantities::for_each(maker);
      return maker.layout;
    }

    constexpr void
    operator()(const NodeScalar<Quantities> scalar)
    {
      add(scalar.lane, NodeLayout::scalar);
    }

    constexpr void
    operator()(const NodeVector<Quantities> vector)
    {
      for (int d = 0; d < dim; ++d)
        add(vector.lane + d, d);
    }

  private:
    NodeLayout layout = {};

    constexpr void
    add(const int lane, const int component)
    {
      layout.components[lane] = component;
      layout.n_lanes          = std::max(layout.n_lanes, lane + 1);
      ++layout.n_used;
    }
  };

  template <int dim, typename Quantities>
  inline constexpr NodeLayout node_layout = MakeNodeLayout<dim, Quantities>::make();
} // namespace magmpm
