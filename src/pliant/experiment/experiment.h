#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/experiment/experiment_info.h"
#include "pliant/experiment/predictor.h"
#include "pliant/material/material.h"

namespace pliant {

/// As good as no bound.
inline constexpr double kNoBound = 1e12;

/// What is known of a number before anything is measured.
struct GaussianPrior {
  double mean = 0;
  double sd = 0;
};

/// A number that belongs to the apparatus or the specimen, not to the material; it is estimated
/// along.
struct NuisanceParameter {
  std::string name;  ///< e.g. "warp-8cm.force_offset"
  std::string unit;
  double start = 0;
  double lower = 0;
  double upper = 0;
  double scale = 1;          ///< a change that matters
  bool of_friction = false;  ///< means nothing for a law without friction
  std::optional<GaussianPrior> prior = {};
  std::string together = {};  ///< numbers of one such name are nearly alike: the cords of a clip
};

/// Rows that are measured together and tell together: a half cycle, a profile, a frame of a
/// session.
struct Frame {
  int first = 0;  ///< row
  int count = 0;
  int specimen = 0;
};

/// Names and first values of some nuisance parameters behind those of a material.
void append_nuisance(const std::vector<NuisanceParameter>& own,
                     std::vector<std::string>& parameters, Eigen::VectorXd& values);

/// A measurement in memory, with what predicts it: the same object predicts, is compared and is
/// differentiated. A fit knows experiments by this alone.
class Experiment {
 public:
  virtual ~Experiment() = default;

  const ExperimentInfo& info() const { return info_; }
  const Eigen::VectorXd& measured() const { return measured_; }
  int rows() const { return static_cast<int>(measured_.size()); }
  /// In the order of the rows, which they cover.
  virtual std::vector<Frame> frames() const = 0;
  const std::vector<NuisanceParameter>& nuisance() const { return nuisance_; }

  /// Rows of one channel in the order in which it was measured, whose errors may go together.
  virtual std::vector<std::vector<int>> series() const = 0;
  /// What an error is compared with (SI), > 0: the largest force, or the largest change of length.
  virtual double reference() const = 0;
  /// A stress of the size that the data show (Pa), for experiments of solids.
  virtual double stress() const { return reference(); }
  /// What was imposed, row by row, as shares of the specimen's size; empty where strains of the
  /// material tell it.
  virtual std::vector<double> imposed() const { return {}; }

  /// What each row counts in a fit: 1, or 0 where it is left out.
  virtual Eigen::ArrayXd weights() const;

  /// How far a prediction is off, in sentences, where rows are of different kinds.
  virtual std::vector<std::string> differences(const Eigen::VectorXd& predicted) const {
    static_cast<void>(predicted);
    return {};
  }

  /// Predicts with materials of one form.
  /// @param material  whose laws keep their form while their numbers change; it has all components
  ///                  that the experiment asks for
  virtual std::unique_ptr<Predictor> predictor(const Material& material) const = 0;

 protected:
  ExperimentInfo info_;
  Eigen::VectorXd measured_;
  std::vector<NuisanceParameter> nuisance_;
};

}  // namespace pliant
