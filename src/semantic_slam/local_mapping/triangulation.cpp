#include "semantic_slam/local_mapping/triangulation.h"

#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "semantic_slam/features/matching.h"
#include "semantic_slam/local_mapping/point_fusion.h"

namespace semantic_slam {
namespace {

constexpr int kMaxDistance = 50;
constexpr double kMaxRatio = 0.8;
// Squared normalised distance from an epipolar line that 5 % of good matches exceed (chi-square, 1
// degree of freedom).
constexpr double kChi2Line = 3.841;
// The pyramid's levels tell distances to a level and a half.
constexpr double kLevelsOff = 1.5;
constexpr double kRadPerDeg = 3.14159265358979 / 180.0;

// A keyframe that takes part, and its features that may become points.
struct View {
  const Keyframe& keyframe;
  std::vector<int> free;

  const Feature& feature(int i) const { return (*keyframe.features)[i]; }
};

View ViewOf(const Keyframe& keyframe) {
  View view{keyframe, {}};
  for (std::size_t i = 0; i < keyframe.points.size(); ++i) {
    if (keyframe.points[i] == kNoPoint && !keyframe.LeavesOut(i)) {
      view.free.push_back(static_cast<int>(i));
    }
  }
  return view;
}

Eigen::Vector3d RayOf(const Feature& feature, const CameraModel& camera) {
  return camera.Unproject(feature.pixel.x(), feature.pixel.y(), 1.0);
}

// The line on which the second image must show what the first shows at that ray, as a x + b y + c
// on the plane at 1 m, (a, b) of unit length. None if the ray goes through the second camera.
std::optional<Eigen::Vector3d> EpipolarLine(const Eigen::Vector3d& ray_a, const Rigid3d& T_b_a) {
  const Eigen::Vector3d line = T_b_a.translation().cross(T_b_a.linear() * ray_a);
  const double norm = line.head<2>().norm();
  if (norm < 1e-9) return std::nullopt;
  return line / norm;
}

// The free feature of `b` on the line that looks most like one of `a`; -1 if none does, or two do.
int FindOnLine(const View& a, int feature_a, const Eigen::Vector3d& line, const View& b,
               const std::vector<bool>& is_taken, const CameraModel& camera,
               const ObservationNoise& noise, const Map& map) {
  const Descriptor& wanted = a.keyframe.features->descriptor(feature_a);
  int best = -1, distance = kMaxDescriptorDistance + 1, second = kMaxDescriptorDistance + 1;
  for (const int i : b.free) {
    if (is_taken[i]) continue;
    const Feature& feature = b.feature(i);
    const double off_px = line.dot(RayOf(feature, camera)) * camera.intrinsics().fx_px;
    const double sigma_px = noise.PixelSigma(map.scales()[feature.octave]);
    if (off_px * off_px > kChi2Line * sigma_px * sigma_px) continue;
    const int d = HammingDistance(wanted, b.keyframe.features->descriptor(i));
    if (d < distance) {
      second = std::exchange(distance, d);
      best = i;
    } else if (d < second) {
      second = d;
    }
  }
  return distance <= kMaxDistance && distance <= kMaxRatio * second ? best : -1;
}

// Where two rays are nearest to each other, in the frame of the first, halfway between. None if
// they are too parallel.
std::optional<Eigen::Vector3d> Meet(const Eigen::Vector3d& ray_a, const Eigen::Vector3d& ray_b,
                                    const Rigid3d& T_a_b, double min_parallax_rad) {
  const Eigen::Vector3d a = ray_a.normalized();
  const Eigen::Vector3d b = (T_a_b.linear() * ray_b).normalized();
  const double parallax_sine = a.cross(b).norm();
  if (a.dot(b) <= 0.0 || parallax_sine < std::sin(min_parallax_rad)) return std::nullopt;
  const Eigen::Vector3d& t = T_a_b.translation();
  const double cosine = a.dot(b), squared = parallax_sine * parallax_sine;
  const double along_a = (t.dot(a) - cosine * t.dot(b)) / squared;
  const double along_b = (cosine * t.dot(a) - t.dot(b)) / squared;
  return 0.5 * (along_a * a + t + along_b * b);
}

// Whether a feature shows what is there.
bool Shows(const Feature& feature, const Eigen::Vector3d& p_camera, const CameraModel& camera,
           const ObservationNoise& noise, const Map& map) {
  return p_camera.z() > 0.0 &&
         ShowsPoint(feature, p_camera, map.scales()[feature.octave], kChi2Depth, camera, noise);
}

// Whether the levels on which the features were found agree with how far away the point is.
bool LevelsFit(const Feature& a, double distance_a_m, const Feature& b, double distance_b_m,
               const Map& map) {
  const std::vector<float>& scales = map.scales();
  const double step = scales.size() > 1 ? scales[1] / scales[0] : 1.0;
  const double off = std::abs(std::log(distance_a_m * scales[b.octave]) -
                              std::log(distance_b_m * scales[a.octave]));
  return off <= kLevelsOff * std::log(step) + 1e-6;
}

struct Pair {
  int a, b;
  Eigen::Vector3d p_map;
};

// The free feature that shows what is there and looks like that; -1 if there is none.
int FindThere(const Keyframe& keyframe, const Eigen::Vector3d& p_map, const Descriptor& wanted,
              const CameraModel& camera, const ObservationNoise& noise, const Map& map) {
  const Eigen::Vector3d p = keyframe.T_map_camera.inverse() * p_map;
  if (p.z() <= 0.0) return -1;
  const auto radius_px =
      static_cast<float>(std::sqrt(kChi2Pixel) * noise.PixelSigma(map.scales().back()));
  int best = -1, distance = kMaxDistance + 1;
  const auto levels = static_cast<int>(map.scales().size());
  keyframe.features->ForEachNear(camera.Project(p).cast<float>(), radius_px, 0, levels, [&](int i) {
    const int d = HammingDistance(wanted, keyframe.features->descriptor(i));
    if (d >= distance || keyframe.points[i] != kNoPoint || keyframe.LeavesOut(i)) return;
    if (!Shows((*keyframe.features)[i], p, camera, noise, map)) return;
    best = i;
    distance = d;
  });
  return best;
}

std::vector<Pair> FindPairs(const View& a, const View& b, const TriangulationOptions& options,
                            const CameraModel& camera, const ObservationNoise& noise,
                            const Map& map) {
  const Rigid3d T_b_a = b.keyframe.T_map_camera.inverse() * a.keyframe.T_map_camera;
  std::vector<bool> is_taken(b.keyframe.points.size(), false);
  std::vector<Pair> pairs;
  RotationConsistency rotation;
  for (const int i : a.free) {
    const Eigen::Vector3d ray = RayOf(a.feature(i), camera);
    const auto line = EpipolarLine(ray, T_b_a);
    if (!line) continue;
    const int k = FindOnLine(a, i, *line, b, is_taken, camera, noise, map);
    if (k < 0) continue;
    const auto p_a = Meet(ray, RayOf(b.feature(k), camera), T_b_a.inverse(),
                          options.min_parallax_deg * kRadPerDeg);
    if (!p_a) continue;
    const Eigen::Vector3d p_b = T_b_a * *p_a;
    if (!Shows(a.feature(i), *p_a, camera, noise, map) ||
        !Shows(b.feature(k), p_b, camera, noise, map) ||
        !LevelsFit(a.feature(i), p_a->norm(), b.feature(k), p_b.norm(), map)) {
      continue;
    }
    is_taken[k] = true;
    rotation.Add(a.feature(i).angle_rad, b.feature(k).angle_rad);
    pairs.push_back({i, k, a.keyframe.T_map_camera * *p_a});
  }
  const std::vector<bool> is_consistent = rotation.Consistent();
  std::vector<Pair> kept;
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    if (is_consistent[n]) kept.push_back(pairs[n]);
  }
  return kept;
}

struct Witness {
  KeyframeId keyframe;
  int feature;
};

// Those of the keyframes, but for one, that show the point too.
std::vector<Witness> FindWitnesses(const std::vector<KeyframeId>& keyframes, KeyframeId but,
                                   const Eigen::Vector3d& p_map, const Descriptor& descriptor,
                                   const CameraModel& camera, const ObservationNoise& noise,
                                   const Map& map) {
  std::vector<Witness> witnesses;
  for (const KeyframeId id : keyframes) {
    if (id == but) continue;
    const int i = FindThere(*map.FindKeyframe(id), p_map, descriptor, camera, noise, map);
    if (i >= 0) witnesses.push_back({id, i});
  }
  return witnesses;
}

}  // namespace

int TriangulateWithNeighbours(KeyframeId keyframe_id, const TriangulationOptions& options,
                              const CameraModel& camera, const ObservationNoise& noise, Map& map) {
  const std::vector<KeyframeId> neighbours = map.BestCovisible(keyframe_id, options.neighbours);
  const Keyframe& keyframe = *map.FindKeyframe(keyframe_id);
  int made = 0;
  for (const KeyframeId neighbour : neighbours) {
    const View a = ViewOf(keyframe), b = ViewOf(*map.FindKeyframe(neighbour));
    for (const Pair& pair : FindPairs(a, b, options, camera, noise, map)) {
      const auto witnesses =
          FindWitnesses(neighbours, neighbour, pair.p_map, keyframe.features->descriptor(pair.a),
                        camera, noise, map);
      if (witnesses.empty()) continue;
      const PointId id = map.AddPoint(pair.p_map, keyframe_id, pair.a).id;
      map.AddObservation(id, neighbour, pair.b);
      for (const Witness& witness : witnesses) {
        map.AddObservation(id, witness.keyframe, witness.feature);
      }
      map.UpdatePointAppearance(id);
      map.UpdatePointGeometry(id);
      ++made;
    }
  }
  return made;
}

}  // namespace semantic_slam
