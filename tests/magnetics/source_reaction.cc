#include <magmpm/magnetics/source_reaction.h>
#include <magmpm/magnets/point_dipole.h>

#include "catch.h"

using namespace magmpm;

namespace
{
  template <int dim>
  SourceParameters<dim>
  dipole(const std::string &name, const Vector<dim> &position, const Vector<dim> &moment)
  {
    SourceParameters<dim> source;
    source.name = name;
    source.kind = PointDipoleParameters<dim>{moment, 0.01};
    source.pose = Pose<dim>{position};
    return source;
  }
} // namespace

TEST_CASE("material acts on a magnet as the dipoles that it is made of", "[magnetics]")
{
  // Two points of material with given moments, and two dipoles as sources. What the points do to a source
  // is what two point dipoles of these moments at these places do to it, force and torque: a field that
  // is known apart from the one of the source, which the reaction is computed from. A uniform field gets
  // nothing.
  const ExternalField<3> sources(
    {dipole<3>("one", {{0.1, 0.2, 0.3}}, {{1., -2., 0.5}}),
     dipole<3>("other", {{0.5, 0.1, 0.2}}, {{0.3, 0.7, -0.4}}),
     [] {
       SourceParameters<3> field;
       field.name = "field";
       field.kind = UniformFieldParameters<3>{Vector<3>{{1e4, 0., 0.}}};
       return field;
     }()});
  std::vector<MaterialSample<3>> samples(2);
  samples[0].position      = {{0.3, 0.4, 0.1}};
  samples[0].weight        = 1e-6;
  samples[0].magnetization = {{1e6, 2e6, -5e5}};
  samples[1].position      = {{0.2, 0.25, 0.5}};
  samples[1].weight        = 2e-6;
  samples[1].magnetization = {{-3e5, 2e5, 1e6}};

  const PointDipole<3> kind(0.001);
  const auto of_samples = [&](const Vector<3> &point) {
    LocalField<3> sum = {};
    for (const MaterialSample<3> &sample : samples)
      {
        const Vector<3> moment = sample.weight * sample.magnetization;
        sum.field += kind.field(moment, point - sample.position);
        sum.gradient += kind.field_gradient(moment, point - sample.position);
      }
    return sum;
  };
  const auto reactions = reactions_on_sources(samples, sources, MPI_COMM_SELF);
  REQUIRE(reactions.size() == 3);
  for (const int s : {0, 1})
    {
      const auto exact = sources.sources()[s]->force_and_torque(of_samples);
      REQUIRE(exact);
      CHECK(norm(exact->force) > 0.);
      CHECK(norm(reactions[s].force - exact->force) < 1e-12 * norm(exact->force));
      CHECK(norm(reactions[s].torque - exact->torque) < 1e-12 * norm(exact->torque));
    }
  CHECK(norm(reactions[2].force) == 0.);
  CHECK(norm(reactions[2].torque) == 0.);
}

TEST_CASE("the reaction of material is per metre of depth in 2D", "[magnetics]")
{
  // A point of material as a line dipole beside another: the same identity in the plane.
  const ExternalField<2> sources({dipole<2>("one", {{0.1, 0.2}}, {{1., -2.}})});
  std::vector<MaterialSample<2>> samples(1);
  samples[0].position      = {{0.3, 0.4}};
  samples[0].weight        = 1e-4;
  samples[0].magnetization = {{1e4, 2e4}};
  const PointDipole<2> kind(0.001);
  const auto exact     = sources.sources()[0]->force_and_torque([&](const Vector<2> &point) {
    const Vector<2> moment = {{1., 2.}};
    return LocalField<2>{kind.field(moment, point - samples[0].position),
                         kind.field_gradient(moment, point - samples[0].position)};
  });
  const auto reactions = reactions_on_sources(samples, sources, MPI_COMM_SELF);
  REQUIRE(exact);
  CHECK(norm(reactions[0].force - exact->force) < 1e-12 * norm(exact->force));
  CHECK(norm(reactions[0].torque - exact->torque) < 1e-12 * norm(exact->torque));
}
