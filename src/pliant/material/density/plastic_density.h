#pragma once

#include <limits>

#include "pliant/material/density/density.h"

namespace pliant {

/// An elastic range that moves with the strain where that leaves it: the elastic strain, total less
/// plastic, is bounded ([Bergou2007], [T] Fig. 2.2 right), and with it the stress.
struct PlasticParameters {
  double stiffness = 0;  ///< k, of the elastic strain (N/m for membranes, N m for bending), > 0
  double yield = 0;      ///< largest elastic strain while plastic strain may grow, > 0
  /// Largest plastic strain: beyond it all is elastic again ([T] Fig. 2.2 centre, without the time
  /// that the creep of [MuellerGross2004] takes).
  double saturation = std::numeric_limits<double>::infinity();

  /// @param values  stiffness, yield and, where there is one, saturation
  static PlasticParameters of(const Eigen::VectorXd& values);
};

/// Rate-independent plasticity of one strain component, stress k (strain - p), as an incremental
/// potential of the new strain.
///
/// The plastic strain p that a step leaves is that of least energy and dissipation,
///
///     W(strain) = min over |p| <= saturation of  k (strain - p)^2 / 2 + k yield |p - p0|,
///
/// p0 the one that it began with: p0 brought to between strain - yield and strain + yield, and then
/// to within the saturation. W is convex and has the derivative k (strain - p), so that no return
/// to a yield surface is iterated. Its second derivative is 0 where p moves and k elsewhere; where
/// p is about to move, as at the end of the last step, it is the larger of the two.
///
/// Hardening is the business of the laws beside it: with a stiffness h in parallel yield moves by h
/// per strain (linear kinematic hardening, [SimoHughes1998] chapter 1).
///
/// History: the plastic strain.
class PlasticDensity : public ParametricDensity {
 public:
  /// @param component  the strain that it acts on
  PlasticDensity(int component, const PlasticParameters& plastic);

  int history_size() const override { return 1; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void add_stored(const Samples& samples, Lane& stored) const override;
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  /// (stiffness, yield), and the saturation where there is one.
  Eigen::VectorXd parameters() const override;
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  Lane plastic_strain(const Samples& samples) const;
  Lane dissipation(const Lane& from, const Lane& to) const;

  int component_;
  PlasticParameters plastic_;
};

}  // namespace pliant
