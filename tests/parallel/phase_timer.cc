#include "../catch.h"

#include <magmpm/parallel/phase_timer.h>
#include <magmpm/parallel/ranks.h>

#include <chrono>
#include <sstream>
#include <thread>

using namespace magmpm;
using parallel::PhaseTimer;

namespace
{
  void
  work_for(const int milliseconds)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  }
} // namespace

// Phases inside of one another are timed each by itself: the outer one is at least as long as the
// inner ones together. A phase that has not been left is not told yet.
TEST_CASE("Phases are timed, also inside of one another", "[parallel]")
{
  PhaseTimer timer;
  CHECK(timer.seconds().empty());
  {
    const PhaseTimer::Scope outer(timer, "solve");
    for (int i = 0; i < 2; ++i)
      {
        const PhaseTimer::Scope inner(timer, "solve: CG");
        work_for(5);
      }
    CHECK(timer.seconds().count("solve") == 0);
  }
  const auto seconds = timer.seconds();
  REQUIRE(seconds.size() == 2);
  CHECK(seconds.at("solve: CG") >= 0.01);
  CHECK(seconds.at("solve") >= seconds.at("solve: CG"));
}

// The time of a phase ends with its scope, however that is left: then the phase is listed.
TEST_CASE("A phase that an exception leaves is over", "[parallel]")
{
  PhaseTimer timer;
  try
    {
      const PhaseTimer::Scope scope(timer, "P2G");
      throw 1;
    }
  catch (const int)
    {
    }
  CHECK(timer.seconds().count("P2G") == 1);
}

// The table has a line for every phase of any rank, in the order of the program, with the ranks that
// were the fastest and the slowest: the last rank sleeps longer in P2G, and alone sends mail.
TEST_CASE("The table shows the ranks' least and most time", "[parallel][mpi]")
{
  const unsigned int rank = parallel::rank(MPI_COMM_WORLD);
  const unsigned int last = parallel::n_ranks(MPI_COMM_WORLD) - 1;
  PhaseTimer timer;
  for (const char *phase : {"Solve potential", "P2G"})
    {
      const PhaseTimer::Scope scope(timer, phase);
      work_for(rank == last ? 50 : 5);
    }
  if (rank == last)
    {
      const PhaseTimer::Scope scope(timer, "Mail");
    }
  std::ostringstream table;
  timer.print(MPI_COMM_WORLD, table);

  const std::string text = table.str();
  const auto solve = text.find("| Solve potential"), p2g = text.find("| P2G");
  REQUIRE(solve != std::string::npos);
  REQUIRE(p2g != std::string::npos);
  CHECK(solve < p2g);
  CHECK(text.find("| Mail") != std::string::npos);
  CHECK(text.find("| in all") < solve);

  std::istringstream line(text.substr(p2g + 1, text.find('\n', p2g) - p2g));
  std::string word, bar, s;
  int n_visits, slowest;
  double least, mean, most;
  unsigned int fastest;
  line >> word >> bar >> n_visits >> bar >> least >> s >> fastest >> bar >> mean >> s >> bar >>
    most >> s >> slowest;
  CHECK(n_visits == 1);
  CHECK(slowest == static_cast<int>(last));
  CHECK((last == 0 || fastest != last));
  CHECK(least <= mean);
  CHECK(mean <= most);
  CHECK(most >= 0.05);
}
