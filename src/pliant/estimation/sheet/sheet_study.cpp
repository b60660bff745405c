#include "pliant/estimation/sheet/sheet_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/base/stopwatch.h"
#include "pliant/estimation/component_curve.h"
#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/estimation/sheet/sheet_options.h"
#include "pliant/estimation/sheet/sheet_plan.h"
#include "pliant/estimation/sheet/sheet_problem.h"
#include "pliant/estimation/sheet/sheet_result.h"
#include "pliant/estimation/sheet/sheet_uncertainty.h"
#include "pliant/estimation/stated_options.h"
#include "pliant/estimation/study_experiments.h"
#include "pliant/estimation/uncertainty.h"
#include "pliant/experiment/session/balance.h"
#include "pliant/experiment/session/clip_grid.h"
#include "pliant/experiment/session/on_mesh.h"
#include "pliant/experiment/sheet/make_predictor.h"
#include "pliant/experiment/sheet/strip_sheets.h"
#include "pliant/geometry/grid_pattern.h"
#include "pliant/geometry/hinges.h"
#include "pliant/material/bending_conversion.h"
#include "pliant/material/fill.h"
#include "pliant/material/positive_stiffness.h"

namespace pliant {
namespace {

/// Cells on the longer side of a sheet ([T] 3.4.1).
constexpr int kCells = 24;
/// A rest mesh that covers less of its bounding box is no rectangle along weft and warp.
constexpr double kRectangle = 0.95;

bool is_rectangle(const Session& session) {
  const Eigen::Vector3d extent =
      session.rest.positions.rowwise().maxCoeff() - session.rest.positions.rowwise().minCoeff();
  return rest_area(session.rest) > kRectangle * extent.x() * extent.y();
}

/// @throws InputError where the springs of a model have no grid to be on
void require_grid_for_springs(const ExperimentSpec& spec, const Session& session,
                              const ModelOptions& model) {
  const bool springs = model.membrane == MembraneMeasure::spring || model.bending == "spring";
  if (!springs || is_cut_from_rectangles(session.rest)) return;
  throw InputError(spec.where,
                   fmt::format("springs cannot simulate {} on its own mesh, which is no grid of "
                               "rectangles along weft and warp",
                               quoted_value(spec.name)),
                   "another model, or a rectangular sheet that `model.mesh` gives a grid");
}

Session on_fit_mesh(const Session& session, const ModelOptions& model) {
  if (model.measured_mesh || !is_rectangle(session)) return session;
  const double longer = std::max(session.sample.width, session.sample.height);
  return on_mesh(session, grid_on_clips(session, model.mesh_edge.value_or(longer / kCells)));
}

/// What is known of the cords of a clip together, which move alike or nearly so.
std::string loops_together(const SheetUncertainty& uncertainty, std::size_t cord) {
  std::vector<Eigen::Index> all;
  for (std::size_t i = 0; i < uncertainty.unknowns.size(); ++i) {
    const SheetUnknown &one = uncertainty.unknowns[cord], &other = uncertainty.unknowns[i];
    if (one.owner == other.owner && one.clip == other.clip) {
      all.push_back(static_cast<Eigen::Index>(i));
    }
  }
  if (all.size() < 2) return {};
  return fmt::format("all {} cords of the clip: {:.3g} +- {:.2g} N", all.size(),
                     uncertainty.values(all).sum(),
                     std::sqrt(uncertainty.covariance(all, all).sum()));
}

/// A number is known where its interval leaves out zero; with a prior, where the data say more than
/// the prior.
ParameterEstimate estimate_of(const SheetUncertainty& uncertainty, Eigen::Index i) {
  const auto index = static_cast<std::size_t>(i);
  const SheetUnknown& unknown = uncertainty.unknowns[index];
  ParameterEstimate estimate;
  estimate.name = unknown.name;
  estimate.owner = unknown.owner;
  estimate.unit = unknown.unit;
  estimate.value = uncertainty.values(i);
  const bool cord = !unknown.clip.empty();
  if (!cord && !unknown.of_friction) {
    estimate.note = fmt::format("at strain {:.3g}; ", unknown.strain);
  }
  estimate.note += cord ? loops_together(uncertainty, index) : uncertainty.told_by[index];
  estimate.fixed = unknown.fixed;
  if (unknown.fixed) return estimate;
  estimate.at_bound = estimate.value <= unknown.lower || estimate.value >= unknown.upper;
  if (!uncertainty.determined[index] || estimate.at_bound) return estimate;
  estimate.std_error = std::sqrt(uncertainty.covariance(i, i));
  const double half = *estimate.std_error * student_quantile_95(uncertainty.degrees(i));
  estimate.lower = estimate.value - half;
  estimate.upper = estimate.value + half;
  estimate.identified =
      unknown.prior ? *estimate.std_error < unknown.prior->sd / 2 : half < estimate.value;
  return estimate;
}

/// What a fit found counts as measured, and so does what the study states; its guesses as assumed.
void set_status(const Study& study, SheetFit& fit) {
  for (auto& [name, component] : fit.material.components) {
    if (fixed_stiffness(study.fit, {name})) {
      component.status = ComponentStatus::measured;
      continue;
    }
    const bool measured = std::ranges::any_of(fit.groups, [&](const ComponentGroup& group) {
      return std::ranges::find(group, name) != group.end();
    });
    component.status = measured ? ComponentStatus::measured : ComponentStatus::assumed;
    if (measured) component.range = {0.0, component.stiffness->knots().back()};
  }
}

void add_curves(const SheetFit& fit, const SheetUncertainty& uncertainty, StudyResult& result) {
  Eigen::Index first = 0;
  for (const ComponentGroup& group : fit.groups) {
    const ComponentLaw law = law_of(fit.material, group);
    const Eigen::Index count = law.parameter_count();
    const double largest = largest_strain(fit, group);
    const Eigen::MatrixXd own = uncertainty.covariance.block(first, first, count, count);
    for (const std::string& component : group) {
      result.curves.push_back(component_curve(component, law, largest, own));
    }
    first += count;
  }
}

/// The mesh of the first sheet on a table: those between clips have cells of several sizes.
const TriangleMesh& bent_mesh(const std::vector<SheetExperiment>& experiments) {
  const auto bent = std::ranges::find_if(experiments, [](const SheetExperiment& experiment) {
    return experiment.test.session().table.has_value();
  });
  return (bent == experiments.end() ? experiments.front() : *bent).test.session().rest;
}

/// What hinges make of a sheet: its bending stiffness, which other meshes and strips can be
/// compared with. Of curves the stiffness at half of the largest strain counts.
std::string sheet_bending(const SheetFit& fit, const TriangleMesh& mesh) {
  BendingVector hinges;
  const std::array<const char*, 3> names{"bend.weft", "bend.warp", "bend.diagonal"};
  for (int i = 0; i < 3; ++i) {
    const char* name = names[static_cast<std::size_t>(i)];
    const auto strain = fit.strains.find(name);
    const double half = strain == fit.strains.end() ? 0 : strain->second / 2;
    hinges(i) = std::max(fit.material.components.at(name).stiffness->value(half), 1e-12);
  }
  const Eigen::Vector4d sheet = sheet_stiffness(mesh, find_hinges(mesh), hinges);
  return fmt::format(
      "bending is that of the hinges of the simulated mesh; as a sheet it has {:.3g} N m along "
      "weft, "
      "{:.3g} N m along warp, {:.3g} and {:.3g} N m at 45 degrees (M/width = 3 k curvature)",
      sheet(kAlongWeft), sheet(kAlongWarp), sheet(kAlongRising), sheet(kAlongFalling));
}

void warn_of_left_out(const Study& study, StudyResult& result) {
  std::vector<std::string> names;
  for (const ExperimentSpec& spec : study.experiments) {
    if (!is_sheet(spec, study.model)) names.push_back(spec.name);
  }
  if (names.empty()) return;
  result.warnings.push_back(fmt::format(
      "experiments in one dimension are left out of a fit of sheets: {}", fmt::join(names, ", ")));
}

/// Share of the frames that a prediction needs: fewer tell another story.
constexpr double kFoundShare = 0.75;

/// Shapes of the frames of a test that have an equilibrium.
/// @throws SolverError where too few have one
std::vector<std::optional<SheetShape>> predict(const SheetTest& test, const Material& material,
                                               const CordFrictions& cords,
                                               const RunContext& context, EquilibriumWork& work) {
  const Stopwatch watch;
  const std::unique_ptr<SheetPredictor> predictor = make_predictor(test.session(), material);
  auto shapes = predictor->predict_each(predictor->parameters(), {}, context.threads, context.stop);
  const EquilibriumWork own = predictor->work();
  work += {own.counts, own.seconds.on_the_clock(watch.seconds())};
  const Eigen::VectorXd widths = cord_widths(test, cords);
  int found = 0, first_missing = -1;
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    std::optional<SheetShape>& shape = shapes[static_cast<std::size_t>(frame)];
    if (shape) {
      add_cord_drags(test.cords(), widths, false, frame, *shape);
      ++found;
    } else if (first_missing < 0) {
      first_missing = frame;
    }
  }
  if (found < kFoundShare * test.frame_count()) {
    throw SolverError(
        fmt::format("the equilibria of {} of {} frames of {}, first of frame {}",
                    test.frame_count() - found, test.frame_count(), test.name(), first_missing),
        own.counts.iterations, 0);
  }
  return shapes;
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

/// How friction of cords was dealt with in a prediction.
void tell_of_cords(const SheetTest& test, const CordFrictions& cords, ExperimentResult& result) {
  if (test.cords().empty()) return;
  const bool found = std::ranges::any_of(
      cord_unknowns(test), [&](const SheetUnknown& cord) { return cords.contains(cord.name); });
  if (!test.cord_friction().unknown) {
    result.handled.push_back(fmt::format(
        "the friction of its cords is taken to be a loop of {:.3g} N", test.cord_friction().width));
  } else {
    result.handled.push_back(found ? "the friction of each cord is estimated along"
                                   : "the friction of its cords is not known and left out");
  }
}

std::vector<ExperimentResult> predictions(const std::vector<SheetExperiment>& experiments,
                                          const Material& material, const CordFrictions& cords,
                                          const RunContext& context, EquilibriumWork& work) {
  const Material usable = held_beyond_range(material);
  std::vector<ExperimentResult> rows;
  ProgressTask task(context.progress, "predict", static_cast<double>(experiments.size()));
  for (const SheetExperiment& experiment : experiments) {
    const SheetTest& test = experiment.test;
    rows.push_back(compare_sheet(test, predict(test, usable, cords, context, work)));
    rows.back().role = experiment.role;
    rows.back().type = experiment.type;
    rows.back().direction = experiment.direction;
    rows.back().handled = experiment.handled;
    tell_of_cords(test, cords, rows.back());
    const auto components = usual_components(test.session().test);
    if (!components.empty()) rows.back().component = components.front();
    task.advance(static_cast<double>(rows.size()));
  }
  return rows;
}

/// A fit with what it predicts.
struct Candidate {
  SheetFit fit;
  std::vector<ExperimentResult> experiments;
  std::string note;

  Candidate(const Study& study, SheetFit fitted, const std::vector<SheetExperiment>& data,
            const RunContext& context, std::string how)
      : fit(std::move(fitted)), note(std::move(how)) {
    set_status(study, fit);
    experiments = predictions(data, fit.material, fit.cords, context, fit.work);
  }

  /// Frames without equilibrium, whose error nobody knows.
  std::size_t missing_frames() const {
    std::size_t missing = 0;
    for (const ExperimentResult& experiment : experiments) {
      if (experiment.sheet) missing += experiment.sheet->missing_frames().size();
    }
    return missing;
  }
};

/// The best of the fits that begin with nothing and at each start, and of the starts themselves;
/// its work is that of all.
Candidate best_fit(const Study& study, const std::vector<SheetStage>& plan,
                   const std::vector<SheetExperiment>& experiments, const RunContext& context,
                   const std::vector<SheetStart>& starts) {
  Candidate best(study, fit_sheets(study, plan, context), experiments, context, "");
  const auto consider = [&](SheetFit fit, std::string how) {
    Candidate other(study, std::move(fit), experiments, context, std::move(how));
    EquilibriumWork work = best.fit.work;
    work += other.fit.work;
    if (std::pair(other.missing_frames(), misfit_percent(other.experiments)) <
        std::pair(best.missing_frames(), misfit_percent(best.experiments))) {
      best = std::move(other);
    }
    best.fit.work = work;
  };
  for (const SheetStart& start : starts) {
    SheetFit fit = fit_sheets(study, plan, context, &start.material);
    consider(fit, "the search that began at the solution of " + start.variant + " is the best");
    fit.material = start.material;
    fit.cords = start.cords;
    fit.stages.clear();
    fit.work = {};
    consider(std::move(fit), "no search found better than the solution of " + start.variant);
  }
  return best;
}

/// What a study may ask of fits of single components alone.
void refuse_foreign_options(const Study& study) {
  const auto refuse = [&](const char* field, const std::string& what, const char* expected) {
    throw InputError({study.file, 0, field}, what, expected);
  };
  if (study.model.stiffness == CurveKind::affine) {
    refuse("model.stiffness", "sheets are not fitted with affine stiffnesses",
           "constant or hermite");
  }
  if (study.fit.estimator == EstimatorKind::anchor) {
    refuse("fit.estimator", "the published estimator of friction knows no sheets", "path");
  }
}

std::vector<const SheetTest*> tests_to_fit(const std::vector<SheetExperiment>& experiments) {
  std::vector<const SheetTest*> tests;
  for (const SheetExperiment& experiment : experiments) {
    if (experiment.role == ExperimentRole::fit) tests.push_back(&experiment.test);
  }
  return tests;
}

/// One fabric has one mass per area: another one tells of a wrong mass, or of another fabric.
void warn_of_density(const std::string& name, double density, double of_study,
                     const std::vector<SheetExperiment>& experiments, StudyResult& result) {
  constexpr double kAgreement = 0.05;
  const auto differs = [&](double other) { return std::abs(density - other) > kAgreement * other; };
  const auto warn = [&](const std::string& whose, double other) {
    result.warnings.push_back(fmt::format("{}: its sheet weighs {}, {} {}: is it the same fabric?",
                                          name, format_quantity(density, Dimension::area_density),
                                          whose, format_quantity(other, Dimension::area_density)));
  };
  if (of_study > 0) {
    if (differs(of_study)) warn("the fabric, as stated,", of_study);
    return;
  }
  if (experiments.empty()) return;
  const SheetTest& first = experiments.front().test;
  const double of_first = area_density(first.session());
  if (differs(of_first)) warn("that of " + first.name(), of_first);
}

/// The strips of an experiment, one test a specimen.
void add_strips(const ExperimentSpec& spec, const Study& study,
                std::vector<SheetExperiment>& experiments, StudyResult& result) {
  StripSheets strips = sheets_of_strips(spec, study.model, study.density);
  for (const std::string& warning : strips.warnings) {
    result.warnings.push_back(spec.name + ": " + warning);
  }
  for (SheetTest& test : strips.tests) {
    experiments.push_back({std::move(test), spec.role, spec.type, spec.direction, strips.handled});
  }
}

}  // namespace

std::vector<SheetExperiment> read_sheet_experiments(const Study& study, StudyResult& result) {
  std::vector<SheetExperiment> experiments;
  for (const ExperimentSpec& spec : study.experiments) {
    if (!is_sheet(spec, study.model)) continue;
    if (!measures_sheets(spec.type)) {
      add_strips(spec, study, experiments, result);
      continue;
    }
    const Session measured = read_session(spec.data.files.front());
    for (const std::string& warning : measured.warnings) {
      result.warnings.push_back(spec.name + ": " + warning);
    }
    warn_of_density(spec.name, area_density(measured), study.density, experiments, result);
    Session session = on_fit_mesh(measured, study.model);
    require_grid_for_springs(spec, session, study.model);
    const std::string test = session.test;
    experiments.push_back(
        {sheet_test_of(spec, std::move(session)), spec.role, spec.type, test, {}});
  }
  return experiments;
}

bool fits_sheets(const Study& study) {
  return std::ranges::any_of(study.experiments, [&](const ExperimentSpec& spec) {
    return is_sheet(spec, study.model) && spec.role == ExperimentRole::fit;
  });
}

double misfit_percent(const std::vector<ExperimentResult>& experiments) {
  double squares = 0;
  int fitted = 0;
  for (const ExperimentResult& experiment : experiments) {
    if (experiment.role != ExperimentRole::fit) continue;
    squares += experiment.rms_percent * experiment.rms_percent;
    ++fitted;
  }
  return fitted > 0 ? std::sqrt(squares / fitted) : 0;
}

StudyResult fit_sheet_study(const Study& study, const RunContext& context,
                            const std::vector<SheetStart>& starts) {
  const Stopwatch watch;
  StudyResult result = describe(study);
  result.assumptions = stated_options(study.fit);
  refuse_foreign_options(study);
  const std::vector<SheetExperiment> experiments = read_sheet_experiments(study, result);
  warn_of_left_out(study, result);
  require_known_parameters(study, tests_to_fit(experiments));
  const std::vector<SheetStage> plan = sheet_plan(study, tests_to_fit(experiments));
  Candidate best = best_fit(study, plan, experiments, context, starts);
  SheetFit& fit = best.fit;
  if (fit.material.density == 0) {
    fit.material.density = area_density(experiments.front().test.session());
  }
  result.density = fit.material.density;
  const SheetUncertainty uncertainty = sheet_uncertainty(fit, plan, study.fit, context);
  result.work = fit.work;
  *result.work += uncertainty.work;
  result.converged = fit.converged;
  result.stages = fit.stages;
  result.warnings.insert(result.warnings.end(), fit.warnings.begin(), fit.warnings.end());
  result.covariance = uncertainty.covariance;
  for (Eigen::Index i = 0; i < uncertainty.values.size(); ++i) {
    ParameterEstimate estimate = estimate_of(uncertainty, i);
    const bool cord = !uncertainty.unknowns[static_cast<std::size_t>(i)].clip.empty();
    (cord ? result.nuisance : result.parameters).push_back(std::move(estimate));
  }
  result.material = fit.material;
  result.experiments = std::move(best.experiments);
  warn_of_missing_frames(result.experiments, result);
  add_curves(fit, uncertainty, result);
  for (const auto& [name, component] : fit.material.components) {
    if (component.status == ComponentStatus::assumed) {
      result.undetermined.push_back(name + ": no session tells it; a guess stands in its place");
    }
  }
  const bool bends = std::ranges::any_of(
      fit.groups, [](const ComponentGroup& group) { return is_bending(group.front()); });
  if (bends && fit.material.bending == "discrete-shells") {
    result.assumptions.push_back(sheet_bending(fit, bent_mesh(experiments)));
  }
  if (!best.note.empty()) result.assumptions.push_back("search: " + best.note);
  result.seconds = watch.seconds();
  return result;
}

void evaluate_sheets(const Study& study, const Material& material, const RunContext& context,
                     StudyResult& result) {
  const bool any = std::ranges::any_of(
      study.experiments, [&](const ExperimentSpec& spec) { return is_sheet(spec, study.model); });
  if (!any) return;
  require_complete(material, sheet_component_names(), {study.file, 0, "experiments"});
  require_positive_stiffness(material, sheet_component_names(), {study.file, 0, "experiments"});
  std::vector<SheetExperiment> experiments = read_sheet_experiments(study, result);
  for (SheetExperiment& experiment : experiments) experiment.role = ExperimentRole::validate;
  EquilibriumWork work;
  std::vector<ExperimentResult> rows = predictions(experiments, material, {}, context, work);
  warn_of_missing_frames(rows, result);
  std::move(rows.begin(), rows.end(), std::back_inserter(result.experiments));
  for (const ExperimentResult& row : result.experiments) {
    const bool drawn = std::ranges::any_of(result.curves, [&](const ComponentCurve& curve) {
      return curve.component == row.component;
    });
    if (drawn || row.component.empty()) continue;
    const ComponentLaw law = law_of(material, ComponentGroup{row.component});
    result.curves.push_back(component_curve(row.component, law, row.strain_range.second, {}));
  }
}

}  // namespace pliant
