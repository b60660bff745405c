#include "pliant/study/sheet_predictions.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/stopwatch.h"
#include "pliant/estimation/sheet/sheet_result.h"
#include "pliant/experiment/session/lost_frames.h"
#include "pliant/experiment/session/make_predictor.h"
#include "pliant/material/positive_stiffness.h"

namespace pliant {
namespace {

using Shapes = std::vector<std::optional<SheetShape>>;

Shapes shapes_of(const SheetTest& test, const Material& material, const Eigen::VectorXd& widths,
                 const RunContext& context, EquilibriumWork& work) {
  const Stopwatch watch;
  const std::unique_ptr<SheetPredictor> predictor = make_predictor(test.session(), material);
  Shapes shapes =
      predictor->predict_each(predictor->parameters(), {}, context.threads, context.stop);
  const EquilibriumWork own = predictor->work();
  work += {own.counts, own.seconds.on_the_clock(watch.seconds())};
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    std::optional<SheetShape>& shape = shapes[static_cast<std::size_t>(frame)];
    if (shape) add_cord_drags(test.cords(), widths, false, frame, *shape);
  }
  return shapes;
}

/// Shapes of the frames of a test that have an equilibrium. Where frames follow from those before,
/// one that has none ends the path: it begins anew without that frame.
/// @throws SolverError where none has one
Shapes predict(const SheetTest& test, const Material& material, const Eigen::VectorXd& widths,
               const RunContext& context, EquilibriumWork& work) {
  Shapes shapes = shapes_of(test, material, widths, context, work);
  const double most = kLostShare * test.frame_count();
  std::vector<int> lost = lost_frames(shapes);
  if (!lost.empty() && is_path(test.session(), material)) {
    std::vector<int> left_out;
    while (!lost.empty() && static_cast<double>(left_out.size()) < most) {
      left_out.push_back(lost.front());
      const SheetTest kept = test.without(left_out);
      shapes = shapes_of(kept, material, widths, context, work);
      for (const int frame : left_out) shapes.insert(shapes.begin() + frame, std::nullopt);
      lost = lost_frames(shapes);
      std::erase_if(lost, [&](int frame) { return frame <= left_out.back(); });
    }
    lost = lost_frames(shapes);
  }
  if (std::ssize(lost) == test.frame_count()) {
    throw SolverError("the equilibrium of any frame of " + test.name(), work.counts.iterations, 0);
  }
  return shapes;
}

/// What the cords of fitted experiments drag on the average; nothing where none were fitted (N).
std::optional<double> mean_width(const CordFrictions& cords) {
  if (cords.empty()) return std::nullopt;
  double sum = 0;
  for (const auto& [name, width] : cords) sum += width;
  return sum / static_cast<double>(cords.size());
}

/// What is taken for the loops of the cords of a test in a prediction, and why.
struct CordsTaken {
  Eigen::VectorXd widths;
  std::string how;  ///< empty: they have none
};

CordsTaken cords_of(const SheetTest& test, const CordFrictions& cords) {
  CordsTaken taken{cord_widths(test, cords), ""};
  if (test.cords().empty()) return taken;
  if (!test.cord_friction().unknown) {
    taken.how = fmt::format("the friction of its cords is taken to be a loop of {:.3g} N",
                            test.cord_friction().width);
    return taken;
  }
  const bool fitted = std::ranges::any_of(
      test.nuisance(), [&](const NuisanceParameter& cord) { return cords.contains(cord.name); });
  if (fitted) {
    taken.how = "the friction of each cord is estimated along";
  } else if (const std::optional<double> mean = mean_width(cords)) {
    taken.widths.setConstant(*mean);
    taken.how = fmt::format(
        "the friction of its cords is taken to be a loop of {:.3g} N, the mean of those that were "
        "fitted",
        *mean);
  } else {
    taken.how = "the friction of its cords is not known and left out";
  }
  return taken;
}

}  // namespace

std::vector<ExperimentResult> sheet_predictions(const std::vector<SheetExperiment>& experiments,
                                                const Material& material,
                                                const CordFrictions& cords,
                                                const RunContext& context, EquilibriumWork& work) {
  const Material usable = held_beyond_range(material);
  std::vector<ExperimentResult> rows;
  ProgressTask task(context.progress, "predict", static_cast<double>(experiments.size()));
  for (const SheetExperiment& experiment : experiments) {
    const SheetTest& test = experiment.test;
    const CordsTaken taken = cords_of(test, cords);
    rows.push_back(compare_sheet(test, predict(test, usable, taken.widths, context, work)));
    rows.back().role = experiment.role;
    rows.back().type = experiment.type;
    rows.back().direction = experiment.direction;
    rows.back().handled = experiment.handled;
    if (!taken.how.empty()) rows.back().handled.push_back(taken.how);
    const auto components = usual_components(test.session().test);
    if (!components.empty()) rows.back().component = components.front();
    task.advance(static_cast<double>(rows.size()));
  }
  return rows;
}

void warn_of_missing_frames(const std::vector<ExperimentResult>& experiments, StudyResult& result) {
  for (const ExperimentResult& experiment : experiments) {
    if (!experiment.sheet) continue;
    const SheetComparison& sheet = *experiment.sheet;
    const std::vector<int> missing = sheet.missing_frames();
    if (missing.empty()) continue;
    result.warnings.push_back(
        fmt::format("{}: no equilibrium is found of frame{} {} (of {}), left out of the comparison",
                    experiment.name, missing.size() == 1 ? "" : "s", fmt::join(missing, ", "),
                    sheet.measured.frame_count()));
  }
}

void warn_of_misfit(const std::vector<SheetExperiment>& experiments,
                    const std::vector<ExperimentResult>& predictions, StudyResult& result) {
  constexpr double kClear = 3;
  for (std::size_t i = 0; i < experiments.size(); ++i) {
    const SheetTest& test = experiments[i].test;
    const std::optional<double> noise = test.stated_noise();
    if (!noise || predictions[i].role != ExperimentRole::fit) continue;
    // The error is a distance in space.
    const double expected = *noise * (test.compares_one_axis() ? 1 : std::sqrt(3.0));
    if (predictions[i].rms < kClear * expected) continue;
    result.warnings.push_back(fmt::format(
        "{}: the fit misses {:.1f} times the noise that the session states: the law lacks "
        "something of what the cloth does, or the mesh is too coarse",
        test.name(), predictions[i].rms / expected));
  }
}

}  // namespace pliant
