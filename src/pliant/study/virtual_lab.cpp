#include "pliant/study/virtual_lab.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/base/random.h"
#include "pliant/experiment/buckling/virtual_buckling.h"
#include "pliant/experiment/friction_path.h"
#include "pliant/experiment/hanging/weight_path.h"
#include "pliant/experiment/overhang/virtual_overhangs.h"
#include "pliant/experiment/profile/virtual_profiles.h"
#include "pliant/experiment/sampled_path.h"
#include "pliant/experiment/tensile/strip_pull.h"
#include "pliant/io/csv_writer.h"
#include "pliant/material/bending_strain.h"
#include "pliant/study/study.h"
#include "pliant/study/virtual_sessions.h"

namespace pliant {
namespace {

ComponentLaw specimen_law(const ComponentLaw& law, double variation, RandomStream& random) {
  if (variation == 0) return law;
  Eigen::VectorXd parameters = law.parameters();
  for (double& p : parameters) p *= std::exp(variation * random.normal());
  return law.with_parameters(parameters);
}

[[noreturn]] void fail_to_carry(const LabExperiment& experiment) {
  throw SolverError("virtual experiment " + experiment.name +
                        ": the material cannot carry its loads; its prediction",
                    0, 0);
}

// [T] 5.3.2: weights 0 .. n .. 0 for each peak n, the whole sequence repeated.
std::string hang(const LabExperiment& experiment, const ComponentLaw& law, const VirtualLab& lab,
                 RandomStream& random) {
  struct Row {
    int repeat;
    double peak;
    int step;
    double weight;
  };
  std::vector<Row> rows;
  for (int repeat = 1; repeat <= experiment.repeats; ++repeat) {
    for (const double peak : experiment.peaks) {
      const int steps = static_cast<int>(std::lround(peak / experiment.step));
      for (int k = 0; k <= 2 * steps; ++k) {
        rows.push_back({repeat, peak, k, experiment.step * (steps - std::abs(k - steps))});
      }
    }
  }
  const double area = experiment.length * experiment.width;
  const double added = (experiment.clip_mass + lab.material.density * area / 2) * kStandardGravity;
  std::vector<double> forces;
  std::vector<char> rested(rows.size(), 0);
  rested.front() = 1;
  for (const Row& row : rows) forces.push_back(row.weight + added);
  const UniaxialGeometry geometry{experiment.length, experiment.width, lab.material.membrane};
  const auto hung = hang_weights(law, geometry, forces, rested, false);
  if (!hung) fail_to_carry(experiment);

  const std::vector<std::string> header{"repeat", "peak_N", "step", "weight_N", "length_mm"};
  CsvWriter csv(header);
  for (size_t i = 0; i < rows.size(); ++i) {
    const double length =
        measured(hung->length(static_cast<Eigen::Index>(i)), experiment.instrument.length_noise,
                 experiment.instrument.length_resolution, random);
    csv.cell(rows[i].repeat).cell(rows[i].peak).cell(rows[i].step).cell(rows[i].weight);
    csv.cell(length * 1e3);
    csv.end_row();
  }
  return csv.text();
}

std::string pull(const LabExperiment& experiment, const ComponentLaw& law, const VirtualLab& lab,
                 RandomStream& random) {
  std::vector<double> peaks;
  for (const double peak : experiment.peaks) peaks.push_back(experiment.length * (1 + peak));
  const double start = experiment.length - experiment.slack;
  const double reach = *std::max_element(peaks.begin(), peaks.end()) - start;
  const SampledPath path =
      sample_path(cycle_turns(start, peaks, experiment.repeats), reach / (experiment.samples - 1));
  const UniaxialGeometry geometry{experiment.length, experiment.width, lab.material.membrane};
  const auto forces = pull_strip(law, geometry, {}, {}, path.value, path.stretches, 0);
  if (!forces) fail_to_carry(experiment);

  const Instrument& instrument = experiment.instrument;
  const std::vector<std::string> header{"force_N", "length_mm", "cycle"};
  CsvWriter csv(header);
  for (size_t i = 0; i < path.value.size(); ++i) {
    csv.cell(measured(forces->force(static_cast<Eigen::Index>(i)), instrument.force_noise,
                      instrument.force_resolution, random));
    csv.cell(1e3 * measured(path.value[i], instrument.length_noise, instrument.length_resolution,
                            random));
    csv.cell(path.cycle[i]);
    csv.end_row();
  }
  return csv.text();
}

// What a machine moves at even speed, how that strains the sheet, and what it writes down.
struct ImposedTest {
  const char* driver = "";
  double driver_per_si = 1;
  const char* measured = "";
  std::function<double(double)> strain_of;
  std::function<double(double)> apparatus;  // added to the stress
};

ImposedTest shear_test(double transverse_tension) {
  return {"angle_deg", 180 / std::numbers::pi, "force_N_per_m",
          [](double angle) { return std::sin(angle); },
          [=](double angle) { return transverse_tension * std::tan(angle); }};
}

ImposedTest bending_test() {
  return {"curvature_1_per_m", 1, "moment_N",
          [](double curvature) { return kStrainPerCurvature * curvature; },
          [](double) { return 0.0; }};
}

// KES-FB1 and KES-FB2: 0, +peak, -peak, 0 in one cycle.
std::string to_and_fro(const LabExperiment& experiment, const ImposedTest& test,
                       const ComponentLaw& law, RandomStream& random) {
  std::vector<double> turns{0};
  for (int repeat = 0; repeat < experiment.repeats; ++repeat) {
    for (const double peak : experiment.peaks) turns.insert(turns.end(), {peak, -peak});
  }
  turns.push_back(0);
  const double largest = *std::max_element(experiment.peaks.begin(), experiment.peaks.end());
  const SampledPath path = sample_path(turns, 2 * largest / (experiment.samples - 1));
  FrictionPath stress(law, {});
  const std::vector<std::string> header{test.driver, test.measured};
  CsvWriter csv(header);
  for (const Stretch& stretch : path.stretches) {
    for (int i = stretch.first; i <= stretch.last; ++i) {
      const double driven = path.value[static_cast<size_t>(i)];
      const double value = stress.at(test.strain_of(driven)).stress + test.apparatus(driven);
      csv.cell(driven * test.driver_per_si);
      csv.cell(measured(value, experiment.instrument.force_noise,
                        experiment.instrument.force_resolution, random));
      csv.end_row();
    }
    stress.turn_at(test.strain_of(stretch.turn), {});
  }
  return csv.text();
}

bool goes_both_ways(const LabExperiment& experiment) {
  return experiment.type == "shear-cycles" || experiment.type == "pure-bending";
}

constexpr int kFewestRows = 9;  // of a half cycle: with fewer, its reversals cannot be found again

// Rows of the shortest way between two reversals.
double rows_of_shortest_leg(const LabExperiment& experiment) {
  const auto [least, most] = std::minmax_element(experiment.peaks.begin(), experiment.peaks.end());
  const bool both_ways = goes_both_ways(experiment);
  double slack = both_ways ? 0 : experiment.slack / experiment.length;
  if (experiment.type == "buckling-bend") slack = -slack;  // its clamps go on from there
  const double reach = both_ways ? 2 * *most : *most + slack;
  return (*least + slack) / reach * (experiment.samples - 1);
}

void require_rows_between_reversals(const LabExperiment& experiment) {
  if (experiment.peaks.empty() || experiment.type == "hanging-weights") return;
  const double rows = rows_of_shortest_leg(experiment);
  if (rows >= kFewestRows) return;
  throw InputError(
      {experiment.where.file, experiment.where.line, experiment.where.field + ".samples"},
      fmt::format("the shortest half cycle would have {:.0f} rows", rows),
      fmt::format("at least {}: more `samples`, or no such small peak", kFewestRows));
}

std::string measure(const LabExperiment& experiment, const ComponentLaw& law, const VirtualLab& lab,
                    RandomStream& random) {
  if (experiment.type == "hanging-weights") return hang(experiment, law, lab, random);
  if (experiment.type == "tensile-cycles") return pull(experiment, law, lab, random);
  if (experiment.type == "buckling-bend") {
    return measure_buckling(experiment, law, lab.material.density, random);
  }
  if (measures_profiles(experiment.type)) {
    return measure_profiles(experiment, law, lab.material.density, random);
  }
  if (experiment.type == "bending-length") {
    return measure_overhangs(experiment, law, lab.material.density, random);
  }
  if (experiment.type == "pure-bending") return to_and_fro(experiment, bending_test(), law, random);
  return to_and_fro(experiment, shear_test(experiment.transverse_tension), law, random);
}

// A text as YAML reads it back, whatever is in it: JSON's quotes are YAML's.
std::string yaml_text(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string study_entry(const LabExperiment& e, const std::string& data) {
  std::string text = fmt::format("  - name: {}\n    type: {}\n    data: {}\n", yaml_text(e.name),
                                 e.type, yaml_text(data));
  if (e.type == "shear-cycles") {
    if (e.transverse_tension > 0) {
      text += fmt::format("    transverse_tension: {} N/m\n", e.transverse_tension);
    }
    return text + "    initial_friction: rest\n";
  }
  if (e.type == "pure-bending") {
    return text + fmt::format("    direction: {}\n    initial_friction: rest\n", e.direction);
  }
  text += fmt::format("    direction: {}\n    width: {} m\n", e.direction, e.width);
  if (e.type == "cantilever") return text;
  if (e.type == "bending-length") return text + fmt::format("    angle: {} rad\n", e.angle);
  text += fmt::format("    length: {} m\n", e.length);
  if (e.type == "rolled-strip") return text;
  if (e.type == "buckling-bend") {
    text += fmt::format("    side: {}\n", name_of(e.side));
    return e.strip_length == e.length ? text : text + "    rest_length: unknown\n";
  }
  if (e.type == "tensile-cycles") return text + "    initial_friction: rest\n";
  if (e.clip_mass > 0) text += fmt::format("    clip_mass: {} kg\n", e.clip_mass);
  return text;
}

std::string session_entry(const std::string& name, const VirtualSession& session) {
  std::string entry =
      fmt::format("  - name: {0}\n    type: session\n    data: {0}\n", yaml_text(name));
  const bool has_cords = session_test_kind(session.test).clip_mass > 0;
  if (has_cords && session.noise.cord_friction > 0) entry += "    cord_friction: unknown\n";
  return entry;
}

std::string study_text(const VirtualLab& lab, std::uint64_t seed) {
  const std::string source =
      fmt::format("virtual measurements of the material {}, seed {}", lab.material.name, seed);
  std::string study = fmt::format("pliant: study/1\nname: {}\n", yaml_text(lab.name));
  if (lab.material.density > 0) study += fmt::format("density: {} kg/m^2\n", lab.material.density);
  study += fmt::format("info:\n  source: {}\nexperiments:\n", yaml_text(source));
  for (const LabExperiment& experiment : lab.experiments) {
    if (experiment.type == "session") {
      for (const std::string& session : session_names(lab, experiment)) {
        study += session_entry(session, experiment.session);
      }
      continue;
    }
    study += study_entry(experiment, experiment.name + (lab.specimens == 1 ? ".csv" : "-*.csv"));
  }
  study += fmt::format("model: {{membrane: {}}}\n", name_of(lab.material.membrane));
  if (!lab.validate.empty()) study += "validate:\n";
  for (const std::string& pattern : lab.validate) study += "  - " + yaml_text(pattern) + "\n";
  return study;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> make_measurements(const VirtualLab& lab,
                                                                   const RunContext& context) {
  std::vector<std::pair<std::string, std::string>> files;
  RandomStream root(context.seed);
  for (const LabExperiment& experiment : lab.experiments) {
    if (experiment.type == "session") continue;
    require_rows_between_reversals(experiment);
    const ComponentLaw law =
        *law_of(lab.material, component_of_test(experiment.type, experiment.direction));
    for (int specimen = 1; specimen <= lab.specimens; ++specimen) {
      context.stop.throw_if_requested();
      RandomStream random = root.split(fmt::format("{}/{}", experiment.name, specimen));
      const ComponentLaw own = specimen_law(law, lab.specimen_variation, random);
      const std::string name = lab.specimens == 1
                                   ? experiment.name + ".csv"
                                   : fmt::format("{}-{:02}.csv", experiment.name, specimen);
      files.emplace_back(name, measure(experiment, own, lab, random));
    }
  }
  for (auto& file : make_sessions(lab, context)) files.push_back(std::move(file));
  files.emplace_back("study.yaml", study_text(lab, context.seed));
  return files;
}

}  // namespace pliant
