#pragma once

#include <array>
#include <vector>

#include "pliant/material/density/density.h"
#include "pliant/math/scalar_curve.h"

namespace pliant {

/// Elasticity of one strain component by a stiffness curve ([T] 3.3.2): stress k(strain) strain,
/// energy by exact integration. The tangent k + k' strain may be negative.
class StiffnessDensity : public ParametricDensity {
 public:
  /// @param component  the strain that it acts on
  StiffnessDensity(int component, ScalarCurve stiffness);

  int history_size() const override { return 0; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  Eigen::VectorXd parameters() const override;
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, int lane, int first_history, int first_parameter,
                     SampleDerivatives& derivatives) const override;

 private:
  // A cubic of the stiffness from one strain on: sum of coefficients times powers of the way.
  struct Piece {
    double from = 0;
    std::array<double, 4> coefficients{};
    double energy = 0;  // at `from` (J/m^2)
  };

  void cut_into_pieces();
  void add_hermite(const Samples& samples, Response& response) const;

  int component_;
  ScalarCurve stiffness_;
  std::vector<Piece> pieces_;  // of a hermite curve; the first goes on below where it starts
};

}  // namespace pliant
