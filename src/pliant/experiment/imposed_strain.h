#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/sampled_path.h"
#include "pliant/experiment/specimen_fields.h"
#include "pliant/measurement/data_source.h"
#include "pliant/measurement/turning_points.h"

namespace pliant {

/// What a machine that imposes a path of strain has recorded, a value a row (SI).
struct StrainRecord {
  std::vector<double> driven;               ///< what it moves at even speed: an angle, a curvature
  std::function<double(double)> strain_of;  ///< strain at a value of it; increasing
  std::vector<double> measured;             ///< stress, and what the apparatus adds to it; empty
                                            ///< of a path that is only predicted
  std::vector<double> apparatus;            ///< known share of the apparatus in `measured`
  std::vector<double> factor;               ///< `measured` per stress; empty: 1
  MeasuredQuantity quantity;
  std::string offset;       ///< name of the nuisance parameter for an offset of `measured`
  std::string offset_unit;  ///< of it in SI; empty: that of the quantity
};

/// Strain to and fro, imposed by a machine that measures the stress: shear and pure bending.
///
/// Of each specimen two numbers are estimated along: an offset of the measured quantity and, unless
/// it is at rest, the friction at the first row as a share of the maximum.
class ImposedStrain : public ComponentExperiment {
 public:
  std::optional<Prediction> predict(const ComponentLaw& law, const Eigen::VectorXd& nuisance,
                                    bool with_jacobian) const override;
  Eigen::VectorXd unfitted_nuisance(const ComponentLaw&) const override;
  std::optional<LoopSeries> loop(const Eigen::VectorXd& stress) const override;
  Eigen::VectorXd instrument_zero(const Eigen::VectorXd& nuisance) const override;

 protected:
  /// @throws InputError for a specimen of fewer than three rows
  ImposedStrain(const ExperimentSpec& spec, InitialFriction start, const DataRows& data,
                StrainRecord record);
  /// Measured value per strain, between the rows of least and largest strain.
  double secant() const;
  double largest_strain() const;
  /// Asks where what is measured falls while what is driven grows.
  std::optional<std::string> sign_question(std::string_view measured,
                                           std::string_view driven) const;
  /// A path of what is driven, from rest, without measured values.
  ImposedStrain(StrainRecord record, const SampledPath& path);

 private:
  struct Specimen {
    SpecimenRows rows;
    std::vector<HalfCycle> half_cycles;  // their turning values are strains
    int first_nuisance = -1;             // none: an ideal apparatus
    bool rested = true;
  };

  void add_specimen(const SpecimenRows& rows, const StrainRecord& record, bool rested);
  void describe_start(const ExperimentSpec& spec, InitialFriction start);
  void predict_specimen(const Specimen& specimen, const ComponentLaw& law,
                        const Eigen::VectorXd& nuisance, bool with_jacobian,
                        Prediction& prediction) const;

  std::vector<double> strain_;
  std::vector<double> apparatus_;
  std::vector<double> factor_;
  std::vector<Specimen> specimens_;
};

}  // namespace pliant
