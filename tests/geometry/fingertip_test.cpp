#include "pliant/geometry/fingertip.h"

#include <numbers>

#include <gtest/gtest.h>

#include "pliant/geometry/irregular_mesh.h"
#include "pliant/geometry/volume_quality.h"

namespace pliant {
namespace {

TEST(Fingertip, IsACappedCylinderOfThreeRegions) {
  if (!has_irregular_meshes()) GTEST_SKIP() << "built without CGAL";
  const Fingertip shape{0.022, 0.016, 0.013, 0.002};
  const VolumeMesh mesh = make_fingertip(shape);
  EXPECT_TRUE(find_volume_problems(mesh).empty());
  const double section = std::numbers::pi * shape.width * shape.height / 4;
  const double cap = shape.width / 2;
  const double volume = section * (shape.length - cap + 2.0 / 3 * cap);
  EXPECT_NEAR(element_volumes(mesh).sum(), volume, 0.06 * volume);
  std::map<int, double> of_regions;
  const Eigen::VectorXd volumes = element_volumes(mesh);
  for (int e = 0; e < mesh.element_count(); ++e) of_regions[mesh.label_of(e)] += volumes(e);
  ASSERT_EQ(of_regions.size(), 3u);
  for (const auto& [label, own] : of_regions) {
    EXPECT_GT(own, 0.1 * volume) << mesh.region_names.at(label);
  }
  for (const char* group : {"bone", "nail", "base"}) {
    EXPECT_GT(mesh.groups.at(group).size(), 5u) << group;
  }
  for (const int node : mesh.groups.at("nail")) EXPECT_GT(mesh.positions(2, node), 0);
}

}  // namespace
}  // namespace pliant
