#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "pliant/experiment/press/press.h"
#include "pliant/experiment/press/press_path.h"

namespace pliant {

/// Predicts a pressed body with a solid whose numbers change.
///
/// Rows of a law that remembers nothing are equilibria each for itself: searches begin where the
/// same rows stood with the nearest of the last few numbers, moved along the derivatives there; a
/// row that is not found so is reached from the one before it, and all from rest where that fails
/// too.
class PressPredictor : public Predictor {
 public:
  /// @param experiment  outlives it
  PressPredictor(const PressTest& experiment, const Material& material);

  bool predict(const Eigen::VectorXd& values, const std::vector<int>& by, const Workers& workers,
               FrameSink& frames) override;
  /// Of any metric of the strain, whether the material has it or not, at all points of elements; of
  /// J that of nodes and hexahedra.
  std::vector<double> strains(const std::string& component, const Eigen::VectorXd& values,
                              const Workers& workers) override;
  std::vector<int> lost_frames(const Eigen::VectorXd& values, const Workers& workers) override;
  EquilibriumWork work() const override { return work_; }

 private:
  using Rows = std::vector<PressStand>;
  /// All rows at some numbers.
  struct Solved {
    Eigen::VectorXd values;
    std::vector<int> by;
    Rows rows;
  };
  /// What rows depend on.
  struct Asked {
    const Eigen::VectorXd& values;
    const std::vector<int>& by;
    const Workers& workers;
  };

  BodyPathOptions options(const Asked& asked) const {
    return {body_.system().with(asked.values), asked.by, asked.workers.stop};
  }
  bool go_to(int row, PressPath& path) const;
  void add_cost(const PressPath& path) const;
  /// From rest until a row is not found.
  Rows walked(const Asked& asked) const;
  const Solved& nearest(const Asked& asked) const;
  std::optional<PressStand> settled(int row, const Solved& from, const Asked& asked) const;
  std::optional<PressStand> from_row_before(int row, const Rows& rows, const Asked& asked) const;
  std::optional<Rows> settled(const Asked& asked) const;
  /// All of them, or as many as a walk finds.
  const Rows& rows(const Asked& asked);
  bool are_all(const Rows& rows) const { return std::ssize(rows) == experiment_.rows(); }

  const PressTest& experiment_;
  PressedBody body_;
  Workspace workspace_;
  Rows found_;                 // the last time, not all
  std::deque<Solved> solved_;  // newest first
  mutable std::mutex adding_;
  mutable EquilibriumWork work_;
};

}  // namespace pliant
