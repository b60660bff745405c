#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "pliant/study/study_fit.h"

#include "support/virtual_lab.h"

namespace pliant::test {

/// A material of Table 5.1 of [T]: "cotton", "spandex" or "polyester".
Material published_fabric(const std::string& name);

/// A knit: along warp a branch of friction that follows at once, another that comes slowly.
Material knit_of_two_branches(const ScalarCurve& stiffness);

/// A strip along warp whose stiffness has control points at strains of 0 to 0.2, and friction.
Material strip_of_five_points();

/// The virtual measurements of a lab as files, which a test may edit, and their fit.
class VirtualStudy {
 public:
  explicit VirtualStudy(const VirtualLab& lab, std::uint64_t seed = 0);

  const std::filesystem::path& folder() const { return folder_.path(); }

  /// Adds lines to an experiment, e.g. "noise: {length: 0.2 mm}".
  VirtualStudy& add_to_experiment(const std::string& line);
  /// Sets a field that the virtual lab wrote for an experiment.
  VirtualStudy& set_in_experiment(const std::string& field, const std::string& value);
  /// Adds a field of the study, e.g. "fit: {estimator: anchor}".
  VirtualStudy& add(const std::string& field);
  VirtualStudy& set_model(const std::string& fields);

  /// Edits the numbers of a data file; rows may be added or taken away.
  using Rows = std::vector<std::vector<double>>;
  VirtualStudy& edit_rows(const std::string& file, const std::function<void(Rows&)>& edit);

  Study study() const { return folder_.study(); }
  StudyResult fit(const StudyFitOptions& options = {}, int threads = 1) const;

 private:
  void write_study() const;

  LabFolder folder_;
  std::string study_;
};

/// The estimate of a name, a nuisance parameter's too; a test failure where there is none.
ParameterEstimate estimate_named(const StudyResult& result, const std::string& name);

/// The true value of a law's parameter in a material.
double truth_of(const Material& material, const std::string& name);

/// Error of an estimate as a share of the true value.
double relative_error(const StudyResult& result, const Material& truth, const std::string& name);

/// Names of all parameters of a component's law.
std::vector<std::string> names_of(const Material& material, const std::string& component);

}  // namespace pliant::test
