// Facts of geometry and light that a picture must show.

#include "pliant/render/render.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"

#include "render/small_scenes.h"

namespace pliant {
namespace {

using test::brightness;
using test::front_camera;
using test::is_background;
using test::rectangle;
using test::top_camera;

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX(), kY = Eigen::Vector3d::UnitY(),
                      kZ = Eigen::Vector3d::UnitZ();

Image draw(const RenderScene& scene, const Camera& camera, const PictureSize& size = {64, 64},
           int threads = 1) {
  RunContext run;
  run.threads = threads;
  return render(scene, camera, size, {}, run);
}

/// A square of 1 m that faces the front camera, with the light behind the camera.
RenderScene facing_square() {
  RenderScene scene;
  scene.meshes.push_back(rectangle({-0.5, 0, -0.5}, kX, kZ));
  scene.light.direction = -kY;
  return scene;
}

// The field of view is 2 m in 64 pixels: the square covers those from 16 to 47.
TEST(Picture, OfASquareCoversItsPixelsAndNoOther) {
  const Image image = draw(facing_square(), front_camera());
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool inside = x >= 16 && x < 48 && y >= 16 && y < 48;
      EXPECT_EQ(is_background(image.at(x, y)), !inside) << x << ", " << y;
    }
  }
}

TEST(Picture, HasXToTheRightAndZUpwards) {
  RenderScene scene;
  scene.meshes.push_back(rectangle({0.5, 0, 0.25}, 0.25 * kX, 0.5 * kZ));
  const Image image = draw(scene, front_camera());
  EXPECT_FALSE(is_background(image.at(52, 16)));
  EXPECT_TRUE(is_background(image.at(11, 16)));
  EXPECT_TRUE(is_background(image.at(52, 47)));
}

// The edge runs through the middle of column 40: half of the samples of its pixels meet the square.
TEST(Picture, SmoothsEdges) {
  RenderScene scene = facing_square();
  scene.meshes[0] = rectangle({-0.5, 0, -0.5}, (0.5 + 8.5 / 32) * kX, kZ);
  scene.meshes[0].front = Colour::Zero();
  const Image image = draw(scene, front_camera());
  EXPECT_EQ(image.at(39, 32), (Pixel{0, 0, 0}));
  EXPECT_EQ(image.at(40, 32), (Pixel{188, 188, 188}));  // half of the light
  EXPECT_TRUE(is_background(image.at(41, 32)));
}

TEST(Picture, ShowsWhatIsNearestWhicheverMeshComesFirst) {
  RenderScene scene = facing_square();
  scene.meshes[0].front = Colour::UnitX();
  RenderMesh behind = rectangle({-0.5, 0.3, -0.5}, kX, kZ);
  behind.front = Colour::UnitY();
  scene.meshes.push_back(behind);
  EXPECT_GT(draw(scene, front_camera()).at(32, 32)[0], 200);
  std::swap(scene.meshes[0], scene.meshes[1]);
  EXPECT_GT(draw(scene, front_camera()).at(32, 32)[0], 200);
}

TEST(Picture, ShowsBothSidesOfASurfaceAlikeButForTheirColours) {
  RenderScene scene = facing_square();
  scene.meshes[0].back = scene.meshes[0].front;
  const Image front = draw(scene, front_camera());
  scene.meshes[0].triangles.row(0).swap(scene.meshes[0].triangles.row(1));
  EXPECT_EQ(draw(scene, front_camera()).pixels(), front.pixels());
}

TEST(Picture, IsTheSameForAnyNumberOfThreads) {
  RenderScene scene = facing_square();
  scene.meshes.push_back(rectangle({-0.3, -0.4, -0.6}, 0.9 * kX, Eigen::Vector3d(0.1, 0.5, 0.2)));
  scene.ground = -0.7;
  const Image one = draw(scene, front_camera(), {80, 60}, 1);
  for (const int threads : {1, 2, 5}) {
    EXPECT_EQ(draw(scene, front_camera(), {80, 60}, threads).pixels(), one.pixels()) << threads;
  }
}

// Single precision at 1000 km would resolve 6 cm.
TEST(Picture, DoesNotDependOnWhereTheSceneIs) {
  RenderScene scene = facing_square();
  Camera camera = front_camera();
  const Image image = draw(scene, camera);
  const Eigen::Vector3d far(1e6, -2e6, 5e5);
  scene.meshes[0].positions.colwise() += far;
  camera.position += far;
  camera.target += far;
  const Image moved = draw(scene, camera);
  for (size_t i = 0; i < image.pixels().size(); ++i) {
    for (size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(image.pixels()[i][k], moved.pixels()[i][k], 1);
    }
  }
}

/// A table of 0.4 m at height 0.4 over the ground, with light from the left, 45 degrees high.
RenderScene table_over_ground() {
  RenderScene scene;
  scene.meshes.push_back(rectangle({-0.2, -0.2, 0.4}, 0.4 * kX, 0.4 * kY));
  scene.ground = 0;
  scene.light.direction = {-1, 0, 1};
  scene.light.angular_radius = 0;
  scene.ambient = 0;
  return scene;
}

// Seen from 2 m above, the table covers x up to 0.25 of the ground; its shadow reaches from 0.2
// to 0.6: pixels 40 to 51.
TEST(Shadow, FallsOnTheGroundOppositeToTheLight) {
  const Image image = draw(table_over_ground(), top_camera());
  EXPECT_EQ(image.at(45, 32), (Pixel{0, 0, 0}));
  EXPECT_EQ(image.at(50, 32), (Pixel{0, 0, 0}));
  EXPECT_TRUE(is_background(image.at(53, 32)));
  EXPECT_TRUE(is_background(image.at(18, 32)));
  EXPECT_TRUE(is_background(image.at(45, 18)));
}

TEST(Shadow, HasASoftEdgeWhereTheLightIsADisk) {
  RenderScene scene = table_over_ground();
  const auto is_grey = [](const Pixel& pixel) { return pixel[0] > 40 && pixel[0] < 240; };
  const auto grey_pixels = [&] {
    const Image image = draw(scene, top_camera());
    int count = 0;
    for (int x = 42; x < 62; ++x) count += is_grey(image.at(x, 32)) ? 1 : 0;
    return count;
  };
  EXPECT_LE(grey_pixels(), 1);  // the pixel of the edge
  scene.light.angular_radius = 0.15;
  EXPECT_GE(grey_pixels(), 3);
}

TEST(Shadow, FallsOnOtherSurfacesToo) {
  RenderScene scene = table_over_ground();
  scene.ground.reset();
  scene.meshes.push_back(rectangle({-1, -1, 0}, 2 * kX, 2 * kY));
  const Image image = draw(scene, top_camera());
  EXPECT_EQ(brightness(image.at(47, 32)), 0);
  EXPECT_GT(brightness(image.at(56, 32)), 300);
}

TEST(Shadow, OfAmbientLightIsDeepestNearWhatIsInTheWay) {
  RenderScene scene = table_over_ground();
  scene.ambient = 1;
  scene.meshes[0] = rectangle({-0.02, -0.5, 0}, kY, 0.5 * kZ);  // a wall across the ground
  const Image image = draw(scene, top_camera());
  const int near = brightness(image.at(35, 32)), middle = brightness(image.at(43, 32));
  EXPECT_LT(near, middle - 30);
  EXPECT_LT(middle, brightness(image.at(54, 32)));
}

TEST(Shadow, FadesTowardsTheEdgeOfThePicture) {
  RenderScene scene = table_over_ground();
  scene.meshes[0] = rectangle({-3, -3, 5}, 6 * kX, 6 * kY);  // above the camera, dims everything
  scene.light.direction = kZ;
  const Image image = draw(scene, top_camera());
  EXPECT_EQ(brightness(image.at(32, 32)), 0);
  EXPECT_TRUE(is_background(image.at(0, 32)));
  EXPECT_TRUE(is_background(image.at(32, 63)));
}

TEST(Light, MakesWhatItFallsOnSquarelyAsBrightAsItsColour) {
  RenderScene scene = facing_square();
  scene.ambient = 0;
  scene.meshes[0].front = colour_of_rgb(0x7fa3cf);
  EXPECT_EQ(draw(scene, front_camera()).at(32, 32), (Pixel{0x7f, 0xa3, 0xcf}));
}

// Lambert: half the light at 60 degrees.
TEST(Light, FallsOffWithTheCosine) {
  RenderScene scene = facing_square();
  scene.ambient = 0;
  scene.light = {{std::sqrt(0.75), -0.5, 0}, 0};
  scene.meshes[0].front = Colour::Ones();
  EXPECT_EQ(draw(scene, front_camera()).at(32, 32), (Pixel{188, 188, 188}));
}

TEST(Picture, TellsTheFrontFromTheBack) {
  RenderScene scene = facing_square();
  scene.ambient = 0;
  scene.meshes[0].front = Colour::UnitX();
  scene.meshes[0].back = Colour::UnitY();
  EXPECT_EQ(draw(scene, front_camera()).at(32, 32), (Pixel{255, 0, 0}));
  scene.meshes[0].triangles.row(1).swap(scene.meshes[0].triangles.row(2));
  EXPECT_EQ(draw(scene, front_camera()).at(32, 32), (Pixel{0, 255, 0}));
}

TEST(Light, FromBehindLeavesASurfaceDark) {
  RenderScene scene = facing_square();
  scene.ambient = 0;
  scene.light.direction = kY;
  EXPECT_EQ(draw(scene, front_camera()).at(32, 32), (Pixel{0, 0, 0}));
}

TEST(Light, ComesFromAboveAndTheLeftInEveryView) {
  for (const Eigen::Vector3d& forward :
       {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 0, -1),
        Eigen::Vector3d(-0.5, 1, -0.5)}) {
    const Eigen::Vector3d light = light_for_view(forward).direction.normalized();
    Camera camera{-forward, Eigen::Vector3d::Zero()};
    if (forward.z() == -1) camera.up = kY;
    EXPECT_GT(light.z(), 0.5);
    EXPECT_LT(light.dot(camera_axes(camera).col(0)), -0.1);
  }
}

TEST(Field, IsShownByTheColoursOfItsScale) {
  RenderScene scene = facing_square();
  scene.ambient = 0;
  scene.meshes[0].field = VertexField{Eigen::Vector4d(0, 1, 1, 0), {ColourMap::viridis, 0, 1}};
  const Image image = draw(scene, front_camera());
  // Column 24 begins a quarter along the square; its middle is half a pixel of 32 further.
  const Pixel expected = encode_srgb(map_colour(ColourMap::viridis, 8.5 / 32));
  for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(image.at(24, 32)[k], expected[k], 2);
}

TEST(Field, WithoutValueIsGrey) {
  RenderScene scene = facing_square();
  scene.meshes[0].field = VertexField{Eigen::Vector4d::Constant(std::nan("")), {}};
  const Pixel pixel = draw(scene, front_camera()).at(32, 32);
  EXPECT_EQ(pixel[0], pixel[1]);
  EXPECT_EQ(pixel[1], pixel[2]);
}

TEST(Ground, HidesWhatIsBelowItFromAboveOnly) {
  RenderScene scene;
  scene.meshes.push_back(rectangle({-0.2, -0.2, -0.3}, 0.4 * kX, 0.4 * kY));
  scene.ground = 0;
  EXPECT_TRUE(is_background(draw(scene, top_camera()).at(32, 32)));
  scene.meshes[0].positions.row(2).setConstant(0.3);
  Camera from_below = top_camera();
  from_below.position.z() = -2;
  const Image with_ground = draw(scene, from_below);
  scene.ground.reset();
  EXPECT_EQ(with_ground.pixels(), draw(scene, from_below).pixels());
}

TEST(MeshLines, AreOnePixelWideAlongTheEdges) {
  RenderScene scene = facing_square();
  const int plain = brightness(draw(scene, front_camera()).at(32, 32));
  scene.meshes[0].edges = true;
  const Image image = draw(scene, front_camera());
  EXPECT_LT(brightness(image.at(16, 24)), plain - 60);  // the left side
  EXPECT_LT(brightness(image.at(32, 31)), plain - 60);  // the diagonal
  EXPECT_EQ(brightness(image.at(20, 24)), plain);
  EXPECT_EQ(brightness(image.at(40, 40)), plain);
}

TEST(Picture, OfNothingIsBackground) {
  const Image image = draw({}, front_camera(), {8, 8});
  for (const Pixel& pixel : image.pixels()) EXPECT_TRUE(is_background(pixel));
}

TEST(Picture, IsGivenUpWhenAskedToStop) {
  StopFlag flag;
  flag.request();
  RunContext run;
  run.stop = flag.token();
  EXPECT_THROW(render(facing_square(), front_camera(), {64, 64}, {}, run), Interrupted);
}

}  // namespace
}  // namespace pliant
