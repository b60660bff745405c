#pragma once

#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/imposed_strain.h"

namespace pliant {

/// Bending of a sheet to and fro by an imposed curvature, the same everywhere; moment per width
/// measured (KES-FB2).
///
/// The strain of discrete shells is three times the curvature, and the moment per width is the
/// stress ([P] 4.3). A constant moment that the specimen's own curl needs goes into the offset.
class PureBending : public ImposedStrain {
 public:
  /// @throws InputError for rows that do not change
  PureBending(const ExperimentSpec& spec, const DataRows& data);

  /// Moment per width over curvature.
  std::optional<LoopSeries> loop(const Eigen::VectorXd& moment) const override;
};

}  // namespace pliant
