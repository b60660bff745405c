#include "pliant/capture/view_drawing.h"

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

CameraModel bent_lens() {
  CameraModel camera;
  camera.intrinsics << 400, 404, 100, 80, -0.2, 0, 0, 0, 0;
  camera.pose = {{0.2, -0.1, 0.05}, {0.01, 0, 0.5}};
  camera.columns = 200;
  camera.rows = 160;
  return camera;
}

/// Where brightness is half-way along a row that begins bright, between pixels.
double edge_in_row(const GreyPicture& picture, int row, double half) {
  for (int column = 1; column < picture.cols(); ++column) {
    const double before = picture(row, column - 1), after = picture(row, column);
    if (before > half && after <= half) {
      return column - 1 + (before - half) / (before - after);
    }
  }
  return -1;
}

TEST(ViewDrawing, ShowsAnEdgeWhereTheCameraDoes) {
  const CameraModel camera = bent_lens();
  const double edge = 0.03;
  const DrawnSurface surface =
      flat_rectangle({Eigen::Vector2d(-0.2, -0.2), Eigen::Vector2d(0.2, 0.2)}, 0,
                     [&](const Eigen::Vector2d& place) { return place.x() < edge ? 0.9 : 0.1; });
  ViewOptions options;
  options.ambient = 1;
  const GreyPicture picture = draw_view(camera, {surface}, options);
  for (const double y : {-0.03, 0.0, 0.04}) {
    const Eigen::Vector2d pixel = *camera.project({edge, y, 0});
    const int row = static_cast<int>(std::lround(pixel.y()));
    // The edge through the middle of that row.
    const Eigen::Vector2d beside = *camera.project({edge, y + 1e-4, 0});
    const double slope = (beside.x() - pixel.x()) / (beside.y() - pixel.y());
    EXPECT_NEAR(edge_in_row(picture, row, 0.5), pixel.x() + slope * (row - pixel.y()), 0.08) << y;
  }
}

TEST(ViewDrawing, ShowsWhatIsNearer) {
  const CameraModel camera = bent_lens();
  const auto grey = [](double brightness) {
    return [brightness](const Eigen::Vector2d&) { return brightness; };
  };
  const Eigen::AlignedBox2d large(Eigen::Vector2d(-0.3, -0.3), Eigen::Vector2d(0.3, 0.3));
  const Eigen::AlignedBox2d small(Eigen::Vector2d(-0.02, -0.02), Eigen::Vector2d(0.02, 0.02));
  ViewOptions options;
  options.ambient = 1;
  const std::vector<DrawnSurface> near{flat_rectangle(small, -0.01, grey(0.8)),
                                       flat_rectangle(large, 0, grey(0.3))};
  const std::vector<DrawnSurface> far{flat_rectangle(small, 0.01, grey(0.8)), near[1]};
  const Eigen::Vector2d pixel = *camera.project({0, 0, 0});
  const auto row = static_cast<int>(pixel.y()), column = static_cast<int>(pixel.x());
  EXPECT_NEAR(draw_view(camera, near, options)(row, column), 0.8, 1e-6);
  EXPECT_NEAR(draw_view(camera, far, options)(row, column), 0.3, 1e-6);
}

/// Flat, around the origin, of small facets, each of which shines evenly.
DrawnSurface glossy_sheet(double brightness, double gloss) {
  constexpr double kSide = 0.3;  // m
  constexpr int kNodes = 151;
  const TriangleMesh mesh = regular_grid(kSide, kSide, kNodes, kNodes);
  DrawnSurface surface;
  surface.positions = mesh.positions.colwise() - Eigen::Vector3d(kSide / 2, kSide / 2, 0);
  surface.triangles = mesh.triangles;
  surface.places = mesh.positions.topRows<2>();
  surface.brightness = [brightness](const Eigen::Vector2d&) { return brightness; };
  surface.gloss = gloss;
  return surface;
}

TEST(ViewDrawing, ShinesWhereAMirrorWouldShowTheLightWhichEachCameraSeesElsewhere) {
  constexpr double kBright = 0.2, kGloss = 0.5;
  ViewOptions options;
  options.ambient = 1;
  options.light = {0.13, 0.17, -1};
  CameraModel other = bent_lens();
  other.pose.translation.x() += 0.04;
  for (const CameraModel& camera : {bent_lens(), other}) {
    const GreyPicture picture = draw_view(camera, {glossy_sheet(kBright, kGloss)}, options);
    // Seen from the camera's mirror image behind the sheet, towards the light.
    const Eigen::Vector3d centre = camera.centre();
    const Eigen::Vector3d mirrored(centre.x(), centre.y(), -centre.z());
    const Eigen::Vector3d spot = mirrored + centre.z() / options.light.z() * options.light;
    EXPECT_NEAR(spot.z(), 0, 1e-12);
    Eigen::Index row = 0, column = 0;
    EXPECT_NEAR(picture.maxCoeff(&row, &column), kBright + kGloss, 1e-3);
    const Eigen::Vector2d expected = *camera.project(spot);
    // A facet is two pixels wide.
    EXPECT_NEAR(static_cast<double>(column), expected.x(), 3);
    EXPECT_NEAR(static_cast<double>(row), expected.y(), 3);
  }
}

double deviation_of(const GreyPicture& picture) {
  return std::sqrt((picture - picture.mean()).square().mean());
}

TEST(ChipNoise, HasAVarianceThatGrowsWithBrightness) {
  constexpr double kRead = 0.01, kShot = 0.02;
  for (const float bright : {0.1F, 0.2F, 0.8F}) {
    GreyPicture picture = GreyPicture::Constant(200, 200, bright);
    RandomStream random(2);
    add_chip_noise(picture, {kRead, kShot, 14}, random);
    const double expected = std::sqrt(kRead * kRead + kShot * kShot * static_cast<double>(bright));
    // 40,000 pixels tell a deviation to 0.4 %.
    EXPECT_NEAR(deviation_of(picture), expected, 0.02 * expected) << bright;
  }
}

TEST(ChipNoise, HasItsDeviationAndSteps) {
  GreyPicture picture = GreyPicture::Constant(200, 200, 0.5F);
  RandomStream random(1);
  add_chip_noise(picture, {0.01, 0, 8}, random);
  EXPECT_NEAR(deviation_of(picture), 0.01, 0.0005);
  const double level = picture(3, 5) * 255;
  EXPECT_NEAR(level, std::round(level), 1e-4);
}

}  // namespace
}  // namespace pliant
