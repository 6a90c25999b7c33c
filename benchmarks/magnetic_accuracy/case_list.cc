#include <magnetic_accuracy/case_list.h>

#include <verification/magnetostatics/block_errors.h>
#include <verification/magnetostatics/cube_errors.h>
#include <verification/magnetostatics/ellipsoid_errors.h>
#include <verification/magnetostatics/pair_errors.h>
#include <verification/magnetostatics/sphere_errors.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace magmpm::benchmarks
{
  using namespace verification;

  namespace
  {
    using Resolutions = std::vector<CaseSeries::Resolution>;

    const Resolutions three_resolutions = {{4., 8}, {8., 8}, {16., 2}};
    const Resolutions eight             = {{8., 8}};

    /** The exact solutions that all is measured by: spheres, spheroids, pairs of spheres. */
    template <int dim>
    void
    add_convergence(const AccuracyCase &standard, std::vector<CaseSeries> &cases)
    {
      cases.push_back({"sphere", "", three_resolutions, standard, sphere_errors<dim>, true});
      cases.push_back({"torque", "", three_resolutions, standard, torque_errors<dim>, true});
      cases.push_back({"pair", "", three_resolutions, standard, pair_errors<dim>, true});
      for (const double susceptibility : {0.91, 10.})
        cases.push_back({"unequal",
                         susceptibility == 10. ? "small one chi_0 = 10" : "",
                         {{8., 4}, {16., 2}},
                         standard,
                         [=](const AccuracyCase &accuracy_case) {
                           return unequal_pair_errors<dim>(accuracy_case, susceptibility);
                         },
                         true});
    }

    /** Other media and other boxes. */
    template <int dim>
    void
    add_media(const AccuracyCase &standard, std::vector<CaseSeries> &cases)
    {
      cases.push_back({"box", "", {{32. / 3., 2}}, standard, box_errors<dim>});
      for (const double argument : {3., 30.})
        {
          AccuracyCase langevin = standard;
          langevin.argument     = argument;
          cases.push_back(
            {"langevin", argument == 3. ? "a = 3" : "a = 30", eight, langevin, sphere_errors<dim>});
        }
      AccuracyCase stretched = standard;
      stretched.stretch      = 1.5;
      cases.push_back({"stretched", "", eight, stretched, sphere_errors<dim>});
    }

    /** Where the susceptibility is high: what locks shows there. */
    template <int dim>
    void
    add_permeable(const AccuracyCase &standard, std::vector<CaseSeries> &cases)
    {
      for (const double susceptibility : {1., 10., 100., 1000.})
        {
          AccuracyCase permeable   = standard;
          permeable.susceptibility = susceptibility;
          const std::string chi    = "chi_0 = " + std::to_string(std::lround(susceptibility));
          cases.push_back(
            {"permeable", chi, {{4., 8}, {8., 8}, {16., 2}}, permeable, sphere_errors<dim>, true});
          if (susceptibility > 10.)
            continue;
          cases.push_back({"gap",
                           chi,
                           {{8., 6}, {16., 2}},
                           permeable,
                           [=](const AccuracyCase &accuracy_case) {
                             return unequal_pair_errors<dim>(accuracy_case, susceptibility);
                           },
                           true});
        }
      AccuracyCase fine   = standard;
      fine.susceptibility = 10.;
      fine.cell_edge      = 1;
      cases.push_back({"permeable", "chi_0 = 10, cells dx", {{8., 4}}, fine, sphere_errors<dim>});
    }

    /** A block of these edges, in dx, at several susceptibilities. */
    template <int dim>
    void
    add_block(const std::string &name,
              const Vector<dim> &edges,
              const bool is_round,
              const AccuracyCase &standard,
              const unsigned int n_offsets,
              std::vector<CaseSeries> &cases)
    {
      const double last = edges[dim - 1];
      BlockShape<dim> shape;
      shape.edges    = (1. / last) * edges;
      shape.is_round = is_round;
      for (const double susceptibility : {1., 10.})
        {
          AccuracyCase block   = standard;
          block.susceptibility = susceptibility;
          const auto errors    = std::make_shared<BlockErrors<dim>>(shape);
          cases.push_back(
            {"block",
             name + ", chi_0 = " + std::to_string(std::lround(susceptibility)),
             {{last, n_offsets}},
             block,
             [errors](const AccuracyCase &accuracy_case) { return (*errors)(accuracy_case); }});
        }
    }

    /** Plates across the field, a disc, cubes. */
    template <int dim>
    void
    add_blocks(const AccuracyCase &standard, std::vector<CaseSeries> &cases)
    {
      if constexpr (dim == 3)
        {
          add_block<3>("plate 32 x 32 x 4", {{32., 32., 4.}}, false, standard, 6, cases);
          add_block<3>("plate 32 x 32 x 2", {{32., 32., 2.}}, false, standard, 6, cases);
          add_block<3>("sheet 16 x 16 x 1", {{16., 16., 1.}}, false, standard, 6, cases);
          add_block<3>("disc 24 x 6", {{24., 24., 6.}}, true, standard, 5, cases);
          add_block<3>("cube 8", {{8., 8., 8.}}, false, standard, 8, cases);
          add_block<3>("cube 16", {{16., 16., 16.}}, false, standard, 5, cases);
        }
      else
        {
          add_block<2>("bar 32 x 4", {{32., 4.}}, false, standard, 8, cases);
          add_block<2>("bar 32 x 2", {{32., 2.}}, false, standard, 8, cases);
          add_block<2>("bar 16 x 1", {{16., 1.}}, false, standard, 8, cases);
          add_block<2>("square 16", {{16., 16.}}, false, standard, 8, cases);
        }
    }

    /** Small features, corners, motion, a magnet close by. */
    template <int dim>
    void
    add_features(const AccuracyCase &standard, std::vector<CaseSeries> &cases)
    {
      cases.push_back({"sheet", "", {{1., 8}}, standard, sheet_errors<dim>});
      cases.push_back(
        {"drops", "particle", {{dim == 3 ? 0.25 : 1. / 6., 8}}, standard, particle_errors<dim>});
      cases.push_back(
        {"drops", "", {{0.5, 8}, {1., 8}, {1.5, 8}, {2., 8}, {3., 8}}, standard, drop_errors<dim>});
      AccuracyCase fine = standard;
      fine.resolution   = (dim == 3 ? 32. : 96.);
      fine.cell_edge    = 1;
      const auto cube   = std::make_shared<CubeErrors<dim>>(fine);
      cases.push_back({"cube",
                       "",
                       {{8., 4}, {16., 2}},
                       standard,
                       [cube](const AccuracyCase &accuracy_case) { return (*cube)(accuracy_case); },
                       true});
      cases.push_back({"translation", "", {{8., 2}}, standard, translation_errors<dim>});
      cases.push_back({"magnet", "", {{8., 8}, {16., 2}}, standard, magnet_errors<dim>, true});
    }
  } // namespace

  template <int dim>
  std::vector<CaseSeries>
  all_cases(const AccuracyCase &standard)
  {
    std::vector<CaseSeries> cases;
    add_convergence<dim>(standard, cases);
    add_media<dim>(standard, cases);
    add_permeable<dim>(standard, cases);
    add_blocks<dim>(standard, cases);
    add_features<dim>(standard, cases);
    return cases;
  }

  std::vector<std::string>
  case_groups()
  {
    std::vector<std::string> groups;
    for (const CaseSeries &series : all_cases<3>({}))
      if (std::find(groups.begin(), groups.end(), series.group) == groups.end())
        groups.push_back(series.group);
    return groups;
  }

  template std::vector<CaseSeries>
  all_cases<2>(const AccuracyCase &);
  template std::vector<CaseSeries>
  all_cases<3>(const AccuracyCase &);
} // namespace magmpm::benchmarks
