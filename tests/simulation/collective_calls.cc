// How often the ranks wait for one another in a step: MPI's collective functions are replaced by some that
// count and call the real ones (MPI's profiling interface).

#include <magmpm/simulation/scene.h>

#include "../catch.h"

#include <verification/program/paths.h>

#include <mpi.h>

#include <map>
#include <string>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /** By the function's name without "MPI_", of all of this program. */
  std::map<std::string, int> &
  collective_calls()
  {
    static std::map<std::string, int> n_calls;
    return n_calls;
  }

  /** "2 Allreduce, 1 Barrier, " */
  std::string
  text_of(const std::map<std::string, int> &n_calls)
  {
    std::string text;
    for (const auto &[name, n] : n_calls)
      text += std::to_string(n) + " " + name + ", ";
    return text;
  }
} // namespace

#define COUNT_CALLS(name, parameters, arguments) \
  int MPI_##name parameters                      \
  {                                              \
    ++collective_calls()[#name];                 \
    return PMPI_##name arguments;                \
  }

extern "C"
{
  using Type = MPI_Datatype;

  COUNT_CALLS(Barrier, (MPI_Comm c), (c))
  COUNT_CALLS(Ibarrier, (MPI_Comm c, MPI_Request *r), (c, r))
  COUNT_CALLS(Bcast, (void *x, int n, Type t, int root, MPI_Comm c), (x, n, t, root, c))
  COUNT_CALLS(Reduce,
              (const void *x, void *y, int n, Type t, MPI_Op o, int root, MPI_Comm c),
              (x, y, n, t, o, root, c))
  COUNT_CALLS(Allreduce,
              (const void *x, void *y, int n, Type t, MPI_Op o, MPI_Comm c),
              (x, y, n, t, o, c))
  COUNT_CALLS(Iallreduce,
              (const void *x, void *y, int n, Type t, MPI_Op o, MPI_Comm c, MPI_Request *r),
              (x, y, n, t, o, c, r))
  COUNT_CALLS(Scan,
              (const void *x, void *y, int n, Type t, MPI_Op o, MPI_Comm c),
              (x, y, n, t, o, c))
  COUNT_CALLS(Exscan,
              (const void *x, void *y, int n, Type t, MPI_Op o, MPI_Comm c),
              (x, y, n, t, o, c))
  COUNT_CALLS(Gather,
              (const void *x, int n, Type t, void *y, int m, Type u, int root, MPI_Comm c),
              (x, n, t, y, m, u, root, c))
  COUNT_CALLS(Gatherv,
              (const void *x,
               int n,
               Type t,
               void *y,
               const int m[],
               const int d[],
               Type u,
               int root,
               MPI_Comm c),
              (x, n, t, y, m, d, u, root, c))
  COUNT_CALLS(Allgather,
              (const void *x, int n, Type t, void *y, int m, Type u, MPI_Comm c),
              (x, n, t, y, m, u, c))
  COUNT_CALLS(
    Allgatherv,
    (const void *x, int n, Type t, void *y, const int m[], const int d[], Type u, MPI_Comm c),
    (x, n, t, y, m, d, u, c))
  COUNT_CALLS(Alltoall,
              (const void *x, int n, Type t, void *y, int m, Type u, MPI_Comm c),
              (x, n, t, y, m, u, c))
}

TEST_CASE("A step waits once for all ranks", "[simulation][mpi]")
{
  // A falling block: nothing is solved for, no body is free, and three steps from rest do not lead to other
  // blocks. What is left is the reduction at the end of each step, sums and all: one call a step, while
  // setting the scene up takes many.
  Scene<3> scene(
    read_parameters<3>(read_parameter_file(source_folder() + "/parameter_files/falling_block.prm")),
    MPI_COMM_WORLD);
  scene.begin();
  CHECK(collective_calls()["Allreduce"] > 3);

  collective_calls().clear();
  for (int i = 0; i < 3; ++i)
    scene.step({1., true, {}});
  CHECK(text_of(collective_calls()) == "3 Allreduce, ");
}
