#pragma once

#include "pliant/experiment/data_source.h"
#include "pliant/experiment/experiment.h"
#include "pliant/experiment/turning_points.h"
#include "pliant/solver/elastica/elastica.h"

namespace pliant {

/// A strip clamped flat at both ends, whose clamps come nearer and go back: it buckles against or
/// with its weight, and the force on a clamp is measured (tension is positive).
///
/// Forces are a few millinewtons and the strip's length between the clamps is not known to the
/// tenths of a millimetre that decide its sag: offset and drift of the force and that length are
/// estimated along.
class BucklingBend : public Experiment {
 public:
  /// Which way the strip buckles: along gravity or against it.
  enum class Side { down, up };

  /// @param density  kg/m^2, > 0
  BucklingBend(const ExperimentSpec& spec, double density, Side side);

  std::optional<Prediction> predict(const ComponentLaw& law, const Eigen::VectorXd& nuisance,
                                    bool with_jacobian) const override;
  Eigen::VectorXd unfitted_nuisance() const override;
  LoopSeries loop(const Eigen::VectorXd& force) const override;
  double loop_width() const override { return width_; }
  double loop_length() const override { return 1; }

 private:
  struct Specimen {
    SpecimenRows rows;
    std::vector<Stretch> stretches;
    int first_nuisance = 0;
  };

  void add_specimen(const SpecimenRows& rows);
  void read_path(const Specimen& specimen, int number);
  bool predict_specimen(const Specimen& specimen, const ComponentLaw& law,
                        const Eigen::VectorXd& nuisance, bool with_jacobian,
                        Prediction& prediction) const;
  /// Force per width along the way (N/m), and its derivatives by the law where asked for.
  bool follow(const Specimen& specimen, const ComponentLaw& law, double length, bool with_jacobian,
              Eigen::VectorXd& force, Eigen::VectorXd& strain, Eigen::MatrixXd& by_law) const;

  double weight_ = 0;  // N/m^2
  double width_ = 0;
  double sign_ = -1;              // of the strip's rise
  std::vector<double> distance_;  // m
  std::vector<Specimen> specimens_;
};

}  // namespace pliant
