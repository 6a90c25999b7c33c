#pragma once

#include <magmpm/elliptic/elliptic_medium.h>
#include <magmpm/lattice/lattice_cells.h>
#include <magmpm/magnetics/laminate.h>
#include <magmpm/magnetics/magnetics_parameters.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/surface/sharp_indicator.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace magmpm
{
  /**
   * The magnetic medium at one point in each octant of the mesh cells, those of QGauss(2): what the
   * potential problem knows of material. Content comes from node fields through quadratic B-splines of
   * spacing dx, as the mean over the octant; the field of the sources is evaluated at the point, and only
   * where material is.
   *
   * With the sharp indicator a point is a laminate of a fraction f of material and vacuum, with layers
   * across nu = grad v/|grad v|; content is that of the material, q P2G(..)/P2G(volume). What is pressed into
   * a solid source counts as all material does, in a field that goes on there (ContinuedField).
   *
   * With the smeared one it is all material, of the content that P2G spreads, as in the paper.
   */
  template <int dim>
  class MaterialPoints : public EllipticMedium<dim>
  {
  public:
    static constexpr unsigned int none = SharpIndicator<dim>::none;

    /** All of these must outlive this object. */
    MaterialPoints(const BackgroundMesh<dim> &mesh,
                   const BlockPartition<dim> &partition,
                   const MagneticsParameters<dim> &parameters);

    /**
     * Finds the cells with material among @p lattice_cells and evaluates medium and sources there.
     * Collective.
     *
     * @param lattice_cells  lower nodes of this rank's mesh cells of the finest edge.
     * @param content        on the nodes of the active blocks, with the images behind shielded walls,
     *                       ghosts updated.
     */
    void
    reinit(const std::vector<Index<dim>> &lattice_cells,
           const NodeField<dim, NodeContent> &content,
           const ExternalField<dim> &sources);

    bool
    is_linear() const override
    {
      return law.law == MagnetizationLaw::linear;
    }

    bool
    fills(const unsigned int lattice_cell) const override
    {
      return first_points[lattice_cell] != none;
    }

    /** p = -M(H_ext - grad phi), A = dM/dH; returns int psi, that of the laminate. */
    double
    respond(const unsigned int lattice_cell,
            const MediumResponse response,
            OctantVectors<dim> &flux,
            OctantMatrices<dim> &tangent) const override;

    double
    stabilization(const unsigned int lattice_cell) const override;

    double
    largest_weak_tangent() const override
    {
      return largest_susceptibility;
    }

    /** The rule of the points. */
    const CellQuadrature<dim, n_octants_1d> &
    quadrature() const
    {
      return rule;
    }

    /** The lattice cells. */
    const LatticeCells<dim> &
    cells() const
    {
      return the_cells;
    }

    /** Number of the first of the n_octants<dim> points of a lattice cell, or none where no material is. */
    unsigned int
    first_point(const unsigned int lattice_cell) const
    {
      return lattice_cell == none ? none : first_points[lattice_cell];
    }

    /** Points in cells with material. */
    unsigned int
    size() const
    {
      return static_cast<unsigned int>(points.size());
    }

    /** Values at several points at once, for the laws of the medium. */
    using Lanes = SimdDouble;

    /** The medium at some points of a cell, in the field of the sources plus their own. */
    struct Batch
    {
      Lanes fraction;                ///< f of the laminate
      Vector<dim, Lanes> self_field; ///< [A/m]
      LaminateResponse<dim, Lanes> response;
    };

    /**
     * Calls action(first, n, batch) for all points of a cell, numbers first to first + n - 1 of the cell
     * at a time in the lanes of @p batch; further lanes repeat the last.
     *
     * @param first_point  of the cell.
     * @param self_field   h at a point of the cell (0 .. n_octants - 1) [A/m].
     */
    template <typename SelfField, typename Action>
    void
    for_batches(const unsigned int first_point,
                const SelfField &self_field,
                const Action &action) const
    {
      for_batches(law, first_point, self_field, action);
    }

    /** The same with another law for the same content. */
    template <typename SelfField, typename Action>
    void
    for_batches(const MagnetizationModel &model,
                const unsigned int first_point,
                const SelfField &self_field,
                const Action &action) const
    {
      for (int first = 0; first < n_octants<dim>; first += Lanes::n_lanes)
        {
          const int n = std::min(Lanes::n_lanes, n_octants<dim> - first);
          Batch batch;
          MagneticContentOf<Lanes> content;
          Vector<dim, Lanes> normal, field;
          for (int lane = 0; lane < Lanes::n_lanes; ++lane)
            {
              const int q                                  = first + std::min(lane, n - 1);
              const Point &p                               = points[first_point + q];
              const Vector<dim> h                          = self_field(q);
              content.saturation_magnetization.lanes[lane] = p.content.saturation_magnetization;
              content.initial_susceptibility.lanes[lane]   = p.content.initial_susceptibility;
              batch.fraction.lanes[lane]                   = p.fraction;
              for (int d = 0; d < dim; ++d)
                {
                  batch.self_field[d].lanes[lane] = h[d];
                  normal[d].lanes[lane]           = p.normal[d];
                  field[d].lanes[lane]            = p.field[d] + h[d];
                }
            }
          batch.response = laminate_response(model, content, batch.fraction, normal, field);
          action(first, n, batch);
        }
    }

    /** f of the laminate: the part of the volume that is in its material phase. */
    double
    fraction(const unsigned int point) const
    {
      return points[point].fraction;
    }

    /** The part of the volume that is material, v for the smeared indicator and f for the sharp one. */
    double
    volume_fraction(const unsigned int point) const
    {
      return points[point].volume_fraction;
    }

    /** Grains per volume of the material [1/m^3]. */
    double
    number_density(const unsigned int point) const
    {
      return points[point].number_density;
    }

    /** The place of a point [m]. */
    const Vector<dim> &
    position(const unsigned int point) const
    {
      return points[point].position;
    }

    /** H~ of the sources (ContinuedField) [A/m]; zero at points without material. */
    const Vector<dim> &
    source_field(const unsigned int point) const
    {
      return points[point].field;
    }

    /** G~ of the sources, likewise [A/m^2]. */
    const Matrix<dim> &
    source_gradient(const unsigned int point) const
    {
      return points[point].gradient;
    }

    /** Sum over this rank's points of w |M(H of the sources)| {1, x}: weight and first moment. */
    std::pair<double, Vector<dim>>
    magnetized_weight() const
    {
      return {total_weight, first_moment};
    }

    /** What the indicator had to clip; unused with the smeared one. */
    const SharpIndicator<dim> &
    indicator() const
    {
      return the_indicator;
    }

  private:
    struct Point
    {
      MagneticContent content;
      double fraction        = 0.;
      double volume_fraction = 0.;
      double number_density  = 0.;
      Vector<dim> position;
      Vector<dim> normal;
      Vector<dim> field;
      Matrix<dim> gradient;
    };

    const BlockPartition<dim> &partition;
    const Lattice<dim> lattice;
    const MagnetizationModel law;
    const bool is_sharp;

    LatticeCells<dim> the_cells;
    const CellQuadrature<dim, n_octants_1d> rule;
    const CellQuadrature<dim, 2 * n_octants_1d>
      content_rule; ///< of whose points an octant has the mean
    SharpIndicator<dim> the_indicator;
    std::vector<unsigned int> first_points; ///< by cell
    std::vector<Point> points;
    double largest_susceptibility = 0.;
    double total_weight           = 0.;
    Vector<dim> first_moment;

    /** Gives points to cells with content, for the smeared indicator. */
    void
    find_smeared_cells(const NodeField<dim, NodeContent> &content);

    /** Content of the octants of a cell: the mean over each, smeared that at its point. */
    PointValues<dim, n_octants_1d>
    octant_content(const unsigned int cell, const NodeField<dim, NodeContent> &content) const;

    /** Completes the points of a cell. */
    void
    set_medium(const unsigned int cell,
               const NodeField<dim, NodeContent> &content,
               const ExternalField<dim> &sources);

    /** Adds a cell to magnetized_weight(). */
    void
    add_magnetized_weight(const unsigned int cell);
  };
} // namespace magmpm
