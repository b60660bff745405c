#include "pliant/geometry/volume_quality.h"

#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/block_mesh.h"

namespace pliant {
namespace {

struct Fault {
  std::string text;  // of the first problem
  std::function<void(VolumeMesh&)> make;
};

TEST(VolumeProblems, NameTheElementAndWhatIsWrongWithIt) {
  const VolumeMesh block = block_of_tetrahedra({1, 1, 1}, {2, 2, 2});
  const std::vector<Fault> faults{
      {"has no tetrahedra", [](VolumeMesh& m) { m.tetrahedra.resize(4, 0); }},
      {"tetrahedron 4 has a node that is not there",
       [](VolumeMesh& m) { m.tetrahedra(2, 3) = 99; }},
      {"tetrahedron 4 has a node twice",
       [](VolumeMesh& m) { m.tetrahedra(2, 3) = m.tetrahedra(1, 3); }},
      {"the position of node 6 is not finite",
       [](VolumeMesh& m) { m.positions(1, 5) = std::numeric_limits<double>::quiet_NaN(); }},
      {"tetrahedron 8 is turned inside out",
       [](VolumeMesh& m) { std::swap(m.tetrahedra(0, 7), m.tetrahedra(1, 7)); }},
      {"tetrahedron 1 is flat",
       [](VolumeMesh& m) {
         // The third node into the plane of the others, by a half of the sum of two.
         m.positions.col(m.tetrahedra(2, 0)) =
             (m.positions.col(m.tetrahedra(0, 0)) + m.positions.col(m.tetrahedra(1, 0))) / 2;
       }},
      {"node 28 belongs to no element",
       [](VolumeMesh& m) {
         m.positions.conservativeResize(3, 28);
         m.positions.col(27).setZero();
       }},
      {"tetrahedron 49 shares a side with two others", [](VolumeMesh& m) {
         m.tetrahedra.conservativeResize(4, 49);
         m.tetrahedra.col(48) = m.tetrahedra.col(0);
       }}};
  EXPECT_TRUE(find_volume_problems(block).empty());
  for (const Fault& fault : faults) {
    VolumeMesh mesh = block;
    fault.make(mesh);
    const VolumeNumbering numbering{"x.msh", 1, std::vector<int>(49, 17)};
    const auto problems = find_volume_problems(mesh, numbering);
    ASSERT_FALSE(problems.empty()) << fault.text;
    EXPECT_NE(problems.front().text.find(fault.text), std::string::npos)
        << problems.front().text << " for " << fault.text;
    try {
      require_good_volume_mesh(mesh, numbering);
      ADD_FAILURE() << fault.text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where().file, "x.msh");
      EXPECT_EQ(error.where().line, fault.text.starts_with("tetrahedron") ? 17 : 0);
    }
  }
}

TEST(VolumeProblems, FindHexahedraThatAreTurnedInsideOutAtAPoint) {
  VolumeMesh mesh = block_of_hexahedra({1, 1, 1}, {1, 1, 1});
  mesh.positions.col(0) << 0.9, 0.9, 0.9;  // one corner nearly into the one across
  EXPECT_GT(element_volumes(mesh)(0), 0);
  const auto problems = find_volume_problems(mesh);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].text, "hexahedron 0 is turned inside out");
}

TEST(VolumeQuality, IsOneOfRegularElements) {
  EXPECT_NEAR(volume_quality(block_of_hexahedra({1, 1, 1}, {2, 2, 2})).least_shape, 1, 1e-14);
  VolumeMesh regular;
  regular.positions.resize(3, 4);
  regular.positions << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
  regular.tetrahedra.resize(4, 1);
  regular.tetrahedra << 0, 1, 2, 3;
  if (element_volumes(regular)(0) < 0) regular.tetrahedra.col(0) << 1, 0, 2, 3;
  const VolumeQuality quality = volume_quality(regular);
  EXPECT_NEAR(quality.least_shape, 1, 1e-14);
  EXPECT_NEAR(quality.shortest_edge, std::sqrt(8.0), 1e-14);
  EXPECT_NEAR(quality.longest_edge, quality.mean_edge, 1e-14);
}

TEST(VolumeSlivers, AreNamedTheWorstFirst) {
  VolumeMesh mesh;
  mesh.positions.resize(3, 6);
  mesh.positions << 0, 1, 0, 0.3, 0.3, 2,  //
      0, 0, 1, 0.3, 0.3, 2,                //
      0, 0, 0, 0.005, -0.002, 2;
  mesh.tetrahedra.resize(4, 3);
  mesh.tetrahedra << 0, 0, 1,  //
      1, 2, 2,                 //
      2, 1, 3,                 //
      3, 4, 5;
  EXPECT_TRUE(find_volume_problems(mesh).empty());
  const std::vector<MeshProblem> slivers =
      find_slivers(mesh, {.file = "thin.msh", .first = 1, .element_lines = {11, 12, 13}});
  ASSERT_EQ(slivers.size(), 2U);
  EXPECT_EQ(slivers[0].text, "tetrahedron 2 is a sliver: its shape is 0.022");
  EXPECT_EQ(slivers[0].line, 12);
  EXPECT_EQ(slivers[1].line, 11);
  EXPECT_TRUE(find_slivers(block_of_tetrahedra({1, 1, 1}, {2, 2, 2})).empty());
}

}  // namespace
}  // namespace pliant
