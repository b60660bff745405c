#pragma once

#include "pliant/experiment/data_source.h"
#include "pliant/experiment/experiment.h"
#include "pliant/experiment/turning_points.h"

namespace pliant {

/// Shear of a sheet to and fro by an imposed angle, shear force per width measured (KES-FB1).
///
/// Yarns keep their length, so that the strain w_u . w_v is sin(angle); the clamps come nearer, and
/// the transverse tension T of the instrument does work on it: force per width = stress + T
/// tan(angle).
class ShearCycles : public Experiment {
 public:
  explicit ShearCycles(const ExperimentSpec& spec);

  std::optional<Prediction> predict(const ComponentLaw& law, const Eigen::VectorXd& nuisance,
                                    bool with_jacobian) const override;
  Eigen::VectorXd unfitted_nuisance() const override;
  LoopSeries loop(const Eigen::VectorXd& force) const override;
  double loop_width() const override { return 1; }
  double loop_length() const override { return 1; }

 private:
  struct Specimen {
    SpecimenRows rows;
    std::vector<Stretch> stretches;
    int first_nuisance = 0;
    bool rested = true;
  };

  void add_specimen(const SpecimenRows& rows, const ExperimentSpec& spec);
  void describe(const ExperimentSpec& spec);
  void predict_specimen(const Specimen& specimen, const ComponentLaw& law,
                        const Eigen::VectorXd& nuisance, bool with_jacobian,
                        Prediction& prediction) const;

  std::vector<double> angle_;  // rad
  std::vector<double> strain_;
  double transverse_tension_ = 0;
  std::vector<Specimen> specimens_;
};

}  // namespace pliant
