#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/experiment/session/sheet_bending.h"
#include "pliant/experiment/session/sheet_predictor.h"
#include "pliant/experiment/session/sheet_test.h"

namespace pliant {

/// Predicts what is compared of a session: the sheet in each frame, and the drag of its cords. A
/// material whose bending is that of a sheet is turned into hinges of the session's mesh at each
/// prediction, with derivatives.
class SessionPredictor : public Predictor {
 public:
  /// @param test      outlives the predictor
  /// @param material  complete
  SessionPredictor(const SheetTest& test, const Material& material);

  bool predict(const Eigen::VectorXd& values, const std::vector<int>& by, const Workers& workers,
               FrameSink& rows) override;
  std::vector<double> strains(const std::string& component, const Eigen::VectorXd& values,
                              const Workers& workers) override;
  std::vector<int> lost_frames(const Eigen::VectorXd& values, const Workers& workers) override;

  std::vector<Eigen::Matrix3Xd> guesses() const override { return sheets_->guesses(); }
  void begin_at(std::vector<Eigen::Matrix3Xd> guesses) override {
    sheets_->begin_at(std::move(guesses));
  }
  EquilibriumWork work() const override { return sheets_->work(); }

 private:
  int of_material(const Eigen::VectorXd& values) const;
  /// The numbers of the material that is simulated, at those of a prediction.
  Eigen::VectorXd simulated(const Eigen::VectorXd& values) const;
  bool usually_strains(const std::string& component) const;

  const SheetTest& test_;
  Material material_;  // that is simulated
  std::unique_ptr<SheetPredictor> sheets_;
  std::optional<SheetBending> bending_;  // none where the material has hinges or springs already
};

}  // namespace pliant
