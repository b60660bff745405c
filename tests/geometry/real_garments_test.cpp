// Garments as pattern designers make them: panels in the rest plane, sewn in space.

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "pliant/geometry/hinges.h"
#include "pliant/geometry/mesh_file.h"
#include "pliant/geometry/mesh_quality.h"

#include "io/input_error_of.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

class RealGarments : public testing::Test {
 protected:
  void SetUp() override {
    const char* data = std::getenv("PLIANT_TEST_DATA");
    folder_ = fs::path(data == nullptr ? "" : data);
    if (!fs::exists(folder_ / "garment_meshes")) GTEST_SKIP() << "no garment meshes";
  }
  fs::path garment(const std::string& name) const { return folder_ / "garment_meshes" / name; }
  fs::path folder_;
};

TEST_F(RealGarments, AreReadAsPanelsSewnTogether) {
  for (const char* name : {"tshirt.obj", "tshirt-iso.obj", "pants.obj", "pants-iso.obj"}) {
    SCOPED_TRACE(name);
    const MeshFile sheet = read_mesh_file(garment(name), {.unit = 1, .rest = RestShape::uv});
    const std::vector<AreaPair> panels = compare_areas(sheet.mesh, find_panels(sheet.mesh));
    EXPECT_GE(panels.size(), 2u);
    EXPECT_GT(find_hinges(sheet.mesh).size(), sheet.mesh.triangle_count());
    std::cout << name << ": " << sheet.mesh.triangle_count() << " triangles, " << panels.size()
              << " panels, " << rest_area(sheet.mesh) << " m^2, smallest angle "
              << mesh_quality(sheet.mesh).smallest_angle * 57.2958 << " deg\n";
  }
}

TEST_F(RealGarments, HaveThePanelsOfTheirPatternFile) {
  const MeshFile sewn =
      read_mesh_file(garment("tshirt-iso.obj"), {.unit = 1, .rest = RestShape::uv});
  const MeshFile pattern = read_mesh_file(garment("tshirt-iso-m.obj"), {.unit = 1});
  EXPECT_NEAR(rest_area(sewn.mesh), rest_area(pattern.mesh), 1e-9);
}

TEST_F(RealGarments, APackedTextureAtlasIsRefused) {
  const fs::path body = folder_ / "body_and_motion" / "makehuman_base.obj";
  if (!fs::exists(body)) GTEST_SKIP() << "no body mesh";
  const InputError error = test::input_error_of(
      [&] { read_mesh_file(body, {.unit = 0.1, .up = "y", .rest = RestShape::uv}); });
  std::cout << error.what() << "\n";
}

}  // namespace
}  // namespace pliant
