#include <deal.II/base/utilities.h>

#include <magmpm/base/version.h>
#include <magmpm/simulation/run_record.h>

#include <boost/serialization/utility.hpp>

namespace magmpm
{
  template <int dim>
  Checkpoint
  make_checkpoint(const RunRecord &record,
                  const std::string &parameters,
                  const std::vector<Body<dim>> &bodies)
  {
    Checkpoint checkpoint;
    checkpoint.version    = version_string();
    checkpoint.parameters = parameters;
    checkpoint.run        = dealii::Utilities::pack(record, false);
    for (const Body<dim> &body : bodies)
      {
        checkpoint.particles.emplace_back();
        for (std::size_t p = 0; p < body.particles.size(); ++p)
          body.particles.append_record(p, checkpoint.particles.back());
      }
    return checkpoint;
  }

  std::optional<RunRecord>
  run_record_of(const std::optional<Checkpoint> &checkpoint)
  {
    if (!checkpoint)
      return {};
    return dealii::Utilities::unpack<RunRecord>(checkpoint->run, false);
  }

  template Checkpoint
  make_checkpoint(const RunRecord &, const std::string &, const std::vector<Body<2>> &);
  template Checkpoint
  make_checkpoint(const RunRecord &, const std::string &, const std::vector<Body<3>> &);
} // namespace magmpm
