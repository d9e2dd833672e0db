#pragma once

#include <limits>
#include <vector>

#include <embree3/rtcore.h>
#include <Eigen/Core>

namespace semantic_slam {

constexpr int kRaysPerPacket = 16;

// Which geometries a ray may meet: bits.
enum RayMask : unsigned { kOpaque = 1, kShining = 2, kAnySurface = kOpaque | kShining };

// Rays that are traced together; those that start at one place and go similar ways are fast. A ray
// is `origin + t * direction` with t from 0; lanes that are not set are not traced.
class RayPacket {
 public:
  static constexpr unsigned kMiss = RTC_INVALID_GEOMETRY_ID;

  void Clear();
  void Set(int lane, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
           float longest = std::numeric_limits<float>::infinity(), unsigned mask = kAnySurface);
  void Unset(int lane) { valid_[lane] = 0; }

  bool IsSet(int lane) const { return valid_[lane] != 0; }
  bool IsHit(int lane) const { return rays_.hit.geomID[lane] != kMiss; }
  unsigned Geometry(int lane) const { return rays_.hit.geomID[lane]; }
  unsigned Triangle(int lane) const { return rays_.hit.primID[lane]; }
  float Distance(int lane) const { return rays_.ray.tfar[lane]; }  // t of the hit
  // Weights of the triangle's second and third corner at the hit.
  Eigen::Vector2f Barycentric(int lane) const { return {rays_.hit.u[lane], rays_.hit.v[lane]}; }
  bool IsOccluded(int lane) const { return rays_.ray.tfar[lane] < 0.0f; }

 private:
  friend class RayScene;

  RTCRayHit16 rays_;
  alignas(64) int valid_[kRaysPerPacket];
};

// Triangles that rays may meet, by Embree. Rays may be traced from any number of threads, while
// nothing is changed.
class RayScene {
 public:
  enum class Lifetime { kStill, kChanging };  // quick to trace, or quick to rebuild

  explicit RayScene(Lifetime lifetime);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  // Replaces the geometry `id`. Takes effect with Commit().
  void SetTriangles(unsigned id, const std::vector<Eigen::Vector3f>& positions_m,
                    const std::vector<Eigen::Vector3i>& triangles, RayMask mask);
  void Commit();

  // Finds the nearest hit of each ray; keeps one found in another scene before if it is nearer.
  // `coherent`: the rays go similar ways.
  void FindHits(RayPacket& packet, bool coherent) const;

  // Finds whether anything is in a ray's way.
  void FindOccluded(RayPacket& packet) const;

  // Whether anything opaque is in the way of one ray before t = `longest`.
  bool IsOccluded(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                  float longest) const;

 private:
  RTCDevice device_;
  RTCScene scene_;
  const Lifetime lifetime_;
  std::vector<unsigned> geometries_;
};

}  // namespace semantic_slam
