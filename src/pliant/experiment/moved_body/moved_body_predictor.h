#pragma once

#include <string>
#include <vector>

#include "pliant/experiment/experiment.h"
#include "pliant/experiment/moved_body/body_observable.h"
#include "pliant/experiment/moved_body/moved_body_path.h"

namespace pliant {

/// Predicts a moved body with a solid whose numbers change. Where the law remembers nothing, each
/// equilibrium is looked for from where the last numbers had it.
class MovedBodyPredictor : public Predictor {
 public:
  /// What is measured, and when. The observable outlives it.
  struct Schedule {
    std::vector<Frame> frames;
    std::vector<Eigen::Vector3d> shifts;  ///< of what is moved, one a frame (m)
    const BodyObservable& observable;
  };

  /// @param setup  outlives it
  MovedBodyPredictor(const BodySetup& setup, Schedule schedule, const Material& material);

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

  Schedule schedule_;
  HeldBody body_;
  bool remembers_;
  std::vector<Eigen::Matrix3Xd> found_;  // equilibria of the frames; empty before the first
};

}  // namespace pliant
