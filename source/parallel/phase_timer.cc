#include <magmpm/parallel/gather.h>
#include <magmpm/parallel/phase_timer.h>
#include <magmpm/parallel/reduce.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <ostream>
#include <sstream>

namespace magmpm::parallel
{
  namespace
  {
    using Clock = std::chrono::steady_clock;

    double
    seconds_since(const Clock::time_point start)
    {
      return std::chrono::duration<double>(Clock::now() - start).count();
    }

    /** The phases of all ranks; a phase may have been met on some of them only. Collective. */
    std::vector<std::string>
    phases_of_all_ranks(const MPI_Comm communicator, const std::vector<std::string> &phases)
    {
      std::string lines;
      for (const std::string &phase : phases)
        lines += phase + '\n';
      std::vector<std::string> all;
      for (const std::string &of_rank : all_gather(lines, communicator))
        {
          std::istringstream text(of_rank);
          for (std::string phase; std::getline(text, phase);)
            if (std::find(all.begin(), all.end(), phase) == all.end())
              all.push_back(phase);
        }
      return all;
    }

    /** One line of the table. @param seconds  by rank. */
    std::string
    row(const std::string &phase,
        const std::string &n_visits,
        const std::vector<double> &seconds,
        const double share,
        const std::size_t width)
    {
      const auto extremes = std::minmax_element(seconds.begin(), seconds.end());
      const double sum    = std::accumulate(seconds.begin(), seconds.end(), 0.);
      char text[120];
      std::snprintf(text,
                    sizeof(text),
                    " |%10s |%9.2f s %5d |%9.2f s |%9.2f s %5d |%6.1f %% |\n",
                    n_visits.c_str(),
                    *extremes.first,
                    static_cast<int>(extremes.first - seconds.begin()),
                    sum / seconds.size(),
                    *extremes.second,
                    static_cast<int>(extremes.second - seconds.begin()),
                    100. * share);
      return "| " + phase + std::string(width - phase.size(), ' ') + text;
    }
  } // namespace

  PhaseTimer::PhaseTimer()
    : start(Clock::now())
  {
  }

  PhaseTimer::Scope::Scope(PhaseTimer &timer, const std::string &phase)
    : phase(timer.phase(phase))
    , start(Clock::now())
  {
  }

  PhaseTimer::Scope::~Scope()
  {
    ++phase.n_visits;
    phase.seconds += seconds_since(start);
  }

  PhaseTimer::Phase &
  PhaseTimer::phase(const std::string &name)
  {
    const auto [entry, is_new] = phases.try_emplace(name);
    if (is_new)
      order.push_back(name);
    return entry->second; // stays where it is
  }

  std::map<std::string, double>
  PhaseTimer::seconds() const
  {
    std::map<std::string, double> result;
    for (const auto &[name, phase] : phases)
      if (phase.n_visits > 0)
        result[name] = phase.seconds;
    return result;
  }

  void
  PhaseTimer::print(const MPI_Comm communicator, std::ostream &stream) const
  {
    const std::vector<std::string> names = phases_of_all_ranks(communicator, order);
    std::vector<unsigned long> n_visits;
    std::vector<double> seconds = {seconds_since(start)};
    std::size_t width           = 8;
    for (const std::string &name : names)
      {
        const auto phase = phases.find(name);
        n_visits.push_back(phase == phases.end() ? 0 : phase->second.n_visits);
        seconds.push_back(phase == phases.end() ? 0. : phase->second.seconds);
        width = std::max(width, name.size());
      }
    n_visits                                       = max(n_visits, communicator);
    const std::vector<std::vector<double>> by_rank = all_gather(seconds, communicator);

    const auto of_ranks = [&by_rank](const std::size_t i) {
      std::vector<double> result;
      for (const std::vector<double> &of_rank : by_rank)
        result.push_back(of_rank[i]);
      return result;
    };
    const auto sum = [](const std::vector<double> &of_ranks) {
      return std::accumulate(of_ranks.begin(), of_ranks.end(), 0.);
    };
    const double total = sum(of_ranks(0));
    const std::string rule =
      "+" + std::string(width + 2, '-') +
      "+-----------+------------------+------------+------------------+---------+\n";
    stream << rule << "| wall time" << std::string(width - 8, ' ')
           << "|    visits |   minimum   rank |       mean |   maximum   rank |   share |\n"
           << rule << row("in all", "", of_ranks(0), 1., width);
    for (std::size_t i = 0; i < names.size(); ++i)
      stream << row(names[i],
                    std::to_string(n_visits[i]),
                    of_ranks(i + 1),
                    total > 0. ? sum(of_ranks(i + 1)) / total : 0.,
                    width);
    stream << rule << std::flush;
  }
} // namespace magmpm::parallel
