#pragma once

#include <memory>
#include <vector>

#include "pliant/experiment/press/press_type.h"
#include "pliant/experiment/solid_experiment.h"

namespace pliant {

/// Forces of a body that is pressed, at contact areas or depths that were set.
///
/// Each specimen begins at rest, and a law that remembers goes along the rows.
class PressTest : public SolidExperiment {
 public:
  /// @throws InputError for unusable data
  PressTest(const ExperimentSpec& spec, const DataRows& data);

  const PressSetup& setup() const { return spec_->setup; }
  bool is_at_areas() const { return at_areas_; }
  /// Areas (m^2) or depths (m), one a row.
  const std::vector<double>& set() const { return set_; }

  /// The largest force over the area that it acts on.
  double stress() const override;
  std::vector<double> imposed() const override;
  /// @param material  a solid that has a law, volumes included
  std::unique_ptr<Predictor> predictor(const Material& material) const override;

 private:
  std::shared_ptr<const PressSpec> spec_;
  bool at_areas_;
  std::vector<double> set_;
};

}  // namespace pliant
