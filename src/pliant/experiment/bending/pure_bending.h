#pragma once

#include "pliant/experiment/imposed_strain.h"
#include "pliant/experiment/sampled_path.h"

namespace pliant {

/// Bending of a sheet to and fro by an imposed curvature, the same everywhere; moment per width
/// measured (KES-FB2).
///
/// The strain of discrete shells is three times the curvature, and the moment per width is the
/// stress ([P] 4.3). A constant moment that the specimen's own curl needs goes into the offset.
class PureBending : public ImposedStrain {
 public:
  /// @throws InputError for rows that do not change
  PureBending(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth);
  /// A path of curvatures (1/m) without measured moments.
  explicit PureBending(const SampledPath& path);

  /// Moment per width over curvature.
  std::optional<LoopSeries> loop(const Eigen::VectorXd& moment) const override;
};

}  // namespace pliant
