#pragma once

#include "pliant/experiment/session/sheet_predictor.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// The frames of a session as one quasi-static path of a material with internal friction, from the
/// flat sheet at rest on.
///
/// The search for each equilibrium begins where the parameters before have ended, moved along the
/// derivatives there, and at the frame before where that fails.
class SheetPath : public SheetPredictor {
 public:
  /// @param session   with clips, without a table, on the mesh that is simulated; outlives this
  /// @param material  complete
  SheetPath(const Session& session, const Material& material);

  std::vector<std::optional<SheetShape>> predict_each(const Eigen::VectorXd& parameters,
                                                      const std::vector<int>& by, int threads,
                                                      const StopToken& stop) override;
  void begin_at(std::vector<Eigen::Matrix3Xd> guesses) override { guesses_ = std::move(guesses); }
  std::vector<Eigen::Matrix3Xd> guesses() const override;

 private:
  /// The shapes of all frames at some parameters.
  struct Found {
    Eigen::VectorXd parameters;
    std::vector<int> by;
    std::vector<SheetShape> shapes;  // none: not found yet
  };

  Eigen::Matrix3Xd guess(int frame, const Eigen::VectorXd& parameters) const;

  const Session& session_;
  const SheetSystem sheet_;
  Found last_;
  std::vector<Eigen::Matrix3Xd> guesses_;  // one a frame, or none at all
};

}  // namespace pliant
