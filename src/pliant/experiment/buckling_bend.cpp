#include "pliant/experiment/buckling_bend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"
#include "pliant/material/bending_strain.h"

namespace pliant {
namespace {

constexpr int kElements = 6;

enum NuisanceIndex { kForceOffset, kForceDrift, kStripLength };

// Half the height of a strip of some length between clamps that are nearer: that of one wave of a
// cosine of the same length.
double half_rise(double length, double distance) {
  return std::sqrt(std::max(length * (length - distance), 0.0)) / std::numbers::pi;
}

}  // namespace

BucklingBend::BucklingBend(const ExperimentSpec& spec, double density, Side side)
    : weight_(density * kStandardGravity), width_(spec.width), sign_(side == Side::up ? 1 : -1) {
  const DataRows data(spec.data);
  distance_ = data.quantity("distance", Dimension::length);
  const std::vector<double> force = data.quantity("force", Dimension::force);
  require_rows(data.specimens(), data, 3);
  require_positive(distance_, data, "distance");
  require_change(distance_, data, "distance");
  measured_ = Eigen::Map<const Eigen::VectorXd>(force.data(), static_cast<int>(force.size()));
  info_ = describe_experiment(spec, data, {"force_N", "force", "N", 1});
  for (const SpecimenRows& rows : data.specimens()) add_specimen(rows);
  info_.handled.push_back("the clamp distance drives the path, row by row");
  info_.handled.push_back(
      "offset and drift of the force and the strip's length between the clamps are estimated along "
      "(nuisance parameters)");
}

void BucklingBend::add_specimen(const SpecimenRows& rows) {
  Specimen specimen;
  specimen.rows = rows;
  specimen.first_nuisance = static_cast<int>(nuisance_.size());
  const std::span<const double> distances(distance_.data() + rows.first,
                                          static_cast<size_t>(rows.count));
  specimen.stretches = monotone_stretches(distances, reversal_threshold(distances, 0));

  const size_t number = specimens_.size();
  const auto forces = measured_.segment(rows.first, rows.count);
  const double span = forces.maxCoeff() - forces.minCoeff();
  const double middle = (forces.maxCoeff() + forces.minCoeff()) / 2;
  const double longest = *std::max_element(distances.begin(), distances.end());
  nuisance_.push_back({nuisance_name(info_, number, "force_offset"), "N", middle,
                       middle - 20 * span, middle + 20 * span, 0.1 * span});
  nuisance_.push_back(
      {nuisance_name(info_, number, "force_drift"), "N", 0, -2 * span, 2 * span, 0.1 * span});
  nuisance_.push_back({nuisance_name(info_, number, "strip_length"), "m", 1.01 * longest,
                       1.0001 * longest, 1.1 * longest, 0.003 * longest});
  read_path(specimen, static_cast<int>(number));
  specimens_.push_back(std::move(specimen));
}

// What the middle of a strip without weight carries: the force on its rise.
void BucklingBend::read_path(const Specimen& specimen, int number) {
  const int first = specimen.first_nuisance;
  const double length = nuisance_[static_cast<size_t>(first + kStripLength)].start;
  const double offset = measured_.segment(specimen.rows.first, specimen.rows.count).maxCoeff();
  const auto load = [&](int row, int) {
    const double rise = half_rise(length, distance_[static_cast<size_t>(row)]);
    const double curvature = rise * std::pow(2 * std::numbers::pi / length, 2);
    return CarriedLoad{kStrainPerCurvature * curvature, (offset - measured_(row)) / width_ * rise,
                       1};
  };
  append_stretches(specimen.rows, number, specimen.stretches, load, path_);
}

namespace {

// A strip between clamps that move.
class ClampedStrip {
 public:
  // Flat at first, then just buckled to one side.
  ClampedStrip(const ComponentLaw& law, double weight, double length, double side)
      : law_(law),
        weight_(weight),
        strip_(length, kElements),
        history_(strip_.rested(law)),
        distance_(kJustBuckled * length) {
    const double wave = 2 * std::numbers::pi / length;
    shape_.curvature = side * half_rise(length, distance_) * wave * wave *
                       (wave * strip_.line().places().array()).cos();
  }

  const StripShape& shape() const { return shape_; }

  // Moves the clamps to a distance; where the strip does not follow, by halves of the way.
  bool move_to(double distance, bool with_derivatives) {
    constexpr int kMostHalvings = 6;
    double part = 1;
    const double from = distance_;
    for (double done = 0; done < 1;) {
      const double there = from + std::min(done + part, 1.0) * (distance - from);
      if (step_to(there, with_derivatives)) {
        done += part;
      } else {
        part /= 2;
        if (part < std::ldexp(1.0, -kMostHalvings)) return false;
      }
    }
    return true;
  }

 private:
  static constexpr double kJustBuckled = 0.998;  // of the length

  bool step_to(double distance, bool with_derivatives) {
    const StripEnds ends{0, 0, Eigen::Vector2d(distance, 0)};
    auto next = strip_.equilibrium(law_, weight_, ends, history_, shape_);
    if (!next) return false;
    if (with_derivatives) strip_.differentiate(law_, weight_, ends, history_, *next);
    history_ = strip_.accepted(law_, history_, *next);
    shape_ = std::move(*next);
    distance_ = distance;
    return true;
  }

  const ComponentLaw& law_;
  double weight_;
  Elastica strip_;
  StripHistory history_;
  StripShape shape_;
  double distance_;
};

}  // namespace

bool BucklingBend::follow(const Specimen& specimen, const ComponentLaw& law, double length,
                          bool with_jacobian, Eigen::VectorXd& force, Eigen::VectorXd& strain,
                          Eigen::MatrixXd& by_law) const {
  ClampedStrip strip(law, weight_, length, sign_);
  const int count = specimen.rows.count;
  force.resize(count);
  strain.resize(count);
  by_law.resize(count, with_jacobian ? law.parameter_count() : 0);
  for (int i = 0; i < count; ++i) {
    const double distance = distance_[static_cast<size_t>(specimen.rows.first + i)];
    if (!strip.move_to(distance, with_jacobian)) return false;
    const StripShape& shape = strip.shape();
    force(i) = shape.far_load.x();
    strain(i) = kStrainPerCurvature * shape.curvature.cwiseAbs().maxCoeff();
    if (with_jacobian) {
      by_law.row(i) = shape.far_load_by_parameter.row(0).head(law.parameter_count());
    }
  }
  return true;
}

bool BucklingBend::predict_specimen(const Specimen& specimen, const ComponentLaw& law,
                                    const Eigen::VectorXd& nuisance, bool with_jacobian,
                                    Prediction& prediction) const {
  const auto own = nuisance.segment<3>(specimen.first_nuisance);
  Eigen::VectorXd force, strain;
  Eigen::MatrixXd by_law;
  if (!follow(specimen, law, own(kStripLength), with_jacobian, force, strain, by_law)) return false;
  const int first = specimen.rows.first, count = specimen.rows.count;
  const Eigen::VectorXd share = Eigen::VectorXd::LinSpaced(count, 0, 1);
  prediction.value.segment(first, count) =
      (width_ * force + own(kForceDrift) * share).array() + own(kForceOffset);
  prediction.strain.segment(first, count) = strain;
  if (!with_jacobian) return true;

  const int column = law.parameter_count() + specimen.first_nuisance;
  auto rows = prediction.jacobian.middleRows(first, count);
  rows.leftCols(law.parameter_count()) = width_ * by_law;
  rows.col(column + kForceOffset).setOnes();
  rows.col(column + kForceDrift) = share;
  const double step = 1e-6 * own(kStripLength);
  Eigen::VectorXd longer, shorter;
  if (!follow(specimen, law, own(kStripLength) + step, false, longer, strain, by_law) ||
      !follow(specimen, law, own(kStripLength) - step, false, shorter, strain, by_law)) {
    return false;
  }
  rows.col(column + kStripLength) = width_ * (longer - shorter) / (2 * step);
  return true;
}

std::optional<Prediction> BucklingBend::predict(const ComponentLaw& law,
                                                const Eigen::VectorXd& nuisance,
                                                bool with_jacobian) const {
  const auto parameters = law.parameter_count() + static_cast<int>(nuisance_.size());
  Prediction prediction;
  prediction.value.resize(rows());
  prediction.strain.resize(rows());
  prediction.jacobian = Eigen::MatrixXd::Zero(rows(), with_jacobian ? parameters : 0);
  for (const Specimen& specimen : specimens_) {
    if (!predict_specimen(specimen, law, nuisance, with_jacobian, prediction)) return std::nullopt;
  }
  return prediction;
}

Eigen::VectorXd BucklingBend::unfitted_nuisance() const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(nuisance_.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    values(i) = nuisance_[static_cast<size_t>(i)].start;
  }
  return values;
}

LoopSeries BucklingBend::loop(const Eigen::VectorXd& force) const {
  return {Eigen::Map<const Eigen::VectorXd>(distance_.data(), rows()), force};
}

}  // namespace pliant
