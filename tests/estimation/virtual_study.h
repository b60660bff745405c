#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "pliant/estimation/study_fit.h"
#include "pliant/experiment/virtual_lab.h"

#include "io/temporary_folder.h"

namespace pliant::test {

/// A material of Table 5.1 of [T]: "cotton", "spandex" or "polyester".
Material published_fabric(const std::string& name);

/// A material that has one component.
Material made_up_material(const std::string& component, const ComponentLaw& law);

/// The weights of [T] 5.3.2: 1 to 6 N in steps of 1 N, three times, a clip of 20 g, 100 mm x 100
/// mm.
LabExperiment hung_weights();

/// Cycles of growing amplitude on a strip of 100 mm x 40 mm, and how it is sampled by default.
LabExperiment strip_cycles(std::vector<double> engineering_strains);

VirtualLab lab_of(const Material& material, const LabExperiment& experiment);

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

  Study study() const;
  StudyResult fit(const StudyFitOptions& options = {}, int threads = 1) const;

 private:
  void write_study() const;

  TemporaryFolder folder_;
  std::string study_;
};

/// The estimate of a name, a nuisance parameter's too; a test failure where there is none.
ParameterEstimate estimate_named(const StudyResult& result, const std::string& name);

/// The true value of a law's parameter in a material.
double truth_of(const Material& material, const std::string& name);

/// Names of all parameters of a component's law.
std::vector<std::string> names_of(const Material& material, const std::string& component);

}  // namespace pliant::test
