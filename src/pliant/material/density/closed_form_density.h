#pragma once

#include <array>

#include "pliant/material/density/density.h"

namespace pliant {

/// Most parameters of an energy in closed form.
inline constexpr int kMaxEnergyParameters = 3;

/// An energy of one strain, with what laws need of it.
struct EnergyAt {
  double energy = 0;
  double stress = 0;
  double tangent = 0;
  std::array<double, kMaxEnergyParameters> stress_by_parameter{};
  std::array<double, kMaxEnergyParameters> energy_by_parameter{};
};

/// @param values  of its parameters
using EnergyFunction = EnergyAt (*)(double strain, const Eigen::VectorXd& values);

/// Elasticity of one strain by an energy that is known in closed form.
class ClosedFormDensity : public ParametricDensity {
 public:
  /// @param component  the strain that it acts on
  /// @param linear     whether the energy is in its values
  ClosedFormDensity(int component, EnergyFunction energy, Eigen::VectorXd values,
                    bool linear = false);

  int history_size() const override { return 0; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void advance(const Samples&, const StepTime&, MutableLaneView, Lane&) const override {}
  Eigen::VectorXd parameters() const override { return values_; }
  bool is_linear() const override { return linear_; }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  int component_;
  EnergyFunction energy_;
  Eigen::VectorXd values_;
  bool linear_;
};

}  // namespace pliant
