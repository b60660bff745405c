#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/experiment/body_fields.h"
#include "pliant/experiment/moved_body/body_setup.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// A body that is held in one place and moved in another: forces and positions of marks on its
/// surface ([T] 4.3).
const TestType& moved_body_type();

/// What a study says of the body and its marks.
struct MovedBodySpec : TestSpec {
  BodySetup setup;
  BodyFile mesh_file;
  std::string fixed, moved;          ///< as they are written
  std::optional<DataSource> points;  ///< of the marks' positions

  const TestType& type() const override { return moved_body_type(); }
  WrittenFields fields() const override;
  bool volume_may_change() const override { return true; }
  const VolumeMesh* body() const override { return &setup.mesh; }
  std::shared_ptr<const TestSpec> on_finer_body() const override;
  std::vector<std::filesystem::path> files() const override;
};

/// A body that is moved from place to place, its marks followed by cameras.
struct VirtualMovedBody : VirtualTest {
  BodySetup setup;
  std::string fixed, moved;              ///< as they are written
  std::optional<VolumeMesh> study_mesh;  ///< that the study gets in place of the own
  std::vector<Eigen::Vector3d> shifts;   ///< of what is moved, one a frame (m)
  int marks = 100;                       ///< of the surface that is free
  double force_noise = 0;                ///< standard deviations (N, m)
  double length_noise = 0;

  const TestType& type() const override { return moved_body_type(); }
  void require(const Material& material) const override;
  int work() const override { return static_cast<int>(shifts.size()); }
  VirtualData measure(const VirtualSpecimen& specimen, const VirtualWork& work) const override;
  WrittenFields study_fields() const override;
  std::string heading() const override { return "a body"; }
  WrittenFields description() const override;
  nlohmann::ordered_json facts() const override;
};

}  // namespace pliant
