#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pliant/estimation/solid/solid_fit.h"
#include "pliant/estimation/solid/solid_laws.h"
#include "pliant/experiment/homogeneous/homogeneous_type.h"
#include "pliant/study/body_samples.h"
#include "pliant/study/solid_results.h"
#include "pliant/study/solid_study.h"
#include "pliant/study/study_fit.h"

#include "io/temporary_folder.h"
#include "support/solid_materials.h"
#include "support/virtual_lab.h"

namespace pliant::test {

inline VirtualHomogeneous homogeneous(HomogeneousMode mode, std::vector<double> peaks) {
  VirtualHomogeneous test;
  test.name = std::string(name_of(mode));
  test.mode = mode;
  test.peaks = std::move(peaks);
  return test;
}

/// Uniaxial, equibiaxial and planar tests of a rubber.
inline std::vector<AnyTest> three_modes(double noise = 0) {
  std::vector<VirtualHomogeneous> tests{homogeneous(HomogeneousMode::uniaxial, {4}),
                                        homogeneous(HomogeneousMode::equibiaxial, {2.5}),
                                        homogeneous(HomogeneousMode::planar, {3})};
  std::vector<AnyTest> any;
  for (VirtualHomogeneous& test : tests) {
    test.noise = noise;
    any.emplace_back(test);
  }
  return any;
}

/// A study of virtual measurements of a solid.
/// @param model  fields of the study's model
inline Study solid_study(const LabFolder& folder, const std::string& model,
                         const std::string& more = "") {
  std::string text = content_of(folder.path() / "study.yaml");
  const std::string usual = "model: {kind: solid}";
  text.replace(text.find(usual), usual.size(), "model: {kind: solid, " + model + "}");
  folder.write("study.yaml", text + more);
  return read_study(folder.path() / "study.yaml");
}

/// The numbers that `fit_study` finds and how its experiments are met, without the error of the
/// mesh: on bodies of elements half as large that takes longer than the fit.
inline StudyResult fit_on_its_mesh(const Study& study) {
  std::vector<std::unique_ptr<Experiment>> experiments;
  std::vector<const Experiment*> fitted;
  for (const ExperimentSpec& spec : study.experiments) {
    experiments.push_back(spec.test->type().make_solid(spec, DataRows(spec.data)));
    fitted.push_back(experiments.back().get());
  }
  const SolidFit fit = fit_solid(study, solid_components(study.model, is_compressible(study)),
                                 body_samples(study), fitted, /*finer=*/{}, {});
  StudyResult result;
  add_solid_fit(fit, result);
  for (const Experiment* experiment : fitted) {
    result.experiments.push_back(compare_solid(*experiment, fit.material));
  }
  return result;
}

inline double value_of(const StudyResult& result, const std::string& name) {
  for (const ParameterEstimate& parameter : result.parameters) {
    if (parameter.name == name) return parameter.value;
  }
  ADD_FAILURE() << "no parameter " << name;
  return 0;
}

}  // namespace pliant::test
