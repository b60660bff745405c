#include "pliant/experiment/profile/virtual_profiles.h"

#include <vector>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/io/csv_writer.h"
#include "pliant/solver/elastica/strip_release.h"

namespace pliant {
namespace {

// Finer than a fit takes them.
constexpr int kElements = 48;
constexpr double kAccuracy = 1e-6;  // of a release (rad)

using Points = std::vector<Eigen::Vector2d>;

Points hanging_strip(const LabExperiment& experiment, const ComponentLaw& law, double density,
                     double setting) {
  const bool rolled = experiment.type == "rolled-strip";
  const double length = rolled ? experiment.length : setting;
  const Elastica strip(length, kElements);
  StripHistory history = rolled ? strip.rolled(law, 1 / setting) : strip.rested(law);
  const auto shape = released(strip, law, density * kStandardGravity, {}, /*derivatives=*/false,
                              history, kAccuracy);
  if (!shape) {
    throw SolverError(fmt::format("virtual experiment {}: the strip at {:.4g} mm finds no "
                                  "equilibrium; its profile",
                                  experiment.name, setting * 1e3),
                      0, 0);
  }
  const StripProfile profile = strip.profile({}, *shape);
  Points points;
  for (int i = 0; i < experiment.points; ++i) {
    points.push_back(profile.at(length * i / (experiment.points - 1)).position);
  }
  return points;
}

Eigen::Vector2d seen(const Eigen::Vector2d& point, const Instrument& instrument,
                     RandomStream& random) {
  const double x =
      measured(point.x(), instrument.length_noise, instrument.length_resolution, random);
  const double y =
      measured(point.y(), instrument.length_noise, instrument.length_resolution, random);
  return {x, y};
}

}  // namespace

std::string measure_profiles(const LabExperiment& experiment, const ComponentLaw& law,
                             double density, RandomStream& random) {
  const char* setting_column = experiment.type == "rolled-strip" ? "radius_mm" : "overhang_mm";
  const std::vector<std::string> header{setting_column, "repeat", "point", "x_mm", "y_mm"};
  CsvWriter csv(header);
  for (const double setting : experiment.settings) {
    const Points points = hanging_strip(experiment, law, density, setting);
    for (int repeat = 1; repeat <= experiment.repeats; ++repeat) {
      for (int i = 0; i < experiment.points; ++i) {
        Eigen::Vector2d point = Eigen::Vector2d::Zero();  // the clamp
        if (i > 0) point = seen(points[static_cast<size_t>(i)], experiment.instrument, random);
        csv.cell(setting * 1e3).cell(repeat).cell(i).cell(point.x() * 1e3).cell(point.y() * 1e3);
        csv.end_row();
      }
    }
  }
  return csv.text();
}

}  // namespace pliant
