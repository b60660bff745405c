#include "pliant/capture/camera_model.h"

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

CameraModel wide_camera() {
  CameraModel camera;
  camera.intrinsics << 950, 960, 630, 520, -0.28, 0.09, 0.0012, -0.0008, -0.01;
  camera.pose = {{0.2, -0.4, 0.1}, {0.05, -0.02, 0.6}};
  camera.columns = 1280;
  camera.rows = 1024;
  return camera;
}

Eigen::Vector3d random_point(RandomStream& random) {
  return {random.uniform(-0.15, 0.15), random.uniform(-0.15, 0.15), random.uniform(-0.1, 0.1)};
}

TEST(CameraModel, RayOfAPixelPassesThroughWhatItShows) {
  const CameraModel camera = wide_camera();
  RandomStream random(1);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d point = random_point(random);
    const auto pixel = camera.project(point);
    ASSERT_TRUE(pixel);
    const auto ray = camera.ray(*pixel);
    ASSERT_TRUE(ray);
    EXPECT_LT((point - ray->from).cross(ray->direction).norm(), 1e-11);
    EXPECT_GT((point - ray->from).dot(ray->direction), 0);
  }
}

TEST(CameraModel, DerivativesAreThoseOfDifferences) {
  const CameraModel camera = wide_camera();
  RandomStream random(2);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d point = random_point(random);
    const auto projection = camera.project_with_derivatives(point);
    ASSERT_TRUE(projection);
    EXPECT_LT((projection->pixel - *camera.project(point)).norm(), 1e-9);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
      const Eigen::Vector2d expected =
          (*camera.project(point + step) - *camera.project(point - step)) / (2 * kStep);
      EXPECT_LT((projection->by_point.col(axis) - expected).norm(), 1e-4);  // of 1600 px/m
    }
    for (int k = 0; k < kIntrinsics; ++k) {
      CameraModel more = camera, less = camera;
      more.intrinsics(k) += kStep;
      less.intrinsics(k) -= kStep;
      const Eigen::Vector2d expected = (*more.project(point) - *less.project(point)) / (2 * kStep);
      EXPECT_LT((projection->by_intrinsics.col(k) - expected).norm(), 1e-5) << kIntrinsicNames[k];
    }
  }
}

TEST(CameraModel, SeesNothingBehindItselfOrBeyondTheFold) {
  CameraModel camera = wide_camera();
  camera.pose = {};
  EXPECT_FALSE(camera.project({0, 0, -1}));
  camera.intrinsics.tail<5>() << -0.3, 0, 0, 0, 0;  // folds at a radius of 1.05
  EXPECT_TRUE(camera.project({1.0, 0, 1}));
  EXPECT_FALSE(camera.project({1.2, 0, 1}));
  EXPECT_FALSE(camera.straight({camera.intrinsics(2) + 0.75 * camera.intrinsics(0), 520}));
}

TEST(RigidMotion, TurnsAsItsMatrixDoes) {
  RandomStream random(3);
  for (const double size : {0.0, 1e-9, 1e-3, 1.0, 3.1}) {
    const Eigen::Vector3d rotation = size * random_point(random).normalized();
    const Eigen::Vector3d point = random_point(random);
    const RigidMotion motion{rotation, {1, 2, 3}};
    EXPECT_LT((turned(rotation.data(), point) + motion.translation - motion * point).norm(), 1e-14);
    EXPECT_LT((motion.inverse() * (motion * point) - point).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace pliant
