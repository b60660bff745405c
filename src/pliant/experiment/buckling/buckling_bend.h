#pragma once

#include "pliant/experiment/buckling/buckling_side.h"
#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/sampled_path.h"
#include "pliant/experiment/specimen_fields.h"
#include "pliant/experiment/test_type.h"
#include "pliant/measurement/data_source.h"
#include "pliant/measurement/turning_points.h"

namespace pliant {

/// A strip, and how finely it is computed.
struct BucklingStrip {
  double length = 0;   ///< between its clamps (m)
  double width = 0;    ///< m
  double density = 0;  ///< kg/m^2
  BucklingSide side = BucklingSide::down;
  int elements = 2;  ///< of half a strip
};

/// A strip clamped flat at both ends, whose clamps come nearer and go back: it buckles along
/// gravity or against it, and the force on a clamp is measured (tension is positive).
///
/// Forces are a few millinewtons: their offset and an even drift of it are estimated along, and the
/// strip's length where the study does not know it.
class BucklingBend : public ComponentExperiment {
 public:
  /// @throws InputError where there is no density, or the data are not those of a buckled strip
  BucklingBend(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth);
  /// A path of the clamps' distance (m) without measured forces; offset and drift of the force are
  /// its nuisance parameters.
  BucklingBend(const BucklingStrip& strip, const SampledPath& path);

  std::optional<Prediction> predict(const ComponentLaw& law, const Eigen::VectorXd& nuisance,
                                    bool with_jacobian) const override;
  /// The strip is as long as stated; offset and drift of the force are those that fit best.
  Eigen::VectorXd unfitted_nuisance(const ComponentLaw& law) const override;
  /// A strip that hangs or stands as a catenary, as long as stated.
  std::optional<Eigen::VectorXd> limp() const override;
  /// The span of the force: its zero is not known.
  double reference() const override;
  double peak_force() const override { return reference(); }

 private:
  struct Specimen {
    SpecimenRows rows;
    std::vector<HalfCycle> half_cycles;  ///< of the distance
    int first_nuisance = 0;
    bool length_is_known = true;
  };
  struct Followed;

  void add_specimen(const SpecimenRows& rows, const ExperimentSpec& spec, RestLength rest_length);
  void add_nuisance(size_t number, const SpecimenRows& rows, RestLength rest_length);
  void read_path(const Specimen& specimen, int number);
  Eigen::Vector2d best_zero(const Specimen& specimen, const Eigen::VectorXd& force) const;
  std::optional<Followed> follow(const Specimen& specimen, const ComponentLaw& law, double length,
                                 bool with_derivatives) const;
  bool predict_specimen(const Specimen& specimen, const ComponentLaw& law,
                        const Eigen::VectorXd& nuisance, bool with_jacobian,
                        Prediction& prediction) const;

  BucklingStrip strip_;
  double weight_ = 0;             // N/m^2
  std::vector<double> distance_;  // m
  std::vector<Specimen> specimens_;
};

}  // namespace pliant
