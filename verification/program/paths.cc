#include <verification/program/paths.h>

namespace magmpm::verification
{
  std::string
  source_folder()
  {
    return MAGMPM_SOURCE_DIR;
  }

  std::string
  magmpm_program()
  {
    return MAGMPM_EXECUTABLE;
  }

  std::string
  mpiexec()
  {
    return MAGMPM_MPIEXEC;
  }
} // namespace magmpm::verification
