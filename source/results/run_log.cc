#include <magmpm/base/exceptions.h>
#include <magmpm/base/number_text.h>
#include <magmpm/base/simd.h>
#include <magmpm/base/version.h>
#include <magmpm/particles/make_material.h>
#include <magmpm/results/run_log.h>
#include <magmpm/results/run_outputs.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <streambuf>

namespace magmpm
{
  namespace
  {
    constexpr unsigned int n_recent_frames = 10;

    double
    seconds_between(const std::chrono::steady_clock::time_point from,
                    const std::chrono::steady_clock::time_point to)
    {
      return std::chrono::duration<double>(to - from).count();
    }

    /** "elastic, wave speed 23 m/s", "fluid, sound speed 32 m/s, viscosity 1 Pa s". */
    std::string
    mechanics_of(const RunLog::Body &body)
    {
      // It is the same in 2D: plane strain.
      const double wave_speed =
        undeformed_wave_speed(make_material<3>(body.material, body.density));
      if (body.material.law == MechanicalLaw::neo_hookean)
        return "elastic, wave speed " + with_prefix(wave_speed, "m/s");
      return "fluid, sound speed " + with_prefix(wave_speed, "m/s") + ", viscosity " +
             with_prefix(body.material.viscosity, "Pa s");
    }

    /** "Langevin, chi_0 = 0.91, saturation 82 kA/m", "linear, chi = 0.91", "not magnetic". */
    std::string
    magnetics_of(const RunLog::Body &body)
    {
      const MagneticParameters &magnetic = body.material.magnetic;
      if (!magnetic.is_magnetic())
        return "not magnetic";

      const std::string susceptibility = three_digits(magnetic.initial_susceptibility);
      if (body.magnetization_law == MagnetizationLaw::linear)
        return "linear, chi = " + susceptibility;
      if (body.magnetization_law == MagnetizationLaw::table)
        return "from a curve, chi_0 = " + susceptibility + ", saturation " +
               with_prefix(magnetic.saturation_magnetization, "A/m");
      return "Langevin, chi_0 = " + susceptibility + ", saturation " +
             with_prefix(magnetic.saturation_magnetization, "A/m");
    }

    /** Digits after the point of t that tell one frame from the next, and one more. */
    int
    decimals_of_time(const double frame_interval)
    {
      return std::max(1, static_cast<int>(std::ceil(-std::log10(frame_interval))) + 1);
    }
  } // namespace

  /** A stream buffer without memory: every character goes to two others. */
  class RunLog::Splitter : public std::streambuf
  {
  public:
    Splitter(std::streambuf *first, std::streambuf *second)
      : first(first)
      , second(second)
    {
    }

  private:
    int
    overflow(const int character) override
    {
      if (character == traits_type::eof())
        return traits_type::not_eof(character);
      first->sputc(static_cast<char>(character));
      second->sputc(static_cast<char>(character));
      return character;
    }

    int
    sync() override
    {
      const int first_result = first->pubsync();
      return (second->pubsync() == 0 && first_result == 0) ? 0 : -1;
    }

    std::streambuf *first, *second;
  };

  RunLog::RunLog(const MPI_Comm communicator,
                 const std::string &directory,
                 const unsigned int n_frames,
                 const double frame_interval,
                 std::ostream &terminal,
                 const bool resumes)
    : n_frames(n_frames)
    , frame_interval(frame_interval)
    , directory(directory)
    , start(Clock::now())
    , frame_ends{start}
  {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &n_ranks);
    if (rank == 0)
      {
        if (!resumes)
          std::ofstream(path(), std::ios::trunc);
        // At the end, wherever that is by then: a rank that fails writes there, too.
        file.open(path(), std::ios::app);
        if (!file)
          throw RunError("The log '" + path() + "' cannot be opened for writing. Is there such a " +
                         "folder, and are you allowed to write there?");
        splitter = std::make_unique<Splitter>(terminal.rdbuf(), file.rdbuf());
      }
    // A stream without a buffer swallows everything.
    both = std::make_unique<std::ostream>(splitter.get());
  }

  RunLog::~RunLog() = default;

  std::ostream &
  RunLog::stream()
  {
    return *both;
  }

  void
  RunLog::header(const Scene &scene)
  {
    *both << version_string() << ", " << simd_instruction_set << ", " << n_ranks
          << (n_ranks == 1 ? " rank" : " ranks") << '\n'
          << "  " << scene.dimension
          << "D, lattice dx = " << with_prefix(scene.lattice_spacing, "m") << ", "
          << with_separators(scene.n_particles) << " particles, ";
    if (scene.potential_unknowns > 0)
      *both << with_separators(scene.potential_unknowns) << " potential unknowns";
    else
      *both << "nothing magnetic: no potential";
    if (scene.memory > 0.)
      *both << ", " << std::lround(scene.memory / 1e6) << " MB";
    if (n_ranks > 1)
      *both << ", load imbalance " << three_digits(scene.imbalance);
    *both << '\n';

    for (const Body &body : scene.bodies)
      *both << "  " << body.name << ": " << with_separators(body.n_particles) << " particles, "
            << mechanics_of(body) << "; " << magnetics_of(body) << '\n';
#ifdef DEBUG
    warning("this is a DEBUG build: it checks itself and is many times slower. For results, build "
            "a Release (cmake -DCMAKE_BUILD_TYPE=Release).");
#endif
    *both << std::flush;

    has_potential = (scene.potential_unknowns > 0);
    // What came before (seeding, the first mesh) shall not count as part of the first frame.
    frame_ends = {Clock::now()};
  }

  double
  RunLog::seconds_per_frame() const
  {
    return seconds_between(frame_ends.front(), frame_ends.back()) / (frame_ends.size() - 1);
  }

  void
  RunLog::frame(const Frame &frame)
  {
    frame_ends.push_back(Clock::now());
    if (frame_ends.size() > n_recent_frames + 1)
      frame_ends.pop_front();
    const double n_left = n_frames > frame.number ? n_frames - frame.number : 0.;

    std::ostringstream line;
    line << "frame " << std::setw(std::to_string(n_frames).size()) << frame.number << '/'
         << n_frames << ' ' << std::setw(3) << (100ul * frame.number) / std::max(n_frames, 1u)
         << " %  t = " << std::fixed << std::setprecision(decimals_of_time(frame_interval))
         << frame.time << " s  dt = " << std::setw(6) << scientific(frame.dt) << " s " << std::left
         << std::setw(11) << '(' + frame.limit + ')' << std::right;
    if (frame.n_solves > 0)
      line << "  Newton " << std::setw(2) << frame.newton << ", CG " << std::setw(3) << frame.cg;
    else if (has_potential)
      line << "  field unchanged  ";
    line << "  |v| < " << std::setw(6) << three_digits(frame.max_speed) << " m/s  ";
    line << std::setw(5) << three_digits(seconds_per_frame()) << " s/frame";
    if (n_left > 0.)
      line << ", about " << duration(n_left * seconds_per_frame()) << " left";
    *both << line.str() << std::endl;
  }

  void
  RunLog::rebalanced(const double imbalance_before, const double imbalance)
  {
    message("load imbalance " + three_digits(imbalance_before) + " on " + std::to_string(n_ranks) +
            " ranks: cells and particles dealt out anew, now " + three_digits(imbalance));
  }

  void
  RunLog::message(const std::string &text)
  {
    *both << "  " << text << std::endl;
  }

  void
  RunLog::warning(const std::string &text)
  {
    *both << "WARNING: " << text << std::endl;
  }

  std::string
  RunLog::path() const
  {
    return directory + "/log.txt";
  }

  void
  RunLog::end(const std::vector<RunOutput> &others)
  {
    *both << "finished in " << duration(seconds_between(start, Clock::now())) << "; results in "
          << directory << '\n';
    if (!splitter)
      return;

    std::vector<RunOutput> outputs = run_outputs();
    outputs.insert(outputs.end(), others.begin(), others.end());
    for (const RunOutput &output : outputs)
      if (std::filesystem::exists(std::filesystem::path(directory) / output.name))
        *both << "  " << std::left << std::setw(18) << output.name << output.meaning << '\n';
    *both << std::right << std::flush;
  }
} // namespace magmpm
