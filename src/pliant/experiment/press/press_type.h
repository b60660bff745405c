#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "pliant/experiment/body_fields.h"
#include "pliant/experiment/press/pressed_body.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// A body that a rigid plane or sphere is pressed into: its force at each contact area ([T] 4.4.2).
const TestType& press_type();

/// What a study says of the body and its indenter.
struct PressSpec : TestSpec {
  const TestType* kind = nullptr;
  PressSetup setup;
  BodyFile mesh_file;
  std::string fixed;  ///< what is held, as it is written

  const TestType& type() const override { return *kind; }
  WrittenFields fields() const override;
  bool volume_may_change() const override { return true; }
  const VolumeMesh* body() const override { return &setup.mesh; }
  std::shared_ptr<const TestSpec> on_finer_body() const override;
  std::vector<std::filesystem::path> files() const override { return {mesh_file.path}; }
};

/// An indenter that goes in step by step and, where it cycles, back out.
struct VirtualPress : VirtualTest {
  const TestType* kind = nullptr;
  PressSetup setup;
  std::string fixed;           ///< what is held, as it is written
  std::vector<double> depths;  ///< at which it turns (m)
  int samples = 10;            ///< rows of the way to the largest
  bool cycles = false;         ///< after each depth back to the surface
  double noise = 0;            ///< of the force (N)

  const TestType& type() const override { return *kind; }
  void require(const Material& material) const override;
  int work() const override;
  VirtualData measure(const VirtualSpecimen& specimen, const VirtualWork& work) const override;
  WrittenFields study_fields() const override;
  std::string heading() const override { return setup.radius ? "a sphere" : "a plane"; }
  WrittenFields description() const override;
  nlohmann::ordered_json facts() const override;

 private:
  std::vector<double> path() const;
};

inline constexpr TestFacts kPressFacts{
    .measures_solids = true,
    .assumption = "the indenter is rigid and slides freely on the body",
    .unfitted = "a body at rest before its first row"};

/// What tests that press share; `kind` is the test's own type.
/// @throws InputError
std::shared_ptr<const TestSpec> read_press(const TestType& kind, Fields& fields);
std::shared_ptr<VirtualTest> read_virtual_press(const TestType& kind, Fields& fields);
std::unique_ptr<Experiment> make_press(const ExperimentSpec& spec, const DataRows& data);

}  // namespace pliant
