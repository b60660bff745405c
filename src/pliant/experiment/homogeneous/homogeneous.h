#pragma once

#include <memory>
#include <vector>

#include "pliant/experiment/experiment.h"
#include "pliant/experiment/homogeneous/homogeneous_rows.h"

namespace pliant {

/// Nominal stresses of a solid that is deformed alike all over, row by row.
///
/// Each specimen, and each mode of it, begins at rest; a law that remembers goes along the rows.
class HomogeneousTest : public Experiment {
 public:
  /// @throws InputError for unusable data
  HomogeneousTest(const ExperimentSpec& spec, const DataRows& data);

  const std::vector<HomogeneousRow>& path() const { return path_; }
  bool is_incompressible() const { return incompressible_; }

  /// Half cycles.
  std::vector<Frame> frames() const override { return frames_; }
  std::vector<std::vector<int>> series() const override;
  double reference() const override;
  Eigen::ArrayXd weights() const override;
  /// @param material  a solid that has a law
  std::unique_ptr<Predictor> predictor(const Material& material) const override;

  /// Rows that begin at rest.
  const std::vector<int>& beginnings() const { return beginnings_; }

 private:
  void cut_into_frames(const std::vector<SpecimenRows>& specimens);

  std::vector<HomogeneousRow> path_;
  std::vector<Frame> frames_;
  std::vector<int> beginnings_;
  bool incompressible_ = true;
};

}  // namespace pliant
