#include "semantic_slam/simulation/ray_scene.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace semantic_slam {

void RayPacket::Clear() {
  std::fill(std::begin(valid_), std::end(valid_), 0);
  std::fill(std::begin(rays_.hit.geomID), std::end(rays_.hit.geomID), kMiss);
}

void RayPacket::Set(int lane, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                    float longest, unsigned mask) {
  RTCRay16& ray = rays_.ray;
  ray.org_x[lane] = origin.x();
  ray.org_y[lane] = origin.y();
  ray.org_z[lane] = origin.z();
  ray.dir_x[lane] = direction.x();
  ray.dir_y[lane] = direction.y();
  ray.dir_z[lane] = direction.z();
  ray.tnear[lane] = 0.0f;
  ray.tfar[lane] = longest;
  ray.time[lane] = 0.0f;
  ray.mask[lane] = mask;
  ray.flags[lane] = 0;
  rays_.hit.geomID[lane] = kMiss;
  rays_.hit.instID[0][lane] = kMiss;
  valid_[lane] = -1;
}

RayScene::RayScene(Lifetime lifetime)
    : device_(rtcNewDevice(nullptr)), scene_(nullptr), lifetime_(lifetime) {
  if (device_ == nullptr) throw std::runtime_error("Embree cannot use this processor");
  scene_ = rtcNewScene(device_);
  const bool still = lifetime == Lifetime::kStill;
  // Robust: no ray slips through between two triangles.
  rtcSetSceneFlags(scene_,
                   still ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC);
  rtcSetSceneBuildQuality(scene_, still ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_LOW);
  rtcCommitScene(scene_);
}

RayScene::~RayScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void RayScene::SetTriangles(unsigned id, const std::vector<Eigen::Vector3f>& positions_m,
                            const std::vector<Eigen::Vector3i>& triangles, RayMask mask) {
  const auto known = std::find(geometries_.begin(), geometries_.end(), id);
  if (known != geometries_.end()) {
    rtcDetachGeometry(scene_, id);
    geometries_.erase(known);
  }
  if (triangles.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* const corners =
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(Eigen::Vector3f), positions_m.size());
  std::memcpy(corners, positions_m.data(), positions_m.size() * sizeof(Eigen::Vector3f));
  void* const indices =
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              sizeof(Eigen::Vector3i), triangles.size());
  std::memcpy(indices, triangles.data(), triangles.size() * sizeof(Eigen::Vector3i));
  rtcSetGeometryMask(geometry, mask);
  if (lifetime_ == Lifetime::kChanging) {
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_LOW);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_, geometry, id);
  rtcReleaseGeometry(geometry);
  geometries_.push_back(id);
}

void RayScene::Commit() {
  rtcCommitScene(scene_);
}

void RayScene::FindHits(RayPacket& packet, bool coherent) const {
  if (geometries_.empty()) return;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(packet.valid_, scene_, &context, &packet.rays_);
}

void RayScene::FindOccluded(RayPacket& packet) const {
  if (geometries_.empty()) return;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded16(packet.valid_, scene_, &context, &packet.rays_.ray);
}

bool RayScene::IsOccluded(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                          float longest) const {
  if (geometries_.empty()) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{
      origin.x(), origin.y(), origin.z(), 0.0f, direction.x(), direction.y(), direction.z(), 0.0f,
      longest,    kOpaque,    0,          0};
  rtcOccluded1(scene_, &context, &ray);
  return ray.tfar < 0.0f;
}

}  // namespace semantic_slam
