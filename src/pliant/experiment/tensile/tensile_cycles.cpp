#include "pliant/experiment/tensile/tensile_cycles.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/experiment/clamp_column.h"
#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/loop_metrics.h"
#include "pliant/experiment/strip_figures.h"
#include "pliant/experiment/tensile/strip_pull.h"

namespace pliant {
namespace {

constexpr double kSlackShare = 0.995;  // clamps nearer than this share of the gauge length: slack
constexpr int kSlackRows = 5;          // rows needed to read the force offset off
constexpr double kForceOffsetShare = 0.1;  // bounds of nuisance parameters: of the peak force
constexpr double kSettlingShare = 0.01;    // of the way, that clamps may go the other way round
constexpr double kRestLengthShare = 0.1;   // and of the gauge length
constexpr double kGivenWayShare = 0.1;
constexpr double kExpectedSlip = 0.5e-3;        // m, at the peak force
constexpr double kExpectedCompliance = 0.2e-3;  // m, at the peak force

}  // namespace

TensileCycles::TensileCycles(const UniaxialGeometry& geometry, const SampledPath& path,
                             const Clamps& clamps)
    : geometry_(geometry), clamps_(clamps), length_(path.value) {
  const auto rows = static_cast<int>(length_.size());
  info_.time = path.time;
  measured_ = Eigen::VectorXd::Zero(rows);
  Specimen specimen;
  specimen.rows.count = rows;
  specimen.half_cycles = path.half_cycles;
  specimens_.push_back(std::move(specimen));
}

namespace {

/// Testers of the KES family write the force per width.
Dimension force_dimension(const DataRows& data) {
  const bool per_width =
      unit_conversion(data.quantity_unit("force"), Dimension::force_per_length).has_value();
  return per_width ? Dimension::force_per_length : Dimension::force;
}

std::vector<double> forces_of(const DataRows& data, double width) {
  const Dimension dimension = force_dimension(data);
  std::vector<double> force = data.quantity("force", dimension);
  if (dimension == Dimension::force_per_length) {
    for (double& f : force) f *= width;
  }
  return force;
}

bool is_counted_negative(const std::vector<double>& values) {
  const auto [least, most] = std::ranges::minmax_element(values);
  return *least < 0 && *most < -kSettlingShare * *least;
}

/// Some machines count a pull negative: where its way and its force both are, they are turned
/// round. Of a way alone it stays open what was meant.
void turn_round(std::vector<double>& way, const DataRows& data, PulledRows& rows) {
  if (!is_counted_negative(way)) return;
  if (!is_counted_negative(rows.force)) {
    const auto furthest = std::ranges::min_element(way) - way.begin();
    throw InputError(data.location(static_cast<int>(furthest), rows.column),
                     "a pull is counted negative, and its force is not",
                     fmt::format("`{}` that grows while the strip is stretched (the column with "
                                 "the other sign)",
                                 rows.column));
  }
  for (auto* values : {&way, &rows.force}) {
    for (double& value : *values) value = -value;
  }
  rows.is_turned = true;
}

PulledRows pulled_rows(const DataRows& data, double gauge_length, double width) {
  ClampColumn way = clamp_column(data);
  PulledRows rows{way.name, {}, {}, forces_of(data, width)};
  if (way.name != "length") turn_round(way.values, data, rows);
  rows.length = way.lengths(gauge_length);
  require_positive(rows.length, data, rows.column);
  rows.unit = data.quantity_unit(rows.column);
  return rows;
}

std::vector<std::string> questions_of(const TensileCycles& cycles, const ExperimentSpec& spec,
                                      const DataRows& data, PulledRows rows, double density) {
  rows.is_driven = true;
  rows.comes_back = unloads(cycles.path());
  StripFigures strip(*spec.test, density);
  const auto other_slip = strip.add_pull(
      rows, strip.column("force", force_dimension(data), data.quantity_unit("force")));
  strip.add_rate(rows, cycles.info().time,
                 strip.column("time", Dimension::time, data.quantity_unit("time")));
  return first_asked({swap_question(cycles, rows.column, "force"), other_slip, strip.question()});
}

}  // namespace

TensileCycles::TensileCycles(const ExperimentSpec& spec, const DataRows& data,
                             const ClothFacts& cloth)
    : geometry_{spec.test->length, spec.test->width, cloth.membrane},
      apparatus_friction_(spec_of<TensileCyclesSpec>(spec).apparatus_friction),
      clamps_(spec_of<TensileCyclesSpec>(spec).clamps) {
  const PulledRows rows = pulled_rows(data, geometry_.gauge_length, geometry_.width);
  const std::vector<double>& force = rows.force;
  length_ = rows.length;
  require_rows(data.specimens(), data, 3);
  require_change(force, data, "force");
  require_change(length_, data, "length");

  measured_ = Eigen::Map<const Eigen::VectorXd>(force.data(), static_cast<int>(force.size()));
  info_ = describe_experiment(spec, data, {"force_N", "force", "N", 1});
  if (rows.is_turned) {
    info_.handled.push_back(
        fmt::format("`{}` and `force` count a pull negative: both are turned round", rows.column));
  }
  for (const SpecimenRows& specimen : data.specimens()) add_specimen(specimen, spec);
  path_.time = info_.time;
  describe(spec);
  info_.questions = questions_of(*this, spec, data, rows, cloth.density);
  if (info_.questions.empty()) ask_of_rest_length(spec_of<TensileCyclesSpec>(spec));
}

std::span<const double> TensileCycles::lengths_of(const SpecimenRows& rows) const {
  return {length_.data() + rows.first, static_cast<size_t>(rows.count)};
}

void TensileCycles::add_specimen(const SpecimenRows& rows, const ExperimentSpec& spec) {
  Specimen specimen;
  specimen.rows = rows;
  const std::span<const double> lengths = lengths_of(rows);
  const double threshold = reversal_threshold(lengths, spec.noise.length.value_or(0));
  specimen.half_cycles = half_cycles_of(lengths, threshold);
  for (int i = rows.first; i < rows.first + rows.count; ++i) {
    if (length_[static_cast<size_t>(i)] >= kSlackShare * geometry_.gauge_length) continue;
    specimen.slack_force += measured_(i);
    ++specimen.slack_rows;
  }
  if (specimen.slack_rows > 0) specimen.slack_force /= specimen.slack_rows;
  if (specimen.slack_rows < kSlackRows) specimen.slack_force = 0;

  const auto& own = spec_of<TensileCyclesSpec>(spec);
  exclude_conditioning(specimen, own.precondition_cycles);
  const size_t number = specimens_.size();
  add_nuisance(specimen, number, own);
  read_path(specimen, static_cast<int>(number));
  specimens_.push_back(std::move(specimen));
}

// The first cycles condition the specimen: they carry its state and stay out of the fit.
void TensileCycles::exclude_conditioning(const Specimen& specimen, int cycles) {
  int loadings = 0;
  for (const HalfCycle& half : specimen.half_cycles) {
    if (half.direction == 1) ++loadings;
    if (cycles == 0 || loadings > cycles) return;
    std::fill_n(info_.used.begin() + specimen.rows.first + half.first, half.last - half.first + 1,
                0);
  }
}

void TensileCycles::add_nuisance(Specimen& specimen, size_t number, const TensileCyclesSpec& spec) {
  const auto add = [&](std::string_view name, const char* unit, double start, double lower,
                       double upper, double scale) {
    nuisance_.push_back({nuisance_name(info_, number, name), unit, start, lower, upper, scale});
    return static_cast<int>(nuisance_.size()) - 1;
  };
  const double peak =
      std::abs(measured_.segment(specimen.rows.first, specimen.rows.count).maxCoeff());
  const double offset = std::max(kForceOffsetShare * peak, 2 * std::abs(specimen.slack_force));
  specimen.nuisance.force_offset =
      add("force_offset", "N", specimen.slack_force, -offset, offset, 0.01 * peak);
  if (spec.rest_length == RestLength::unknown) free_rest_length(specimen, number);
  // How far clamps and apparatus may give way at the peak force, and what is expected of them.
  const auto add_given_way = [&](const char* name, double expected) {
    const double most = kGivenWayShare * geometry_.gauge_length;
    const int index = add(name, "m/N", 0, 0, most / peak, expected / peak);
    nuisance_.back().prior = GaussianPrior{0, expected / peak};
    return index;
  };
  if (!clamps_.slip_is_known) specimen.nuisance.slip = add_given_way("slip", kExpectedSlip);
  if (!clamps_.compliance_is_known) {
    specimen.nuisance.compliance = add_given_way("compliance", kExpectedCompliance);
  }
  if (spec.initial_friction == InitialFriction::unknown) {
    // A slack strip can only hold a persistent strain, i.e. friction that pushes.
    const bool slack = length_[static_cast<size_t>(specimen.rows.first)] < geometry_.gauge_length;
    specimen.nuisance.initial_friction =
        add("initial_friction", "1", slack ? -0.1 : 0.0, -1, slack ? 0 : 1, 0.5);
    nuisance_.back().of_friction = true;
  }
}

void TensileCycles::free_rest_length(Specimen& specimen, size_t number) {
  const double change = kRestLengthShare * geometry_.gauge_length;
  specimen.nuisance.rest_length_change = static_cast<int>(nuisance_.size());
  nuisance_.push_back(
      {nuisance_name(info_, number, "rest_length_change"), "m", 0, -change, change, 0.1 * change});
}

std::unique_ptr<ComponentExperiment> TensileCycles::with_free_length() const {
  if (specimens_.front().nuisance.rest_length_change >= 0) return nullptr;
  auto copy = std::make_unique<TensileCycles>(*this);
  for (size_t i = 0; i < specimens_.size(); ++i) copy->free_rest_length(copy->specimens_[i], i);
  return copy;
}

void TensileCycles::read_path(const Specimen& specimen, int number) {
  const auto load = [this](int row, int direction) {
    const double strain = strain_at(geometry_, length_[static_cast<size_t>(row)]);
    return CarriedLoad{strain, measured_(row) - direction * apparatus_friction_,
                       force_factor(geometry_, strain)};
  };
  append_half_cycles(specimen.rows, number, specimen.half_cycles, load, path_);
}

// A strip that pulls before the clamps are at its length is shorter than stated.
void TensileCycles::ask_of_rest_length(const TensileCyclesSpec& spec) {
  constexpr double kRiseShare = 0.03;  // of the peak
  if (spec.rest_length == RestLength::unknown) return;
  for (const Specimen& specimen : specimens_) {
    const auto first = specimen.rows.first;
    int slack = 0;  // rows at the start
    while (slack < specimen.rows.count &&
           length_[static_cast<size_t>(first + slack)] < kSlackShare * geometry_.gauge_length) {
      ++slack;
    }
    if (slack < kSlackRows) continue;
    const double rise = measured_(first + slack - 1) - measured_(first);
    if (rise < kRiseShare * measured_.segment(first, specimen.rows.count).maxCoeff()) continue;
    info_.questions.push_back(fmt::format(
        "the force rises by {} before the clamps are at the stated length of {}: is the strip "
        "shorter than that (`rest_length: unknown` finds its length)?",
        format_quantity(rise, Dimension::force),
        format_quantity(geometry_.gauge_length, Dimension::length)));
    return;
  }
}

void TensileCycles::describe(const ExperimentSpec& spec) {
  const auto& own = spec_of<TensileCyclesSpec>(spec);
  int slack = 0, turns = 0;
  double overshoot = 0;
  for (const Specimen& specimen : specimens_) {
    slack += specimen.slack_rows;
    turns += static_cast<int>(specimen.half_cycles.size()) - 1;
    for (const HalfCycle& half : specimen.half_cycles) {
      const double last = length_[static_cast<size_t>(specimen.rows.first + half.last)];
      overshoot = std::max(overshoot, std::abs(half.turn - last));
    }
  }
  auto& handled = info_.handled;
  handled.push_back(fmt::format("the clamp distance drives the path; {} reversals found", turns));
  if (overshoot > 0) {
    handled.push_back(
        fmt::format("reversals fall between samples: taken up to {} beyond the last sample",
                    millimetres(overshoot)));
  }
  if (slack > 0) {
    handled.push_back(fmt::format(
        "clamps nearer than the gauge length in {} rows: the strip is slack there and carries no "
        "force",
        slack));
  }
  if (spec.role == ExperimentRole::fit) describe_nuisance(spec);
  handled.push_back(
      apparatus_friction_ > 0
          ? fmt::format("stated friction of the apparatus, {:.4g} N, is taken off",
                        apparatus_friction_)
          : "friction of the apparatus is not stated: if there is any, it is part of a");
  if (own.precondition_cycles > 0) {
    handled.push_back(
        fmt::format("the first {} cycle(s) condition the specimen: carried along, "
                    "not fitted",
                    own.precondition_cycles));
  }
  if (own.pretension > 0) {
    handled.push_back(fmt::format(
        "the gauge length was set at a pretension of {:.4g} N: the rest length differs from it",
        own.pretension));
  }
}

void TensileCycles::describe_nuisance(const ExperimentSpec& experiment) {
  const auto& spec = spec_of<TensileCyclesSpec>(experiment);
  info_.handled.push_back(
      spec.rest_length == RestLength::unknown
          ? "force offset and rest length are estimated along (nuisance parameters)"
          : "the force offset is estimated along (nuisance parameter); the rest "
            "length is the stated gauge length");
  if (experiment.after.empty()) {
    info_.handled.push_back(
        spec.initial_friction == InitialFriction::rest
            ? "friction starts at rest"
            : "the friction state at the first row is unknown and estimated along");
  }
  if (!clamps_.slip_is_known) {
    info_.handled.emplace_back(
        "cloth that the pull draws out of the clamps is estimated along: slip times the largest "
        "force so far, expected to be some 0.5 mm at the peak");
  }
  if (!clamps_.compliance_is_known) {
    info_.handled.emplace_back(
        "how far the apparatus gives way to the pull is estimated along, expected to be some "
        "0.2 mm at the peak force");
  }
}

void TensileCycles::follow(const ComponentExperiment& earlier, const Location& where) {
  const auto& before = dynamic_cast<const TensileCycles&>(earlier);
  if (before.specimens_.size() != specimens_.size()) {
    throw InputError(
        where,
        fmt::format("{} has {} specimens, and this test has {}", quoted_value(before.info().name),
                    before.specimens_.size(), specimens_.size()),
        "as many, in the same order: a strip is followed from one test to the next");
  }
  for (size_t i = 0; i < specimens_.size(); ++i) {
    const Specimen& strip = before.specimens_[i];
    const auto lengths = before.lengths_of(strip.rows);
    const auto times = before.times_of(strip.rows);
    std::vector<PastPull>& past = specimens_[i].past;
    past = strip.past;
    past.push_back({before.geometry_,
                    before.clamps_,
                    {lengths.begin(), lengths.end()},
                    {times.begin(), times.end()},
                    strip.half_cycles});
  }
  info_.handled.push_back(
      fmt::format("follows {} on the same strip: it starts in the state that this has left, and "
                  "its length is that of the strip as it was left",
                  before.info().name));
}

std::optional<PathPoint> TensileCycles::left_by(const std::vector<PastPull>& past,
                                                const ComponentLaw& law, int parameters) {
  std::optional<PathPoint> state;
  for (const PastPull& pull : past) {
    const StripSetup setup{.slip = pull.clamps.slip, .compliance = pull.clamps.compliance};
    state = state_after_pull(law, pull.geometry, setup, pull.length, pull.half_cycles, parameters,
                             pull.time, state ? &*state : nullptr);
    if (!state) return std::nullopt;
  }
  return state;
}

std::optional<Prediction> TensileCycles::predict(const ComponentLaw& law,
                                                 const Eigen::VectorXd& nuisance,
                                                 bool with_jacobian) const {
  const int parameters =
      with_jacobian ? law.parameter_count() + static_cast<int>(nuisance_.size()) : 0;
  const auto value = [&](int index) { return index < 0 ? 0.0 : nuisance(index); };
  const auto column = [&](int index) {
    return index < 0 || !with_jacobian ? -1 : law.parameter_count() + index;
  };
  Prediction prediction{Eigen::VectorXd(rows()), Eigen::MatrixXd(rows(), parameters),
                        Eigen::VectorXd(rows()), Eigen::VectorXd(rows())};
  for (const Specimen& specimen : specimens_) {
    const StripColumns& own = specimen.nuisance;
    const StripSetup setup{value(own.force_offset),
                           value(own.rest_length_change),
                           value(own.initial_friction),
                           apparatus_friction_,
                           own.slip < 0 ? clamps_.slip : value(own.slip),
                           own.compliance < 0 ? clamps_.compliance : value(own.compliance)};
    const StripColumns columns{column(own.force_offset), column(own.rest_length_change),
                               column(own.initial_friction), column(own.slip),
                               column(own.compliance)};
    const std::optional<PathPoint> before = left_by(specimen.past, law, parameters);
    if (!before && !specimen.past.empty()) return std::nullopt;
    const auto forces =
        pull_strip(law, geometry_, setup, columns, lengths_of(specimen.rows), specimen.half_cycles,
                   parameters, times_of(specimen.rows), before ? &*before : nullptr);
    if (!forces) return std::nullopt;
    prediction.value.segment(specimen.rows.first, specimen.rows.count) = forces->force;
    prediction.strain.segment(specimen.rows.first, specimen.rows.count) = forces->strain;
    prediction.length_gain.segment(specimen.rows.first, specimen.rows.count) = forces->length_gain;
    prediction.jacobian.middleRows(specimen.rows.first, specimen.rows.count) = forces->jacobian;
  }
  return prediction;
}

Eigen::VectorXd TensileCycles::unfitted_nuisance(const ComponentLaw&) const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<int>(nuisance_.size()));
  for (const Specimen& specimen : specimens_) {
    values(specimen.nuisance.force_offset) = specimen.slack_force;
  }
  return values;
}

Eigen::VectorXd TensileCycles::force_offsets() const {
  Eigen::VectorXd offsets(static_cast<int>(specimens_.size()));
  for (std::size_t i = 0; i < specimens_.size(); ++i) {
    offsets(static_cast<Eigen::Index>(i)) = specimens_[i].slack_force;
  }
  return offsets;
}

Eigen::VectorXd TensileCycles::instrument_zero(const Eigen::VectorXd& nuisance) const {
  Eigen::VectorXd zero(rows());
  for (const Specimen& specimen : specimens_) {
    const int offset = specimen.nuisance.force_offset;
    zero.segment(specimen.rows.first, specimen.rows.count)
        .setConstant(offset < 0 ? 0 : nuisance(offset));
  }
  return zero;
}

std::optional<LoopSeries> TensileCycles::loop(const Eigen::VectorXd& force) const {
  return LoopSeries{Eigen::Map<const Eigen::VectorXd>(length_.data(), rows()), force,
                    geometry_.width, geometry_.gauge_length};
}

}  // namespace pliant
