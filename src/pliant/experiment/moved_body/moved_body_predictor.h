#pragma once

#include <string>
#include <vector>

#include "pliant/experiment/moved_body/moved_body.h"
#include "pliant/experiment/moved_body/moved_body_path.h"

namespace pliant {

/// Predicts a moved body with a solid whose numbers change. Where the law remembers nothing, each
/// equilibrium is looked for from where the last numbers had it.
class MovedBodyPredictor : public Predictor {
 public:
  /// @param experiment  outlives it
  MovedBodyPredictor(const MovedBodyTest& experiment, const Material& material);

  bool predict(const Eigen::VectorXd& values, const std::vector<int>& by, const Workers& workers,
               FrameSink& rows) override;
  std::vector<Eigen::Matrix3Xd> guesses() const override { return found_; }
  void begin_at(std::vector<Eigen::Matrix3Xd> guesses) override { found_ = std::move(guesses); }
  /// Of any metric of the strain, whether the material has it or not, in all elements.
  std::vector<double> strains(const std::string& component, const Eigen::VectorXd& values,
                              const Workers& workers) override;
  std::vector<int> lost_frames(const Eigen::VectorXd& values, const Workers& workers) override;

 private:
  /// Goes through the frames until one is not found.
  /// @return whether all were
  template <class Take>
  bool walk(const Eigen::VectorXd& values, const std::vector<int>& by, const Workers& workers,
            const Take& take);
  PredictedFrame rows_of(const Frame& frame, const BodyPoint& point, std::size_t by) const;

  const MovedBodyTest& experiment_;
  HeldBody body_;
  bool remembers_;
  std::vector<Eigen::Matrix3Xd> found_;  // equilibria of the frames; empty before the first
};

}  // namespace pliant
