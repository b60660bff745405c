#pragma once

#include <memory>
#include <vector>

#include "pliant/experiment/homogeneous/homogeneous_rows.h"
#include "pliant/experiment/solid_experiment.h"

namespace pliant {

/// Nominal stresses of a solid that is deformed alike all over, row by row.
///
/// Each specimen, and each mode of it, begins at rest; a law that remembers goes along the rows.
class HomogeneousTest : public SolidExperiment {
 public:
  /// @throws InputError for unusable data
  HomogeneousTest(const ExperimentSpec& spec, const DataRows& data);

  const std::vector<HomogeneousRow>& path() const { return path_; }
  bool is_incompressible() const { return incompressible_; }

  /// @param material  a solid that has a law
  std::unique_ptr<Predictor> predictor(const Material& material) const override;

 private:
  void take_times();
  void cut_into_frames(const std::vector<SpecimenRows>& specimens);

  std::vector<HomogeneousRow> path_;
  bool incompressible_ = true;
};

}  // namespace pliant
