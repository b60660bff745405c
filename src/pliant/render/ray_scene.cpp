#include "pliant/render/ray_scene.h"

#include <limits>
#include <new>
#include <stdexcept>

#include <Eigen/Geometry>
#include <embree3/rtcore.h>

namespace pliant {
namespace {

/// Embree keeps an error until it is asked for.
void throw_error_of(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error("Embree cannot cast rays on this machine (error " +
                           std::to_string(error) + ")");
}

/// Copies columns of three into a buffer that Embree owns.
template <typename Columns>
void fill_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                 const Columns& columns) {
  using Scalar = typename Columns::Scalar;
  auto* data = static_cast<Scalar*>(rtcSetNewGeometryBuffer(
      geometry, type, 0, format, 3 * sizeof(Scalar), static_cast<size_t>(columns.cols())));
  if (data == nullptr) throw std::bad_alloc();
  Eigen::Map<Eigen::Matrix<Scalar, 3, Eigen::Dynamic>>(data, 3, columns.cols()) = columns;
}

RTCRay embree_ray(const Ray& ray, float distance) {
  RTCRay result{};
  result.org_x = ray.origin.x();
  result.org_y = ray.origin.y();
  result.org_z = ray.origin.z();
  result.dir_x = ray.direction.x();
  result.dir_y = ray.direction.y();
  result.dir_z = ray.direction.z();
  result.tfar = distance;
  result.mask = ~0U;
  return result;
}

}  // namespace

void RayScene::Release::operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
void RayScene::Release::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }

// With one building thread the tree does not depend on how threads take turns, and so neither does
// the triangle that a ray through a shared edge is said to meet.
RayScene::RayScene() : device_(rtcNewDevice("threads=1,set_affinity=0")) {
  throw_error_of(device_.get());
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);  // no ray slips through a shared edge
}

RayScene::~RayScene() = default;

void RayScene::add(const Eigen::Matrix3Xf& positions, const Eigen::Matrix3Xi& triangles) {
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  fill_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions);
  fill_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles.cast<unsigned>().eval());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_.get(), geometry);  // numbers are given from 0 up
  rtcReleaseGeometry(geometry);
}

void RayScene::build() {
  rtcCommitScene(scene_.get());
  throw_error_of(device_.get());
}

std::optional<RayHit> RayScene::first_hit(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit query{};
  query.ray = embree_ray(ray, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  RayHit hit;
  hit.mesh = static_cast<int>(query.hit.geomID);
  hit.triangle = static_cast<int>(query.hit.primID);
  hit.barycentric = {1 - query.hit.u - query.hit.v, query.hit.u, query.hit.v};
  hit.normal = Eigen::Vector3f(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z).normalized();
  hit.front = hit.normal.dot(ray.direction) < 0;
  if (!hit.front) hit.normal = -hit.normal;
  hit.distance = query.ray.tfar;
  return hit;
}

bool RayScene::occluded(const Ray& ray, float distance) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query = embree_ray(ray, distance);
  rtcOccluded1(scene_.get(), &context, &query);
  return query.tfar < 0;  // Embree's sign for "something is in the way"
}

}  // namespace pliant
