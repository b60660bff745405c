#pragma once

#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/experiment_spec.h"
#include "pliant/measurement/data_source.h"
#include "pliant/measurement/turning_points.h"

namespace pliant {

/// A strip clamped flat at both ends, whose clamps come nearer and go back: it buckles along
/// gravity or against it, and the force on a clamp is measured (tension is positive).
///
/// Forces are a few millinewtons: their offset and an even drift of it are estimated along, and the
/// strip's length where the study does not know it.
class BucklingBend : public ComponentExperiment {
 public:
  /// @param density  kg/m^2
  /// @throws InputError where there is no density, or the data are not those of a buckled strip
  BucklingBend(const ExperimentSpec& spec, const DataRows& data, double density);

  std::optional<Prediction> predict(const ComponentLaw& law, const Eigen::VectorXd& nuisance,
                                    bool with_jacobian) const override;
  /// The strip is as long as stated; offset and drift of the force are those that fit best.
  Eigen::VectorXd unfitted_nuisance(const ComponentLaw& law) const override;
  /// The span of the force: its zero is not known.
  double reference() const override;
  double peak_force() const override { return reference(); }

 private:
  struct Specimen {
    SpecimenRows rows;
    std::vector<Stretch> stretches;  ///< of the distance
    int first_nuisance = 0;
    bool length_is_known = true;
  };
  struct Followed;

  void add_specimen(const SpecimenRows& rows, const ExperimentSpec& spec);
  void add_nuisance(size_t number, const SpecimenRows& rows, RestLength rest_length);
  void read_path(const Specimen& specimen, int number);
  std::optional<Followed> follow(const Specimen& specimen, const ComponentLaw& law, double length,
                                 bool with_derivatives) const;
  bool predict_specimen(const Specimen& specimen, const ComponentLaw& law,
                        const Eigen::VectorXd& nuisance, bool with_jacobian,
                        Prediction& prediction) const;

  double weight_ = 0;  // N/m^2
  double length_ = 0;
  double width_ = 0;
  BucklingSide side_ = BucklingSide::down;
  std::vector<double> distance_;  // m
  std::vector<Specimen> specimens_;
};

}  // namespace pliant
