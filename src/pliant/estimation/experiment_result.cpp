#include "pliant/estimation/experiment_result.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/experiment/experiment_data.h"

namespace pliant {
namespace {

double rms_of_used(const Eigen::VectorXd& difference, const std::vector<char>& used) {
  double sum = 0;
  int count = 0;
  for (Eigen::Index i = 0; i < difference.size(); ++i) {
    if (!used[static_cast<size_t>(i)]) continue;
    sum += difference(i) * difference(i);
    ++count;
  }
  return count == 0 ? 0 : std::sqrt(sum / count);
}

// Strains of the material itself: a slack strip's clamps are nearer than that.
std::pair<double, double> used_strains(const Eigen::VectorXd& strain,
                                       const std::vector<char>& used) {
  std::pair<double, double> range{1e300, -1e300};
  for (Eigen::Index i = 0; i < strain.size(); ++i) {
    if (!used[static_cast<size_t>(i)]) continue;
    range.first = std::min(range.first, strain(i));
    range.second = std::max(range.second, strain(i));
  }
  return range;
}

// Standard deviation of a row by the second differences of the residuals along each stretch, which
// no smooth misfit reaches: 1.4826 medians, so that single bad rows do not count.
std::optional<double> noise_floor_of(const Eigen::VectorXd& residual, const MeasuredPath& path,
                                     const std::vector<char>& used) {
  constexpr size_t kFewest = 10;
  std::vector<double> differences;
  for (size_t i = 2; i < path.anchor.size(); ++i) {
    const bool one_run = path.anchor[i] == path.anchor[i - 2] &&
                         path.specimen[i] == path.specimen[i - 2] && used[i] && used[i - 1] &&
                         used[i - 2];
    if (!one_run) continue;
    const auto row = static_cast<Eigen::Index>(i);
    differences.push_back(std::abs(residual(row) - 2 * residual(row - 1) + residual(row - 2)));
  }
  if (differences.size() < kFewest) return std::nullopt;
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return 1.4826 * *middle / std::sqrt(6.0);
}

std::optional<LoopMetrics> metrics_of(const ComponentExperiment& experiment,
                                      const Eigen::VectorXd& quantity) {
  const auto loop = experiment.loop(quantity);
  return loop ? loop_metrics(*loop, experiment.path()) : std::nullopt;
}

// 1 where a row loads, -1 where it unloads. A strip that was bent or hangs loads where it bends
// further than at its beginning, to whichever side.
std::vector<int> loading_of_rows(const MeasuredPath& path) {
  if (path.starts_flat.empty()) return path.direction;
  std::vector<int> loading;
  for (size_t i = 0; i < path.strain.size(); ++i) {
    const double start = path.strain[static_cast<size_t>(path.anchor[i])];
    loading.push_back(start * path.direction[i] < 0 ? -1 : 1);
  }
  return loading;
}

// The strain that a row is shown at: that of the material; but where clamps impose it and a force
// is measured, theirs. The material of a slack strip stays behind.
std::vector<double> shown_strain(const ComponentExperiment& experiment,
                                 const Prediction& prediction) {
  const ExperimentInfo& info = experiment.info();
  const bool is_pulled =
      info.test.deformation == Deformation::stretch && info.quantity.kind == "force";
  if (is_pulled) return experiment.path().strain;
  return {prediction.strain.begin(), prediction.strain.end()};
}

std::string listed(std::vector<double> settings) {
  settings.erase(std::unique(settings.begin(), settings.end()), settings.end());
  std::vector<std::string> texts;
  for (const double setting : settings) texts.push_back(millimetres(setting));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::size_t strips_of(const StripShapes& shapes) {
  std::set<double> settings;
  for (const ProfileLine& line : shapes.predicted) settings.insert(line.setting);
  return settings.size();
}

// A strip that may rest in several shapes was measured in the one in which it was left.
void tell_other_equilibria(ExperimentResult& result) {
  if (!result.shapes || result.shapes->ambiguous.empty()) return;
  const StripShapes& shapes = *result.shapes;
  result.handled.push_back(
      fmt::format("{} of {} predicted strips may rest in another shape when they are let go faster "
                  "or bent on by up to {} rad ({} {}): "
                  "what they say hangs on how quietly they were left",
                  shapes.ambiguous.size(), strips_of(shapes), kPushedBy, shapes.setting_name,
                  listed(shapes.ambiguous)));
  if (shapes.elsewhere.empty()) return;
  result.handled.push_back(fmt::format(
      "{} of {} profiles lie nearer to such another shape than to that of a quiet release, and are "
      "compared with it ({} {})",
      shapes.elsewhere.size(), shapes.measured.size(), shapes.setting_name,
      listed(shapes.elsewhere)));
}

}  // namespace

ExperimentResult compare(const ComponentExperiment& experiment, const ComponentLaw& law,
                         const Eigen::VectorXd& nuisance) {
  const auto prediction = experiment.predict(law, nuisance, false);
  if (!prediction) {
    throw SolverError("experiment " + experiment.info().name +
                          ": the material cannot carry its loads; its prediction",
                      0, 0);
  }
  const ExperimentInfo& info = experiment.info();
  const MeasuredPath& path = experiment.path();
  ExperimentResult result;
  result.name = info.name;
  result.type = info.type;
  result.direction = info.direction;
  result.component = info.component;
  result.role = info.role;
  result.quantity = info.quantity;
  result.measured = experiment.measured();
  result.predicted = prediction->value;
  result.rms = rms_of_used(result.predicted - result.measured, info.used);
  result.rms_percent = 100 * result.rms / experiment.reference();
  if (const auto limp = experiment.limp()) {
    result.limp_rms = rms_of_used(*limp - result.measured, info.used);
    result.limp_percent = 100 * *result.limp_rms / experiment.reference();
  }
  result.peak_force = experiment.peak_force();
  result.points = static_cast<int>(std::count(info.used.begin(), info.used.end(), 1));
  result.excluded = experiment.rows() - result.points;
  result.specimens = info.specimens;
  result.noise = result.rms;
  result.noise_source = "not used: predicted, not fitted";
  result.stated_noise = info.stated_noise();
  if (path.starts_flat.empty()) {
    result.noise_floor = noise_floor_of(result.predicted - result.measured, path, info.used);
  }
  result.strain_range = used_strains(prediction->strain, info.used);
  result.handled = info.handled;
  result.columns = info.columns;
  result.time = info.time;
  result.strain = shown_strain(experiment, *prediction);
  result.direction_of_row = loading_of_rows(path);
  result.specimen_of_row = path.specimen;
  result.used = info.used;
  result.unloads = unloads(path);
  result.shapes = experiment.shapes(law, nuisance);
  tell_other_equilibria(result);
  const Eigen::VectorXd zero = experiment.instrument_zero(nuisance);
  result.measured_loop = metrics_of(experiment, result.measured - zero);
  result.predicted_loop = metrics_of(experiment, result.predicted - zero);
  result.measured_figures = loop_figures(experiment, result.measured - zero);
  result.predicted_figures = loop_figures(experiment, result.predicted - zero);
  return result;
}

std::string unfitted_note(const ExperimentInfo& info, std::string_view material) {
  const std::string note = fmt::format("predicted, {}", material);
  return info.test.unfitted.empty() ? note : fmt::format("{}: {}", note, info.test.unfitted);
}

void add_elastic(ExperimentResult& result, const ComponentExperiment& experiment,
                 const ComponentLaw& elastic, const Eigen::VectorXd& nuisance) {
  const auto prediction = experiment.predict(elastic, nuisance, false);
  if (!prediction) return;
  result.elastic = prediction->value;
  result.elastic_rms = rms_of_used(prediction->value - result.measured, experiment.info().used);
  result.elastic_percent = 100 * *result.elastic_rms / experiment.reference();
}

}  // namespace pliant
