#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/progress.h"
#include "pliant/experiment/session/equilibrium_work.h"

namespace pliant {

/// The rows of a frame as they are predicted.
struct PredictedFrame {
  Eigen::VectorXd value;             ///< SI
  Eigen::MatrixXd by;                ///< rows x chosen parameters
  Eigen::VectorXd length_gain = {};  ///< |d value / d length|, for noise of the length (m); may be
                                     ///< empty
};

/// Takes what is predicted, frame after frame: keeps it, or adds it up.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void take(int frame, const PredictedFrame& rows) = 0;
};

/// How a prediction may work: on how many threads, on which nothing of it depends, and until when.
struct Workers {
  int threads = 1;
  StopToken stop = {};
};

/// Predicts the rows of an experiment with a material whose numbers change, for estimation.
class Predictor {
 public:
  virtual ~Predictor() = default;

  /// What a prediction depends on: numbers of the material, then the experiment's own.
  const std::vector<std::string>& parameters() const { return parameters_; }
  /// Those of the material that it was made with, and where the experiment's own begin.
  const Eigen::VectorXd& values() const { return values_; }

  /// Predicts all frames.
  /// @param values  one for each of `parameters()`
  /// @param by      places of the parameters that derivatives are wanted by; empty: none are
  /// @return false where the material cannot carry the loads (no equilibrium); the sink has then
  ///         seen some frames or none
  virtual bool predict(const Eigen::VectorXd& values, const std::vector<int>& by,
                       const Workers& workers, FrameSink& rows) = 0;

  /// The equilibria that were found last, for the searches of another predictor of the same
  /// experiment to begin at; none where nothing is searched for.
  virtual std::vector<Eigen::Matrix3Xd> guesses() const { return {}; }
  virtual void begin_at(std::vector<Eigen::Matrix3Xd> guesses) { static_cast<void>(guesses); }

  /// Strains of a component in all elements and frames, as far as the experiment is about it: the
  /// range over which it tells the law. Empty where nothing is found.
  virtual std::vector<double> strains(const std::string& component, const Eigen::VectorXd& values,
                                      const Workers& workers) = 0;

  /// Frames that have no equilibrium at some values, while others may have one.
  virtual std::vector<int> lost_frames(const Eigen::VectorXd& values, const Workers& workers) = 0;

  /// What all predictions until now have cost.
  virtual EquilibriumWork work() const { return {}; }

 protected:
  std::vector<std::string> parameters_;
  Eigen::VectorXd values_;
};

}  // namespace pliant
