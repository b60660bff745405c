#pragma once

#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/hanging/hanging_weights_type.h"
#include "pliant/experiment/uniaxial_geometry.h"
#include "pliant/measurement/data_source.h"

namespace pliant {

/// Weights hung from a sheet, up and down again; its length under each is measured ([T] 5.3.2).
///
/// The weights are known exactly and drive the path; the lengths carry the noise. So the prediction
/// of a row is the length at which the law balances the weight (Eq. 5.5), reached monotonically
/// from the row before: the first equilibrium met on the way, as a dead weight finds it.
class HangingWeights : public ComponentExperiment {
 public:
  /// Half of the cloth's own weight hangs from the middle.
  HangingWeights(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth);
  /// Weights (N) without measured lengths, hung from a sheet that rested before the first.
  HangingWeights(const HangingWeightsSpec& spec, const std::vector<double>& weights,
                 const ClothFacts& cloth);

  std::optional<Prediction> predict(const ComponentLaw& law, const Eigen::VectorXd& nuisance,
                                    bool with_jacobian) const override;
  Eigen::VectorXd unfitted_nuisance(const ComponentLaw&) const override {
    return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(nuisance_.size()));
  }
  std::unique_ptr<ComponentExperiment> with_free_length() const override;
  std::optional<LoopSeries> loop(const Eigen::VectorXd& length) const override;

 private:
  void read_path();
  void warn_of_order(const DataRows& data, bool rested);
  void free_rest_length();

  UniaxialGeometry geometry_;
  std::vector<SpecimenRows> specimens_;
  std::vector<double> force_;        // N, with clip and half of the cloth
  std::vector<char> starts_rested_;  // rows before which the specimen rested
};

}  // namespace pliant
