#pragma once

#include <array>
#include <vector>

#include "pliant/material/density/density.h"
#include "pliant/math/scalar_curve.h"

namespace pliant {

/// Elasticity of one strain component by a stiffness curve ([T] 3.3.2): stress k(strain) strain,
/// energy by exact integration. The tangent k + k' strain may be negative, but not of a spline
/// whose control values are not.
class StiffnessDensity : public ParametricDensity {
 public:
  /// @param component  the strain that it acts on
  StiffnessDensity(int component, ScalarCurve stiffness);

  int history_size() const override { return 0; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  Eigen::VectorXd parameters() const override;
  bool is_linear() const override { return true; }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  // A cubic from one strain on: sum of coefficients times powers of the way. Of a hermite curve it
  // is the stiffness; of an energy the stress, without the cubic term.
  struct Piece {
    double from = 0;
    std::array<double, 4> coefficients{};
    double energy = 0;  // at `from` (J/m^2)
  };
  // The pieces that eight strains lie in.
  struct LanePieces {
    Lane way, from, c0, c1, c2, c3, energy, sign;
  };

  void cut_into_pieces();
  void cut_energy();
  LanePieces pieces_at(const Lane& strain) const;
  void add_hermite(const Samples& samples, Response& response) const;
  void add_energy(const Samples& samples, Response& response) const;

  int component_;
  ScalarCurve stiffness_;
  std::vector<Piece> pieces_;  // of a curve with knots; the first goes on below where it starts
};

}  // namespace pliant
