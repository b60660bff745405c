#pragma once

#include "pliant/material/density/density.h"

namespace pliant {

/// Elasticity of one strain component that strain takes away for good (Mullins' effect): of a
/// bundle of links, each of which breaks at a strain of its own, those are left that the largest
/// strain so far, m, has not reached,
///
///     stress = k strain exp(-m / breaking),
///
/// breaking being their mean. At strains below m it is linear and gives back what it took; where m
/// grows, the energy of the links that break is lost: an incremental potential of the new strain.
///
/// History: m, the largest absolute strain.
class SofteningDensity : public ParametricDensity {
 public:
  /// @param component  the strain that it acts on
  /// @param stiffness  k, of all links (N/m for membranes, N m for bending), >= 0
  /// @param breaking   mean strain at which a link breaks, > 0
  SofteningDensity(int component, double stiffness, double breaking);

  int history_size() const override { return 1; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  /// (stiffness, breaking).
  Eigen::VectorXd parameters() const override { return Eigen::Vector2d(stiffness_, breaking_); }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  Lane largest(const Samples& samples) const;
  Lane lost(const Lane& from, const Lane& to) const;

  int component_;
  double stiffness_, breaking_;
};

}  // namespace pliant
