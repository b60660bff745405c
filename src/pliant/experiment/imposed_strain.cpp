#include "pliant/experiment/imposed_strain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"
#include "pliant/material/law_path.h"

namespace pliant {
namespace {

enum NuisanceIndex { kOffset, kInitialFriction };

std::vector<double> factors_of(StrainRecord& record) {
  if (record.factor.empty()) record.factor.assign(record.driven.size(), 1);
  return std::move(record.factor);
}

}  // namespace

ImposedStrain::ImposedStrain(StrainRecord record, const SampledPath& path)
    : apparatus_(std::move(record.apparatus)), factor_(factors_of(record)) {
  for (const double driven : record.driven) strain_.push_back(record.strain_of(driven));
  const auto rows = static_cast<int>(strain_.size());
  info_.time = path.time;
  measured_ = Eigen::VectorXd::Zero(rows);
  Specimen specimen;
  specimen.rows.count = rows;
  specimen.half_cycles = path.half_cycles;
  for (HalfCycle& half : specimen.half_cycles) half.turn = record.strain_of(half.turn);
  specimens_.push_back(std::move(specimen));
}

ImposedStrain::ImposedStrain(const ExperimentSpec& spec, InitialFriction start,
                             const DataRows& data, StrainRecord record)
    : apparatus_(std::move(record.apparatus)), factor_(factors_of(record)) {
  require_rows(data.specimens(), data, 3);
  for (const double driven : record.driven) strain_.push_back(record.strain_of(driven));
  measured_ = Eigen::Map<const Eigen::VectorXd>(record.measured.data(),
                                                static_cast<int>(record.measured.size()));
  info_ = describe_experiment(spec, data, record.quantity);
  const bool rested = start == InitialFriction::rest;
  for (const SpecimenRows& rows : data.specimens()) add_specimen(rows, record, rested);
  path_.time = info_.time;
  describe_start(spec, start);
}

double ImposedStrain::secant() const {
  const auto [least, most] = std::ranges::minmax_element(strain_);
  return (measured_(most - strain_.begin()) - measured_(least - strain_.begin())) /
         (*most - *least);
}

double ImposedStrain::largest_strain() const {
  return std::abs(*std::ranges::max_element(strain_, {}, [](double s) { return std::abs(s); }));
}

std::optional<std::string> ImposedStrain::sign_question(std::string_view measured,
                                                        std::string_view driven) const {
  if (secant() > 0) return std::nullopt;
  return fmt::format("`{}` falls while `{}` grows: is one of them counted the other way?", measured,
                     driven);
}

void ImposedStrain::add_specimen(const SpecimenRows& rows, const StrainRecord& record,
                                 bool rested) {
  Specimen specimen;
  specimen.rows = rows;
  specimen.rested = rested;
  specimen.first_nuisance = static_cast<int>(nuisance_.size());
  // Turning points lie where even speed puts them: in what the machine moves, not in the strain.
  const std::span<const double> driven(record.driven.data() + rows.first,
                                       static_cast<size_t>(rows.count));
  specimen.half_cycles = half_cycles_of(driven, reversal_threshold(driven, 0));
  for (HalfCycle& half : specimen.half_cycles) half.turn = record.strain_of(half.turn);

  const size_t number = specimens_.size();
  const double peak = measured_.segment(rows.first, rows.count).cwiseAbs().maxCoeff();
  const std::string& unit = record.offset_unit.empty() ? record.quantity.unit : record.offset_unit;
  nuisance_.push_back(
      {nuisance_name(info_, number, record.offset), unit, 0, -0.2 * peak, 0.2 * peak, 0.01 * peak});
  if (!rested) {
    nuisance_.push_back(
        {nuisance_name(info_, number, "initial_friction"), "1", 0, -1, 1, 0.5, true});
  }

  const auto load = [this](int row, int) {
    const auto index = static_cast<size_t>(row);
    return CarriedLoad{strain_[index], measured_(row) - apparatus_[index], factor_[index]};
  };
  append_half_cycles(rows, static_cast<int>(number), specimen.half_cycles, load, path_);
  specimens_.push_back(std::move(specimen));
}

void ImposedStrain::describe_start(const ExperimentSpec& spec, InitialFriction start) {
  if (spec.role == ExperimentRole::validate) return;
  info_.handled.push_back(fmt::format("an offset of the {} is estimated along (nuisance parameter)",
                                      info_.quantity.kind));
  info_.handled.push_back(start == InitialFriction::rest
                              ? "friction starts at rest"
                              : "the friction state at the first row is unknown and estimated "
                                "along");
}

std::optional<Prediction> ImposedStrain::predict(const ComponentLaw& law,
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

void ImposedStrain::predict_specimen(const Specimen& specimen, const ComponentLaw& law,
                                     const Eigen::VectorXd& nuisance, bool with_jacobian,
                                     Prediction& prediction) const {
  const auto parameters = prediction.jacobian.cols();
  const int first_index = law.parameter_count() + specimen.first_nuisance;
  const bool ideal = specimen.first_nuisance < 0;
  const double offset = ideal ? 0 : nuisance(specimen.first_nuisance + kOffset);
  const double ratio = specimen.rested ? 0 : nuisance(specimen.first_nuisance + kInitialFriction);
  const Eigen::VectorXd fixed = Eigen::VectorXd::Zero(parameters);

  const double first_strain = strain_[static_cast<size_t>(specimen.rows.first)];
  PathPoint start{first_strain, ratio * law.max_friction(first_strain), fixed, fixed};
  if (with_jacobian && !specimen.rested && law.friction_count() > 0) {
    start.friction_gradient(law.stiffness.size()) = ratio;
    start.friction_gradient(law.stiffness.size() + 1) = ratio * std::abs(first_strain);
    start.friction_gradient(first_index + kInitialFriction) = law.max_friction(first_strain);
  }
  LawPath path(law, start, time_at(specimen.rows.first));
  for (const HalfCycle& half : specimen.half_cycles) {
    for (int i = half.first; i <= half.last; ++i) {
      const int row = specimen.rows.first + i;
      const auto index = static_cast<size_t>(row);
      const double time = time_at(row);
      const PathStress here = path.at(strain_[index], time);
      prediction.value(row) = offset + factor_[index] * here.stress + apparatus_[index];
      path.pass(strain_[index], fixed, time);
      if (!with_jacobian) continue;
      prediction.jacobian.row(row) = factor_[index] * here.gradient;
      prediction.jacobian(row, first_index + kOffset) += 1;
    }
    path.turn_at(half.turn, fixed);
  }
}

Eigen::VectorXd ImposedStrain::unfitted_nuisance(const ComponentLaw&) const {
  return Eigen::VectorXd::Zero(static_cast<int>(nuisance_.size()));
}

Eigen::VectorXd ImposedStrain::instrument_zero(const Eigen::VectorXd& nuisance) const {
  Eigen::VectorXd zero(rows());
  for (const Specimen& specimen : specimens_) {
    zero.segment(specimen.rows.first, specimen.rows.count)
        .setConstant(specimen.first_nuisance < 0 ? 0 : nuisance(specimen.first_nuisance + kOffset));
  }
  return zero;
}

std::optional<LoopSeries> ImposedStrain::loop(const Eigen::VectorXd& stress) const {
  return LoopSeries{Eigen::Map<const Eigen::VectorXd>(strain_.data(), rows()), stress};
}

}  // namespace pliant
