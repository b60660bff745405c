#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "pliant/experiment/experiment.h"
#include "pliant/experiment/profile/strip_shapes.h"
#include "pliant/material/component_law.h"

namespace pliant {

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
  std::vector<double> time;    ///< s; empty unless measured
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

/// A measurement on one strain component, whose path of strain is known row by row.
class ComponentExperiment : public Experiment {
 public:
  const MeasuredPath& path() const { return path_; }

  /// Runs of rows that the path goes from one turning point.
  std::vector<Frame> frames() const override;
  /// One of each specimen.
  std::vector<std::vector<int>> series() const override;
  double reference() const override;
  std::unique_ptr<Predictor> predictor(const Material& material) const override;
  /// The same for a law of its component, in a form that materials need not have.
  std::unique_ptr<Predictor> predictor(const ComponentLaw& law) const;

  /// How many threads a prediction may use; its results do not depend on it.
  void set_threads(int threads) { threads_ = threads; }

  /// The same test with the length of its specimens estimated along; nothing where none is stated,
  /// or where it is estimated already.
  virtual std::unique_ptr<ComponentExperiment> with_free_length() const { return nullptr; }

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

  /// Largest force that the material carries (N, or N/m for forces per width).
  virtual double peak_force() const;

  /// The loop of a series of the measured quantity (SI), measured or predicted; nothing where a
  /// laboratory reads no figures off one.
  virtual std::optional<LoopSeries> loop(const Eigen::VectorXd& quantity) const {
    static_cast<void>(quantity);
    return std::nullopt;
  }

  /// What a material without any stiffness would show, nuisance parameters at their best: what a
  /// prediction has to beat. Nothing where such a specimen carries no load, or stays in no place.
  virtual std::optional<Eigen::VectorXd> limp() const { return std::nullopt; }

  /// The same test with the rows alone that a search is best begun with; the others, of which one
  /// that starts at a wrong law leads nowhere, take no part and are predicted as zero. Nothing
  /// where all rows are alike.
  virtual std::unique_ptr<ComponentExperiment> easy_part() const { return nullptr; }

  /// What the instrument shows of each row where the material carries nothing: no part of a loop.
  virtual Eigen::VectorXd instrument_zero(const Eigen::VectorXd& nuisance) const {
    static_cast<void>(nuisance);
    return Eigen::VectorXd::Zero(rows());
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
  /// When a row was measured (s); without times, when all is at rest.
  double time_at(int row) const;
  /// The times of a specimen's rows; empty where there are none.
  std::span<const double> times_of(const SpecimenRows& rows) const;

  MeasuredPath path_;
  int threads_ = 1;
};

/// A test that may be on the specimens of an earlier one.
class FollowingExperiment {
 public:
  virtual ~FollowingExperiment() = default;

  /// Takes it that these specimens came from an earlier test and start as it has left them.
  /// @param earlier  of the same type and component
  /// @param where    the study says so, for messages
  /// @throws InputError where its specimens are others
  virtual void follow(const ComponentExperiment& earlier, const Location& where) = 0;
};

}  // namespace pliant
