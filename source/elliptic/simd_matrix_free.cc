// deal.II's MatrixFree for the SIMD lanes of simd_lanes.h, from its templates. The one file that
// includes them: others see declarations only, and the linker finds here what the compiled deal.II
// has for its own lanes.

// Of the kernels for degrees known at run time: those of the mapping (1) and hanging nodes (2).
#define FE_EVAL_FACTORY_DEGREE_MAX 2

#include <magmpm/elliptic/simd_lanes.h>

#if MAGMPM_SIMD_BITS > 0

#  include <deal.II/matrix_free/dof_info.templates.h>
#  include <deal.II/matrix_free/evaluation_template_factory.templates.h>
#  include <deal.II/matrix_free/evaluation_template_factory_hanging_nodes.templates.h>
#  include <deal.II/matrix_free/mapping_info.templates.h>
#  include <deal.II/matrix_free/mapping_info_storage.templates.h>
#  include <deal.II/matrix_free/matrix_free.templates.h>
#  include <deal.II/matrix_free/shape_info.templates.h>

DEAL_II_NAMESPACE_OPEN

namespace internal
{
  // Needed for the mapping on faces, which a potential without face integrals never asks for.
  template <int dim, typename Number>
  void
  FEFaceEvaluationFactory<dim, Number>::evaluate(const unsigned int,
                                                 const EvaluationFlags::EvaluationFlags,
                                                 const Number *,
                                                 FEEvaluationData<dim, Number, true> &)
  {
    AssertThrow(false, ExcNotImplemented());
  }
} // namespace internal

#  define MAGMPM_INSTANTIATE(dim, Number)                                                      \
    template class MatrixFree<dim, Number, magmpm::CellLanes<Number>>;                         \
    template void MatrixFree<dim, Number, magmpm::CellLanes<Number>>::internal_reinit<double>( \
      const std::shared_ptr<hp::MappingCollection<dim>> &,                                     \
      const std::vector<const DoFHandler<dim> *> &,                                            \
      const std::vector<const AffineConstraints<double> *> &,                                  \
      const std::vector<IndexSet> &,                                                           \
      const std::vector<hp::QCollection<dim>> &,                                               \
      const AdditionalData &);                                                                 \
    template struct internal::                                                                 \
      FEEvaluationHangingNodesFactory<dim, Number, magmpm::CellLanes<Number>>;

MAGMPM_INSTANTIATE(2, double)
MAGMPM_INSTANTIATE(3, double)
MAGMPM_INSTANTIATE(2, float)
MAGMPM_INSTANTIATE(3, float)

DEAL_II_NAMESPACE_CLOSE

#endif
