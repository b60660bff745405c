#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pliant/experiment/hanging/hanging_weights_type.h"
#include "pliant/experiment/tensile/tensile_cycles_type.h"
#include "pliant/study/study.h"
#include "pliant/study/virtual_lab.h"

#include "io/temporary_folder.h"

namespace pliant::test {

/// A material that has one component.
inline Material made_up_material(const std::string& component, const ComponentLaw& law) {
  Material material;
  material.name = "made-up";
  material.density = 0.15;
  set_law(material.components[component], law);
  return material;
}

/// The weights of [T] 5.3.2: 1 to 6 N in steps of 1 N, three times, a clip of 20 g, 100 mm x 100
/// mm.
inline VirtualHangingWeights hung_weights() {
  VirtualHangingWeights experiment;
  experiment.name = "weights";
  experiment.direction = "warp";
  experiment.clip_mass = 0.02;
  experiment.peaks = {1, 2, 3, 4, 5, 6};
  experiment.repeats = 3;
  return experiment;
}

/// Cycles of growing amplitude on a strip of 100 mm x 40 mm, and how it is sampled by default.
inline VirtualTensileCycles strip_cycles(std::vector<double> engineering_strains) {
  VirtualTensileCycles experiment;
  experiment.name = "cycles";
  experiment.direction = "warp";
  experiment.width = 0.04;
  experiment.peaks = std::move(engineering_strains);
  return experiment;
}

/// A copy of a virtual test of any type.
struct AnyTest {
  template <std::derived_from<VirtualTest> Test>
  AnyTest(const Test& own) : test(std::make_shared<Test>(own)) {}

  std::shared_ptr<VirtualTest> test;
};

inline VirtualLab lab_of(const Material& material, const std::vector<AnyTest>& experiments) {
  VirtualLab lab;
  lab.name = material.name;
  lab.material = material;
  for (const AnyTest& any : experiments) lab.experiments.push_back(any.test);
  return lab;
}

template <std::derived_from<VirtualTest> Test>
VirtualLab lab_of(const Material& material, const Test& experiment) {
  return lab_of(material, std::vector<AnyTest>{experiment});
}

/// An experiment of a lab, whose type the caller knows.
template <class Test>
Test& experiment_of(const VirtualLab& lab, std::size_t i) {
  return dynamic_cast<Test&>(*lab.experiments.at(i));
}

/// Names and contents of files.
using MeasuredFiles = TestFiles;

inline MeasuredFiles measurements_of(const VirtualLab& lab, std::uint64_t seed = 0) {
  RunContext context;
  context.seed = seed;
  return make_measurements(lab, context);
}

/// A folder with virtual measurements and the study of them.
class LabFolder : public TemporaryFolder {
 public:
  explicit LabFolder(const MeasuredFiles& files) {
    for (const auto& [name, content] : files) write(name, content);
  }

  /// Puts another model into the study.
  void set_model(const std::string& fields) {
    std::string text = content_of(path() / "study.yaml");
    const std::size_t at = text.find("model: {");
    text.replace(at, text.find('\n', at) - at, "model: {" + fields + "}");
    write("study.yaml", text);
  }

  Study study() const { return read_study(path() / "study.yaml"); }
};

}  // namespace pliant::test
