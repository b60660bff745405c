#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/experiment/experiment_role.h"
#include "pliant/experiment/profile/strip_shapes.h"
#include "pliant/experiment/test_facts.h"
#include "pliant/material/component_law.h"
#include "pliant/measurement/data_source.h"

namespace pliant {

/// What an experiment measures row by row, and how results print it.
struct MeasuredQuantity {
  std::string name;   ///< column suffix: measured_NAME, e.g. force_N
  std::string kind;   ///< force, length, ...
  std::string unit;   ///< unit of the column
  double per_si = 1;  ///< column value = per_si * SI value
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
};

/// Predicted values of the measured quantity, one per row.
struct Prediction {
  Eigen::VectorXd value;     ///< SI
  Eigen::MatrixXd jacobian;  ///< d value / d (law, nuisance); empty unless asked for
  Eigen::VectorXd strain;    ///< strain of the material at each row
  Eigen::VectorXd
      length_gain;  ///< |d value / d length|, for noise of the length (m); empty if none
};

/// The measured path, for estimators and figures that look at it row by row.
struct MeasuredPath {
  std::vector<double> strain;  ///< by the stated gauge length
  std::vector<double> force;   ///< force (N) or force per width (N/m) that the material carries
  std::vector<double> factor;  ///< force per stress at the row's strain (m, or 1)
  std::vector<int> direction;  ///< 1 loading, -1 unloading
  std::vector<int> anchor;     ///< row of the turning point before; the row itself at the start
  std::vector<int> specimen;   ///< 0, 1, ...
  /// Rows where the path begins anew: from zero strain, free of friction, it comes to the row's
  /// strain and turns. Empty: there are none.
  std::vector<char> starts_flat;
  /// Rows that the published estimator samples. Empty: all of them.
  std::vector<char> published_samples;
};

/// An abscissa and an ordinate a row: the loop as the field draws it (force over length).
struct LoopSeries {
  Eigen::VectorXd abscissa;
  Eigen::VectorXd ordinate;
  double width = 1;   ///< across the force (m), for moduli per width; 1 for forces per width
  double length = 1;  ///< gauge length (m) that makes the abscissa an engineering strain; 1 where
                      ///< it is a strain already
};

/// Facts of an experiment that hold whatever the law.
struct ExperimentInfo {
  std::string name;
  std::string type;
  TestFacts test;  ///< what holds of all of its type
  std::string direction;
  std::string component;  ///< strain component that it determines, e.g. stretch.warp
  ExperimentRole role = ExperimentRole::fit;
  MeasuredQuantity quantity;
  std::vector<std::string> specimens;
  std::vector<char> used;              ///< a row: does it take part in the fit
  std::optional<double> force_noise;   ///< stated standard deviation of the force (N or N/m)
  std::optional<double> length_noise;  ///< of the length (m)
  std::vector<std::string> handled;    ///< what was found in the data and how it was dealt with
  std::vector<std::string> warnings;
  std::vector<OwnColumn> columns;
  std::vector<double> time;  ///< s; empty unless measured
};

/// A measurement on one strain component: it predicts, is compared and is differentiated by the
/// same object.
class Experiment {
 public:
  virtual ~Experiment() = default;

  const ExperimentInfo& info() const { return info_; }
  const Eigen::VectorXd& measured() const { return measured_; }
  int rows() const { return static_cast<int>(measured_.size()); }
  const std::vector<NuisanceParameter>& nuisance() const { return nuisance_; }
  const MeasuredPath& path() const { return path_; }

  /// How many threads a prediction may use; its results do not depend on it.
  void set_threads(int threads) { threads_ = threads; }

  /// Predicts the measured quantity of all rows.
  /// @param nuisance  one value for each of `nuisance()`
  /// @return nothing when the law cannot carry the loads (no equilibrium)
  virtual std::optional<Prediction> predict(const ComponentLaw& law,
                                            const Eigen::VectorXd& nuisance,
                                            bool with_jacobian) const = 0;

  /// Nuisance values for a prediction without a fit: what the data itself shows, else the ideal
  /// apparatus.
  /// @param law  that will be predicted with: what no apparatus knows is read off beside it
  virtual Eigen::VectorXd unfitted_nuisance(const ComponentLaw& law) const = 0;

  /// What an error is compared with (SI): the largest force, or the largest change of length.
  virtual double reference() const;

  /// Largest force that the material carries (N, or N/m for forces per width).
  virtual double peak_force() const;

  /// The loop of a series of the measured quantity (SI), measured or predicted; nothing where a
  /// laboratory reads no figures off one.
  virtual std::optional<LoopSeries> loop(const Eigen::VectorXd& quantity) const {
    static_cast<void>(quantity);
    return std::nullopt;
  }

  /// Profiles measured, and predicted with a law that carries the loads; nothing where the test
  /// measures none.
  virtual std::optional<StripShapes> shapes(const ComponentLaw& law,
                                            const Eigen::VectorXd& nuisance) const {
    static_cast<void>(law);
    static_cast<void>(nuisance);
    return std::nullopt;
  }

 protected:
  ExperimentInfo info_;
  Eigen::VectorXd measured_;
  std::vector<NuisanceParameter> nuisance_;
  MeasuredPath path_;
  int threads_ = 1;
};

}  // namespace pliant
