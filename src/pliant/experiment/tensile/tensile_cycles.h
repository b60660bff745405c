#pragma once

#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/sampled_path.h"
#include "pliant/experiment/tensile/strip_pull.h"
#include "pliant/experiment/tensile/tensile_cycles_type.h"
#include "pliant/experiment/uniaxial_geometry.h"
#include "pliant/measurement/data_source.h"
#include "pliant/measurement/turning_points.h"

namespace pliant {

/// Load-unload cycles of a strip on a tensile tester: clamp distance imposed, force measured.
///
/// The clamp distance drives the path; forces follow from pull_strip. The force offset of each
/// specimen is a nuisance parameter; so are, where they are unknown, its friction state at the
/// first row and its rest length.
class TensileCycles : public ComponentExperiment, public FollowingExperiment {
 public:
  TensileCycles(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth);
  /// A path of the clamps (m) without measured forces, of a fresh strip.
  TensileCycles(const UniaxialGeometry& geometry, const SampledPath& path,
                const Clamps& clamps = {});

  std::optional<Prediction> predict(const ComponentLaw& law, const Eigen::VectorXd& nuisance,
                                    bool with_jacobian) const override;
  /// The force offset read off the rows in which the strip is slack; no slack of its own, no
  /// friction at the start.
  Eigen::VectorXd unfitted_nuisance(const ComponentLaw&) const override;
  std::unique_ptr<ComponentExperiment> with_free_length() const override;
  std::optional<LoopSeries> loop(const Eigen::VectorXd& force) const override;
  Eigen::VectorXd instrument_zero(const Eigen::VectorXd& nuisance) const override;
  /// Specimen by specimen in the order of the data; the earlier pull is followed with the clamps
  /// that were stated of it.
  void follow(const ComponentExperiment& earlier, const Location& where) override;

  /// What the tester reads while each specimen is slack, 0 where it never is (N).
  Eigen::VectorXd force_offsets() const;

 private:
  // What was done to a strip before.
  struct PastPull {
    UniaxialGeometry geometry;
    Clamps clamps;
    std::vector<double> length, time;  // of the rows (m, s)
    std::vector<HalfCycle> half_cycles;
  };
  struct Specimen {
    SpecimenRows rows;
    std::vector<HalfCycle> half_cycles;  // rows counted from the specimen's first
    double slack_force = 0;  // mean force while the clamps are nearer than the gauge length
    int slack_rows = 0;
    StripColumns nuisance;       // indices of the specimen's nuisance parameters
    std::vector<PastPull> past;  // in the order of time
  };

  void add_specimen(const SpecimenRows& rows, const ExperimentSpec& spec);
  std::span<const double> lengths_of(const SpecimenRows& rows) const;
  static std::optional<PathPoint> left_by(const std::vector<PastPull>& past,
                                          const ComponentLaw& law, int parameters);
  void exclude_conditioning(const Specimen& specimen, int cycles);
  void add_nuisance(Specimen& specimen, size_t number, const TensileCyclesSpec& spec);
  void free_rest_length(Specimen& specimen, size_t number);
  void read_path(const Specimen& specimen, int number);
  void ask_of_rest_length(const TensileCyclesSpec& spec);
  void describe(const ExperimentSpec& spec);
  void describe_nuisance(const ExperimentSpec& spec);

  UniaxialGeometry geometry_;
  double apparatus_friction_ = 0;
  Clamps clamps_;
  std::vector<double> length_;  // clamp distance, m
  std::vector<Specimen> specimens_;
};

}  // namespace pliant
