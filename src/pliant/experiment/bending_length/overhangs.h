#pragma once

#include "pliant/experiment/bending_length/overhang_rows.h"
#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// Strips pushed out over an edge, flat, until the line to their tip dips by an angle: bending
/// length (ASTM D1388 option A, ISO 9073-7, [Peirce1930]). The overhang is measured.
///
/// With the face up a strip bends to the right of its way out (negative curvature), turned over to
/// the left; a law that is the same on both sides predicts one overhang.
class Overhangs : public ComponentExperiment {
 public:
  /// @throws InputError without a density, and for unusable data
  Overhangs(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth);
  /// Faces without measured overhangs.
  /// @param elements  of the strips' lines
  Overhangs(OverhangRows rows, double angle, double density, int elements);

  std::optional<Prediction> predict(const ComponentLaw& law, const Eigen::VectorXd& nuisance,
                                    bool with_jacobian) const override;
  Eigen::VectorXd unfitted_nuisance(const ComponentLaw&) const override { return {}; }
  /// The mean overhang.
  double reference() const override { return measured_.mean(); }

 private:
  void read_path(const DataRows& data, const ExperimentSpec& spec);

  OverhangRows readings_;
  double weight_ = 0;  // N/m^2
  double angle_ = 0;   // rad
  int elements_ = DipOptions().elements;
};

}  // namespace pliant
