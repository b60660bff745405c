#include "pliant/experiment/session/virtual/cut_sheet.h"

#include <gtest/gtest.h>

#include "pliant/experiment/session/virtual/test_clips.h"
#include "pliant/geometry/irregular_mesh.h"

namespace pliant {
namespace {

/// Area of the triangles whose corners a clip clamps: they move with it (m^2).
double area_held(const CutSheet& sheet, const TestClip& clip) {
  double area = 0;
  for (int t = 0; t < sheet.rest.triangle_count(); ++t) {
    bool held = true;
    for (const int vertex : sheet.rest.triangles.col(t)) {
      held = held && clip.holds.contains(sheet.places.col(vertex));
    }
    if (held) area += rest_area(sheet.rest, t);
  }
  return area;
}

TEST(CutSheet, IsHeldByClipsExactlyWhereTheyAre) {
  if (!has_irregular_meshes()) GTEST_SKIP() << "built without CGAL";
  for (const char* test : {"stretch-weft", "stretch-warp", "shear", "corner-pull", "complex-shear",
                           "bias-extension"}) {
    VirtualSession options = usual_session(test);
    options.edge = 0.0031;  // does not go into the clips' depth of 5 mm
    const CutSheet sheet = cut_sheet(options);
    for (const TestClip& clip : test_clips(options)) {
      EXPECT_NEAR(area_held(sheet, clip), clip.holds.volume(), 1e-12) << test << ' ' << clip.name;
    }
  }
}

}  // namespace
}  // namespace pliant
