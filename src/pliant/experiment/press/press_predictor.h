#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/experiment/press/press.h"
#include "pliant/experiment/press/press_path.h"

namespace pliant {

/// Predicts a pressed body with a solid whose numbers change.
class PressPredictor : public Predictor {
 public:
  /// @param experiment  outlives it
  PressPredictor(const PressTest& experiment, const Material& material);

  bool predict(const Eigen::VectorXd& values, const std::vector<int>& by, const Workers& workers,
               FrameSink& rows) override;
  /// Of any metric of the strain, whether the material has it or not, in all elements.
  std::vector<double> strains(const std::string& component, const Eigen::VectorXd& values,
                              const Workers& workers) override;
  std::vector<int> lost_frames(const Eigen::VectorXd& values, const Workers& workers) override;

 private:
  /// Goes through the rows until one is not found.
  /// @return whether all were
  template <class Take>
  bool walk(const Eigen::VectorXd& values, const std::vector<int>& by, const Workers& workers,
            const Take& take) const;

  const PressTest& experiment_;
  PressedBody body_;
};

}  // namespace pliant
