#pragma once

#include <magmpm/particles/particle_state.h>

#include <cmath>

namespace magmpm
{
  /** cof A = det(A) A^-T: areas with their normals, where A maps what they bound (Nanson). */
  inline Matrix<2>
  cofactor(const Matrix<2> &matrix)
  {
    Matrix<2> result;
    result(0, 0) = matrix(1, 1);
    result(0, 1) = -matrix(1, 0);
    result(1, 0) = -matrix(0, 1);
    result(1, 1) = matrix(0, 0);
    return result;
  }

  inline Matrix<3>
  cofactor(const Matrix<3> &matrix)
  {
    Matrix<3> result;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        {
          const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
          result(i, j) = matrix(a, c) * matrix(b, d) - matrix(a, d) * matrix(b, c);
        }
    return result;
  }

  /** What a particle of a solid fills, as it is deformed. */
  template <int dim>
  class DeformedExtent
  {
  public:
    /** Of particle @p p. @param deformation  its F. */
    DeformedExtent(const ParticleArrays<dim, const double> &particles,
                   const Matrix<dim> &deformation,
                   const std::size_t p)
      : exposed_faces(static_cast<unsigned int>(particles.exposed_faces[p]))
    {
      Matrix<dim> half;
      for (int i = 0, c = 0; i < dim; ++i)
        for (int j = 0; j <= i; ++j, ++c)
          half(i, j) = half(j, i) = particles.half_extent[c][p];
      sides = deformation * half;
      areas = cofactor(sides);
    }

    /** How far it goes from the place of the particle along @p normal, sum_k |n . F H e_k| [m]. */
    double
    reach(const Vector<dim> &normal) const
    {
      double sum = 0.;
      for (int k = 0; k < dim; ++k)
        {
          double side = 0.;
          for (int d = 0; d < dim; ++d)
            side += normal[d] * sides(d, k);
          sum += std::abs(side);
        }
      return sum;
    }

    /**
     * How much of the body's surface on it looks against @p normal: sum over its exposed faces, with their areas
     * cof(F H) N, of max(0, -n . cof(F H) N) [m^(dim-1)]; and a thousandth of all its faces, so that
     * material that was not at the surface counts where nothing else is.
     */
    double
    facing(const Vector<dim> &normal) const
    {
      double sum = 1e-3 * frobenius_norm(areas);
      for (int k = 0; k < dim; ++k)
        {
          double along = 0.;
          for (int d = 0; d < dim; ++d)
            along += normal[d] * areas(d, k);
          const int towards = 2 * k + (along > 0. ? 0 : 1);
          if (exposed_faces & (1u << towards))
            sum += std::abs(along);
        }
      return sum;
    }

  private:
    unsigned int exposed_faces;
    Matrix<dim> sides; ///< F H [m]
    Matrix<dim> areas; ///< cof(F H): its columns are those of the faces [m^(dim-1)]
  };
} // namespace magmpm
