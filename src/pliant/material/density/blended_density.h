#pragma once

#include <memory>
#include <vector>

#include "pliant/material/density/density.h"

namespace pliant {

/// The law of a heterogeneous material: at each point the laws of its samples, each times its
/// weight there ([T] Eq. 4.4); the weights come with the points (`Samples::weights`).
///
/// Laws that are linear in their numbers and alike in all else are one law of blended numbers: an
/// answer for each number, and not for each sample. Parameters are those of the samples, one after
/// the other.
class BlendedDensity : public ParametricDensity {
 public:
  using Laws = std::vector<std::shared_ptr<const ParametricDensity>>;

  /// @param laws   of the samples; they remember nothing
  /// @param alike  whether they differ in their numbers alone
  BlendedDensity(Laws laws, bool alike);

  int history_size() const override { return 0; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void advance(const Samples&, const StepTime&, MutableLaneView, Lane&) const override {}
  Eigen::VectorXd parameters() const override;
  bool is_linear() const override { return linear_; }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  Laws laws_;
  std::vector<Eigen::Index> first_{0};  // number of each sample, and of all at the end
  bool alike_;
  bool linear_;
  Laws units_;              // linear: with one number 1 and the others 0
  Eigen::MatrixXd values_;  // linear: samples x numbers
};

}  // namespace pliant
