#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace pliant {

struct Ray {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;  ///< unit length
};

/// Where a ray meets a triangle first.
struct RayHit {
  int mesh = 0;
  int triangle = 0;
  Eigen::Vector3f barycentric;  ///< weights of the triangle's corners
  Eigen::Vector3f normal;       ///< of the flat triangle, unit length, towards the ray's origin
  float distance = 0;
  bool front =
      true;  ///< whether the triangle's corners run counter-clockwise as seen along the ray
};

/// Triangle meshes that rays are cast against (Embree). Safe to use from several threads.
class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Adds a mesh; the number of meshes before it is its number in hits.
  void add(const Eigen::Matrix3Xf& positions, const Eigen::Matrix3Xi& triangles);
  /// Makes the meshes added so far ready for rays. The same meshes give the same answers, bit for
  /// bit, on one machine.
  void build();

  std::optional<RayHit> first_hit(const Ray& ray) const;
  /// Whether anything is met before `distance`.
  bool occluded(const Ray& ray, float distance) const;

 private:
  struct Release {
    void operator()(RTCDeviceTy* device) const;
    void operator()(RTCSceneTy* scene) const;
  };

  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

}  // namespace pliant
