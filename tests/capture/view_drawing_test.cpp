#include "pliant/capture/view_drawing.h"

#include <gtest/gtest.h>

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

TEST(ChipNoise, HasItsDeviationAndSteps) {
  GreyPicture picture = GreyPicture::Constant(200, 200, 0.5F);
  RandomStream random(1);
  add_chip_noise(picture, {0.01, 0, 8}, random);
  const double sd = std::sqrt((picture - picture.mean()).square().mean());
  EXPECT_NEAR(sd, 0.01, 0.0005);
  const double level = picture(3, 5) * 255;
  EXPECT_NEAR(level, std::round(level), 1e-4);
}

}  // namespace
}  // namespace pliant
