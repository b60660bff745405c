#pragma once

#include <memory>
#include <vector>

#include "pliant/material/density/density.h"

namespace pliant {

/// The sum of densities: energies, stresses and tangents add up; histories and parameters stand one
/// after the other.
///
/// Addends without parameters (damping, linearised friction) have no part in `differentiate`.
class Sum : public ParametricDensity {
 public:
  void add_addend(std::shared_ptr<const Density> addend);
  bool is_empty() const { return addends_.empty(); }

  int history_size() const override { return history_size_; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  bool is_limited() const override;
  void lower_to_share_left(const Samples& samples, Lane& left) const override;
  void add_stored(const Samples& samples, Lane& stored) const override;
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;
  Eigen::VectorXd parameters() const override;
  bool is_linear() const override;
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override;
  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override;

 private:
  struct Addend {
    std::shared_ptr<const Density> density;
    const ParametricDensity* parametric = nullptr;  // the same, where it has parameters
    int first_history = 0;
    int history_size = 0;
    int first_parameter = 0;
    int parameter_count = 0;
  };

  static Samples own(const Addend& addend, const Samples& samples) {
    return samples.with_history(addend.first_history, addend.history_size);
  }

  std::vector<Addend> addends_;
  int history_size_ = 0;
  int parameter_count_ = 0;
};

}  // namespace pliant
