#include "pliant/experiment/shear_cycles.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/friction_path.h"

namespace pliant {
namespace {

enum NuisanceIndex { kForceOffset, kInitialFriction };

}  // namespace

ShearCycles::ShearCycles(const ExperimentSpec& spec)
    : transverse_tension_(spec.transverse_tension) {
  const DataRows data(spec.data);
  angle_ = data.quantity("angle", Dimension::angle);
  const std::vector<double> force = data.quantity("force", Dimension::force_per_length);
  require_rows(data.specimens(), data, 3);
  require_change(force, data, "force");
  require_change(angle_, data, "angle");
  for (size_t i = 0; i < angle_.size(); ++i) {
    if (std::abs(angle_[i]) >= std::numbers::pi / 2) {
      throw InputError(data.location(static_cast<int>(i), "angle"), "is 90 degrees or more",
                       "a shear angle below 90 degrees");
    }
    strain_.push_back(std::sin(angle_[i]));
  }
  measured_ = Eigen::Map<const Eigen::VectorXd>(force.data(), static_cast<int>(force.size()));
  info_ = describe_experiment(spec, data, {"force_N_per_m", "force per width", "N/m", 1});
  for (const SpecimenRows& rows : data.specimens()) add_specimen(rows, spec);
  describe(spec);
}

void ShearCycles::add_specimen(const SpecimenRows& rows, const ExperimentSpec& spec) {
  Specimen specimen;
  specimen.rows = rows;
  specimen.rested = spec.initial_friction == InitialFriction::rest;
  specimen.first_nuisance = static_cast<int>(nuisance_.size());
  // The machine moves the angle at even speed, not its sine.
  const std::span<const double> angles(angle_.data() + rows.first, static_cast<size_t>(rows.count));
  specimen.stretches = monotone_stretches(angles, reversal_threshold(angles, 0));
  for (Stretch& stretch : specimen.stretches) stretch.turn = std::sin(stretch.turn);

  const size_t number = specimens_.size();
  const double peak = measured_.segment(rows.first, rows.count).cwiseAbs().maxCoeff();
  nuisance_.push_back({nuisance_name(info_, number, "force_offset"), "N/m", 0, -0.2 * peak,
                       0.2 * peak, 0.01 * peak});
  if (!specimen.rested) {
    nuisance_.push_back(
        {nuisance_name(info_, number, "initial_friction"), "1", 0, -1, 1, 0.5, true});
  }

  const auto load = [this](int row, int) {
    const auto index = static_cast<size_t>(row);
    return CarriedLoad{strain_[index],
                       measured_(row) - transverse_tension_ * std::tan(angle_[index]), 1};
  };
  append_stretches(rows, static_cast<int>(number), specimen.stretches, load, path_);
  specimens_.push_back(std::move(specimen));
}

void ShearCycles::describe(const ExperimentSpec& spec) {
  info_.handled.push_back(
      "the angle drives the path; strain is sin(angle): yarns keep their length");
  info_.handled.push_back(
      transverse_tension_ > 0
          ? fmt::format("the transverse tension, {:.4g} N/m, adds T tan(angle)",
                        transverse_tension_)
          : "no transverse tension is stated: its share of the force is part of the stiffness");
  if (spec.role == ExperimentRole::validate) return;
  info_.handled.push_back("the force offset is estimated along (nuisance parameter)");
  info_.handled.push_back(spec.initial_friction == InitialFriction::rest
                              ? "friction starts at rest"
                              : "the friction state at the first row is unknown and estimated "
                                "along");
}

std::optional<Prediction> ShearCycles::predict(const ComponentLaw& law,
                                               const Eigen::VectorXd& nuisance,
                                               bool with_jacobian) const {
  const auto parameters = law.parameter_count() + static_cast<int>(nuisance_.size());
  Prediction prediction;
  prediction.value.resize(rows());
  prediction.strain = Eigen::Map<const Eigen::VectorXd>(strain_.data(), rows());
  prediction.jacobian.resize(rows(), with_jacobian ? parameters : 0);
  for (const Specimen& specimen : specimens_) {
    predict_specimen(specimen, law, nuisance, with_jacobian, prediction);
  }
  return prediction;
}

void ShearCycles::predict_specimen(const Specimen& specimen, const ComponentLaw& law,
                                   const Eigen::VectorXd& nuisance, bool with_jacobian,
                                   Prediction& prediction) const {
  const auto parameters = prediction.jacobian.cols();
  const int first_index = law.parameter_count() + specimen.first_nuisance;
  const double offset = nuisance(specimen.first_nuisance + kForceOffset);
  const double ratio = specimen.rested ? 0 : nuisance(specimen.first_nuisance + kInitialFriction);
  const Eigen::VectorXd fixed = Eigen::VectorXd::Zero(parameters);

  const double first_strain = strain_[static_cast<size_t>(specimen.rows.first)];
  PathPoint start{first_strain, ratio * law.max_friction(first_strain), fixed, fixed};
  if (with_jacobian && !specimen.rested && law.friction_count() > 0) {
    start.friction_gradient(law.stiffness.size()) = ratio;
    start.friction_gradient(law.stiffness.size() + 1) = ratio * std::abs(first_strain);
    start.friction_gradient(first_index + kInitialFriction) = law.max_friction(first_strain);
  }
  FrictionPath path(law, start);
  for (const Stretch& stretch : specimen.stretches) {
    for (int i = stretch.first; i <= stretch.last; ++i) {
      const int row = specimen.rows.first + i;
      const auto index = static_cast<size_t>(row);
      const PathStress here = path.at(strain_[index]);
      prediction.value(row) = offset + here.stress + transverse_tension_ * std::tan(angle_[index]);
      if (!with_jacobian) continue;
      prediction.jacobian.row(row) = here.gradient;
      prediction.jacobian(row, first_index + kForceOffset) += 1;
    }
    path.turn_at(stretch.turn, fixed);
  }
}

Eigen::VectorXd ShearCycles::unfitted_nuisance() const {
  return Eigen::VectorXd::Zero(static_cast<int>(nuisance_.size()));
}

LoopSeries ShearCycles::loop(const Eigen::VectorXd& force) const {
  return {Eigen::Map<const Eigen::VectorXd>(strain_.data(), rows()), force};
}

}  // namespace pliant
