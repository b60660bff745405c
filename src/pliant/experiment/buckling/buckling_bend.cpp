#include "pliant/experiment/buckling/buckling_bend.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/QR>
#include <fmt/format.h>

#include "pliant/experiment/buckling/buckling_bend_type.h"
#include "pliant/experiment/buckling/catenary.h"
#include "pliant/experiment/buckling/clamped_strip.h"
#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/strip_figures.h"
#include "pliant/material/bending_strain.h"

namespace pliant {
namespace {

constexpr double kLengthShare = 0.1;  // bounds of the strip's length: of the stated one

enum NuisanceIndex { kForceOffset, kForceDrift, kLengthChange };

void require_buckled(const std::vector<double>& distance, double length, const DataRows& data) {
  const auto longest = std::max_element(distance.begin(), distance.end());
  if (*longest < length) return;
  throw InputError(data.location(static_cast<int>(longest - distance.begin()), "distance"),
                   fmt::format("{} is not below the strip's length, {}", millimetres(*longest),
                               millimetres(length)),
                   "clamps nearer than that, between which the strip buckles");
}

// Both ways: on the way there friction cannot be told from stiffness, nor drift from either.
void require_return(const MeasuredPath& path, const DataRows& data) {
  const auto back = std::find(path.direction.begin(), path.direction.end(), -1);
  const auto there = std::find(path.direction.begin(), path.direction.end(), 1);
  if (back != path.direction.end() && there != path.direction.end()) return;
  throw InputError(data.location(0, "distance"), "the clamps move one way only",
                   "clamps that come nearer and go back");
}

// What offset and drift of the force add to each row.
Eigen::MatrixX2d zero_by_row(int count) {
  Eigen::MatrixX2d zero(count, 2);
  zero << Eigen::VectorXd::Ones(count), Eigen::VectorXd::LinSpaced(count, 0, 1);
  return zero;
}

std::vector<std::string> questions_of(const MeasuredPath& path, double farthest,
                                      const ExperimentSpec& spec, const DataRows& data,
                                      double density) {
  StripFigures strip(*spec.test, density);
  const auto distance = strip.column("distance", Dimension::length, data.quantity_unit("distance"));
  const auto force = strip.column("force", Dimension::force, data.quantity_unit("force"));
  const double start = farthest / spec.test->length;
  strip.add(figures::kStart, start, {{distance}, {strip.length(), -1}});
  const auto nearest = std::ranges::max_element(path.strain) - path.strain.begin();
  const auto row = static_cast<size_t>(nearest);
  // Its own weight adds to it: a figure of its size.
  const double stiffness = kStrainPerCurvature * path.force[row] / path.strain[row];
  if (is_plausible(figures::kStart, start) && stiffness > 0) {
    strip.add_bending_stiffness(stiffness, {{force}, {strip.width(), -1}, {strip.length(), 2}});
  }
  return first_asked({strip.question()});
}

}  // namespace

/// A strip along the rows of a specimen.
struct BucklingBend::Followed {
  Eigen::VectorXd force;   // per width, N/m
  Eigen::VectorXd strain;  // largest of the strip
  Eigen::MatrixXd by_law;  // d force / d parameters of the law; empty unless asked for
};

BucklingBend::BucklingBend(const BucklingStrip& strip, const SampledPath& path)
    : strip_(strip), weight_(strip.density * kStandardGravity), distance_(path.value) {
  const auto rows = static_cast<int>(distance_.size());
  measured_ = Eigen::VectorXd::Zero(rows);
  Specimen specimen;
  specimen.rows.count = rows;
  specimen.half_cycles = path.half_cycles;
  specimens_.push_back(std::move(specimen));
}

BucklingBend::BucklingBend(const ExperimentSpec& spec, const DataRows& data,
                           const ClothFacts& cloth)
    : strip_{spec.test->length, spec.test->width, cloth.density,
             spec_of<BucklingBendSpec>(spec).side},
      weight_(cloth.density * kStandardGravity) {
  const RestLength rest_length = spec_of<BucklingBendSpec>(spec).rest_length;
  require_density(spec, cloth.density);
  distance_ = data.quantity("distance", Dimension::length);
  const std::vector<double> force = data.quantity("force", Dimension::force);
  require_rows(data.specimens(), data, 3);
  require_positive(distance_, data, "distance");
  require_change(distance_, data, "distance");
  require_change(force, data, "force");
  require_buckled(distance_, strip_.length, data);
  measured_ = Eigen::Map<const Eigen::VectorXd>(force.data(), static_cast<int>(force.size()));
  info_ = describe_experiment(spec, data, {"force_mN", "force", "mN", 1e3});
  for (const SpecimenRows& rows : data.specimens()) add_specimen(rows, spec, rest_length);
  require_return(path_, data);
  info_.handled.push_back(
      "the clamp distance drives the path; the strip starts straight, free of friction");
  if (spec.role == ExperimentRole::fit) {
    info_.handled.push_back(
        rest_length == RestLength::known
            ? "offset and drift of the force are estimated along (nuisance parameters); the strip "
              "is as long as stated"
            : "offset and drift of the force and the strip's length are estimated along (nuisance "
              "parameters)");
  }
  info_.questions = questions_of(path_, std::ranges::max(distance_), spec, data, cloth.density);
}

void BucklingBend::add_specimen(const SpecimenRows& rows, const ExperimentSpec& spec,
                                RestLength rest_length) {
  Specimen specimen;
  specimen.rows = rows;
  specimen.first_nuisance = static_cast<int>(nuisance_.size());
  const std::span<const double> distances(distance_.data() + rows.first,
                                          static_cast<size_t>(rows.count));
  specimen.half_cycles =
      half_cycles_of(distances, reversal_threshold(distances, spec.noise.length.value_or(0)));
  specimen.length_is_known = rest_length == RestLength::known;
  const size_t number = specimens_.size();
  add_nuisance(number, rows, rest_length);
  read_path(specimen, static_cast<int>(number));
  specimens_.push_back(std::move(specimen));
}

void BucklingBend::add_nuisance(size_t number, const SpecimenRows& rows, RestLength rest_length) {
  const auto forces = measured_.segment(rows.first, rows.count);
  const double span = forces.maxCoeff() - forces.minCoeff();
  const double middle = (forces.maxCoeff() + forces.minCoeff()) / 2;
  nuisance_.push_back({nuisance_name(info_, number, "force_offset"), "N", middle,
                       middle - 20 * span, middle + 20 * span, 0.1 * span});
  nuisance_.push_back(
      {nuisance_name(info_, number, "force_drift"), "N", 0, -2 * span, 2 * span, 0.1 * span});
  if (rest_length == RestLength::known) return;
  const auto first = distance_.begin() + rows.first;
  const double longest = *std::max_element(first, first + rows.count);
  nuisance_.push_back({nuisance_name(info_, number, "rest_length_change"), "m", 0,
                       std::max(-kLengthShare * strip_.length, 1.0001 * longest - strip_.length),
                       kLengthShare * strip_.length, 0.01 * strip_.length});
}

// What the middle of a strip without weight carries: the force on its rise, were it free of force
// where the force is largest. The material is loaded where the clamps come nearer.
void BucklingBend::read_path(const Specimen& specimen, int number) {
  const double offset = measured_.segment(specimen.rows.first, specimen.rows.count).maxCoeff();
  const double wave = 2 * std::numbers::pi / strip_.length;
  const auto load = [&](int row, int) {
    const double rise = half_rise(strip_.length, distance_[static_cast<size_t>(row)]);
    return CarriedLoad{kStrainPerCurvature * rise * wave * wave,
                       (offset - measured_(row)) / strip_.width * rise, 1};
  };
  std::vector<HalfCycle> half_cycles = specimen.half_cycles;
  for (HalfCycle& half : half_cycles) half.direction = -half.direction;
  append_half_cycles(specimen.rows, number, half_cycles, load, path_);
}

std::optional<BucklingBend::Followed> BucklingBend::follow(const Specimen& specimen,
                                                           const ComponentLaw& law, double length,
                                                           bool with_derivatives) const {
  ClampedStrip strip(law, weight_, length, strip_.side, strip_.elements);
  const int count = specimen.rows.count;
  const int parameters = law.parameter_count();
  Followed followed{Eigen::VectorXd(count), Eigen::VectorXd(count),
                    Eigen::MatrixXd(count, with_derivatives ? parameters : 0)};
  for (const HalfCycle& half : specimen.half_cycles) {
    for (int i = half.first; i <= half.last; ++i) {
      const double distance = distance_[static_cast<size_t>(specimen.rows.first + i)];
      if (!strip.move_to(distance, with_derivatives)) return std::nullopt;
      const StripShape& shape = strip.shape();
      followed.force(i) = shape.far_load.x();
      followed.strain(i) = kStrainPerCurvature * shape.curvature.cwiseAbs().maxCoeff();
      if (!with_derivatives) continue;
      followed.by_law.row(i) = shape.far_load_by_parameter.row(0).head(parameters);
    }
    if (!strip.move_to(half.turn, with_derivatives)) return std::nullopt;
  }
  return followed;
}

bool BucklingBend::predict_specimen(const Specimen& specimen, const ComponentLaw& law,
                                    const Eigen::VectorXd& nuisance, bool with_jacobian,
                                    Prediction& prediction) const {
  const auto own = nuisance.tail(nuisance.size() - specimen.first_nuisance);
  const double length = strip_.length + (specimen.length_is_known ? 0 : own(kLengthChange));
  const auto followed = follow(specimen, law, length, with_jacobian);
  if (!followed) return false;
  const int first = specimen.rows.first, count = specimen.rows.count;
  const double last = count - 1;
  for (int i = 0; i < count; ++i) {
    prediction.value(first + i) =
        strip_.width * followed->force(i) + own(kForceOffset) + own(kForceDrift) * i / last;
  }
  prediction.strain.segment(first, count) = followed->strain;
  for (const HalfCycle& half : specimen.half_cycles) {
    for (int i = half.first; i <= half.last; ++i) {
      const int before = std::max(i - 1, half.first), after = std::min(i + 1, half.last);
      const double way = distance_[static_cast<size_t>(first + after)] -
                         distance_[static_cast<size_t>(first + before)];
      const double rise = strip_.width * (followed->force(after) - followed->force(before));
      prediction.length_gain(first + i) = way == 0 ? 0 : std::abs(rise / way);
    }
  }
  if (!with_jacobian) return true;

  const int column = law.parameter_count() + specimen.first_nuisance;
  auto rows = prediction.jacobian.middleRows(first, count);
  rows.leftCols(law.parameter_count()) = strip_.width * followed->by_law;
  rows.middleCols<2>(column + kForceOffset) = zero_by_row(count);
  if (specimen.length_is_known) return true;
  const double step = 1e-6 * length;
  const auto longer = follow(specimen, law, length + step, false);
  if (!longer) return false;
  rows.col(column + kLengthChange) = strip_.width * (longer->force - followed->force) / step;
  return true;
}

std::optional<Prediction> BucklingBend::predict(const ComponentLaw& law,
                                                const Eigen::VectorXd& nuisance,
                                                bool with_jacobian) const {
  const auto parameters = law.parameter_count() + static_cast<int>(nuisance_.size());
  Prediction prediction{Eigen::VectorXd(rows()),
                        Eigen::MatrixXd::Zero(rows(), with_jacobian ? parameters : 0),
                        Eigen::VectorXd(rows()), Eigen::VectorXd(rows())};
  for (const Specimen& specimen : specimens_) {
    if (!predict_specimen(specimen, law, nuisance, with_jacobian, prediction)) return std::nullopt;
  }
  return prediction;
}

Eigen::VectorXd BucklingBend::unfitted_nuisance(const ComponentLaw& law) const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(nuisance_.size()));
  const auto prediction = predict(law, values, false);
  if (!prediction) return values;
  for (const Specimen& specimen : specimens_) {
    const auto& rows = specimen.rows;
    values.segment<2>(specimen.first_nuisance) =
        best_zero(specimen, prediction->value.segment(rows.first, rows.count));
  }
  return values;
}

// Offset and drift of the force that bring a predicted force nearest to the measured one.
Eigen::Vector2d BucklingBend::best_zero(const Specimen& specimen,
                                        const Eigen::VectorXd& force) const {
  const int first = specimen.rows.first, count = specimen.rows.count;
  return zero_by_row(count).colPivHouseholderQr().solve(measured_.segment(first, count) - force);
}

std::optional<Eigen::VectorXd> BucklingBend::limp() const {
  const double pull = strip_.side == BucklingSide::down ? strip_.width : -strip_.width;
  Eigen::VectorXd values(rows());
  for (const Specimen& specimen : specimens_) {
    const int first = specimen.rows.first, count = specimen.rows.count;
    Eigen::VectorXd force(count);
    for (int i = 0; i < count; ++i) {
      const double distance = distance_[static_cast<size_t>(first + i)];
      if (distance >= strip_.length) return std::nullopt;
      force(i) = pull * catenary_pull(weight_, strip_.length, distance);
    }
    values.segment(first, count) = force + zero_by_row(count) * best_zero(specimen, force);
  }
  return values;
}

double BucklingBend::reference() const { return measured_.maxCoeff() - measured_.minCoeff(); }

}  // namespace pliant
