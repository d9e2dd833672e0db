#include "semantic_slam/map/map_encoding.h"

#include <cmath>
#include <memory>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/map/byte_stream.h"
#include "semantic_slam/map/map_check.h"

namespace semantic_slam {
namespace {

constexpr std::size_t kDescriptorBytes = 32;
constexpr std::size_t kFeatureBytes = 3 * 8 + 2 * 4 + 1 + 3 + kDescriptorBytes + 8;
constexpr std::size_t kPoseBytes = 12 * 8;
constexpr std::size_t kMaxLevels = 255;  // an octave is one byte
// Beyond every image, undistorted or not.
constexpr float kMaxPixel = 1e6f;

void Put(const Rigid3d& T, ByteWriter& out) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) out.Put(T.matrix()(row, column));
  }
}

Rigid3d GetPose(ByteReader& in) {
  Rigid3d T = Rigid3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) T.matrix()(row, column) = in.Get<double>();
  }
  return T;
}

template <typename Vector>
void PutVector(const Vector& v, ByteWriter& out) {
  for (Eigen::Index i = 0; i < v.size(); ++i) out.Put(v[i]);
}

template <typename Vector>
Vector GetVector(ByteReader& in) {
  Vector v;
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = in.Get<typename Vector::Scalar>();
  return v;
}

template <typename Array>
void PutArray(const Array& array, ByteWriter& out) {
  for (const auto& element : array) out.Put(element);
}

template <typename Array>
Array GetArray(ByteReader& in) {
  Array array;
  for (auto& element : array) element = in.Get<typename Array::value_type>();
  return array;
}

void Put(const CameraIntrinsics& c, ByteWriter& out) {
  out.Put<std::int32_t>(c.width_px);
  out.Put<std::int32_t>(c.height_px);
  for (const double value : {c.fx_px, c.fy_px, c.cx_px, c.cy_px, c.readout_s}) out.Put(value);
  out.Put<std::uint64_t>(c.distortion.size());
  PutArray(c.distortion, out);
}

CameraIntrinsics GetCamera(ByteReader& in) {
  CameraIntrinsics c;
  c.width_px = in.Get<std::int32_t>();
  c.height_px = in.Get<std::int32_t>();
  for (double* value : {&c.fx_px, &c.fy_px, &c.cx_px, &c.cy_px, &c.readout_s}) {
    *value = in.Get<double>();
  }
  c.distortion.resize(in.GetCount(sizeof(double)));
  for (double& k : c.distortion) k = in.Get<double>();
  return c;
}

CameraModel ModelOf(const CameraIntrinsics& camera) {
  try {
    return CameraModel(camera);
  } catch (const ConfigError& e) {
    throw InputError(e.what());
  }
}

std::vector<float> GetScales(ByteReader& in) {
  std::vector<float> scales(in.GetCount(sizeof(float)));
  for (float& scale : scales) scale = in.Get<float>();
  bool is_sound = !scales.empty() && scales.size() <= kMaxLevels;
  for (const float scale : scales) is_sound = is_sound && scale >= 1.0f && scale < 1e6f;
  if (!is_sound) throw InputError("its pyramid is none");
  return scales;
}

void Put(const Feature& feature, ByteWriter& out) {
  PutVector(feature.raw, out);
  PutVector(feature.exposed, out);
  PutVector(feature.pixel, out);
  out.Put(feature.depth_m);
  out.Put(feature.angle_rad);
  out.Put(static_cast<std::uint8_t>(feature.octave));
  PutArray(feature.rgb, out);
}

Feature GetFeature(std::size_t levels, ByteReader& in) {
  Feature feature;
  feature.raw = GetVector<Eigen::Vector2f>(in);
  feature.exposed = GetVector<Eigen::Vector2f>(in);
  feature.pixel = GetVector<Eigen::Vector2f>(in);
  feature.depth_m = in.Get<float>();
  feature.angle_rad = in.Get<float>();
  feature.octave = in.Get<std::uint8_t>();
  feature.rgb = GetArray<std::array<std::uint8_t, 3>>(in);
  bool is_sound = static_cast<std::size_t>(feature.octave) < levels &&
                  std::isfinite(feature.angle_rad) && !std::isinf(feature.depth_m);
  for (const Eigen::Vector2f& pixel : {feature.raw, feature.exposed, feature.pixel}) {
    is_sound = is_sound && pixel.allFinite() && pixel.cwiseAbs().maxCoeff() < kMaxPixel;
  }
  if (!is_sound) throw InputError("it has a feature that cannot be");
  return feature;
}

void Put(const Keyframe& keyframe, ByteWriter& out) {
  out.Put<std::int64_t>(keyframe.id);
  out.Put<std::int32_t>(keyframe.map_id);
  out.Put<std::int64_t>(keyframe.features->stamp().ns);
  Put(keyframe.T_map_camera, out);
  out.Put<std::int64_t>(keyframe.parent);
  out.Put<std::uint8_t>(keyframe.is_joint);
  out.Put<std::uint64_t>(keyframe.features->size());
  for (std::size_t i = 0; i < keyframe.features->size(); ++i) {
    Put((*keyframe.features)[i], out);
    PutArray(keyframe.features->descriptor(i), out);
    out.Put<std::int64_t>(keyframe.points[i]);
  }
}

Keyframe GetKeyframe(const CameraModel& camera, std::size_t levels, ByteReader& in) {
  Keyframe keyframe;
  keyframe.id = in.Get<std::int64_t>();
  keyframe.map_id = in.Get<std::int32_t>();
  const Stamp stamp{in.Get<std::int64_t>()};
  keyframe.T_map_camera = GetPose(in);
  keyframe.parent = in.Get<std::int64_t>();
  keyframe.is_joint = in.Get<std::uint8_t>() != 0;
  const std::size_t count = in.GetCount(kFeatureBytes);
  std::vector<Feature> features;
  std::vector<Descriptor> descriptors;
  features.reserve(count);
  descriptors.reserve(count);
  keyframe.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    features.push_back(GetFeature(levels, in));
    descriptors.push_back(GetArray<Descriptor>(in));
    keyframe.points.push_back(in.Get<std::int64_t>());
  }
  keyframe.features = std::make_shared<const FrameFeatures>(stamp, std::move(features),
                                                            std::move(descriptors), camera);
  return keyframe;
}

void Put(const CulledKeyframe& culled, ByteWriter& out) {
  out.Put<std::int64_t>(culled.id);
  out.Put<std::int32_t>(culled.map_id);
  out.Put<std::int64_t>(culled.stamp.ns);
  out.Put<std::int64_t>(culled.parent);
  Put(culled.T_parent_keyframe, out);
}

CulledKeyframe GetCulled(ByteReader& in) {
  CulledKeyframe culled;
  culled.id = in.Get<std::int64_t>();
  culled.map_id = in.Get<std::int32_t>();
  culled.stamp.ns = in.Get<std::int64_t>();
  culled.parent = in.Get<std::int64_t>();
  culled.T_parent_keyframe = GetPose(in);
  return culled;
}

void Put(const MapPoint& point, ByteWriter& out) {
  out.Put<std::int32_t>(point.map_id);
  PutVector(point.position, out);
  PutVector(point.view_direction, out);
  out.Put(point.min_distance_m);
  out.Put(point.max_distance_m);
  PutArray(point.descriptor, out);
  PutArray(point.rgb, out);
  out.Put<std::int64_t>(point.reference);
  out.Put<std::int32_t>(point.visible);
  out.Put<std::int32_t>(point.found);
}

MapPoint GetPoint(PointId id, ByteReader& in) {
  MapPoint point;
  point.id = id;
  point.map_id = in.Get<std::int32_t>();
  point.position = GetVector<Eigen::Vector3d>(in);
  point.view_direction = GetVector<Eigen::Vector3d>(in);
  point.min_distance_m = in.Get<double>();
  point.max_distance_m = in.Get<double>();
  point.descriptor = GetArray<Descriptor>(in);
  point.rgb = GetArray<std::array<std::uint8_t, 3>>(in);
  point.reference = in.Get<std::int64_t>();
  point.visible = in.Get<std::int32_t>();
  point.found = in.Get<std::int32_t>();
  return point;
}

void Put(const LoopEdge& edge, ByteWriter& out) {
  out.Put<std::int64_t>(edge.a);
  out.Put<std::int64_t>(edge.b);
  Put(edge.T_a_b, out);
}

LoopEdge GetLoopEdge(ByteReader& in) {
  LoopEdge edge{};
  edge.a = in.Get<std::int64_t>();
  edge.b = in.Get<std::int64_t>();
  edge.T_a_b = GetPose(in);
  return edge;
}

template <typename T>
void PutAll(const std::vector<T>& things, ByteWriter& out) {
  out.Put<std::uint64_t>(things.size());
  for (const T& thing : things) Put(thing, out);
}

// Calls get(index) for each of the things that follow, of at least `min_bytes` each.
template <typename Get>
auto GetAll(std::size_t min_bytes, ByteReader& in, Get&& get) {
  std::vector<decltype(get(std::size_t{0}))> things;
  const std::size_t count = in.GetCount(min_bytes);
  for (std::size_t i = 0; i < count; ++i) things.push_back(get(i));
  return things;
}

}  // namespace

std::string EncodeMap(const StoredMap& map) {
  ByteWriter out;
  Put(map.camera, out);
  out.Put<std::uint64_t>(map.scales.size());
  PutArray(map.scales, out);
  out.Put<std::int32_t>(map.contents.map_id);
  out.Put<std::int64_t>(map.contents.next_keyframe);
  PutAll(map.contents.keyframes, out);
  PutAll(map.contents.culled, out);
  PutAll(map.contents.points, out);
  PutAll(map.contents.loop_edges, out);
  return out.bytes();
}

StoredMap DecodeMap(std::string_view bytes) {
  ByteReader in(bytes);
  StoredMap map;
  map.camera = GetCamera(in);
  const CameraModel camera = ModelOf(map.camera);
  map.scales = GetScales(in);
  const std::size_t levels = map.scales.size();
  map.contents.map_id = in.Get<std::int32_t>();
  map.contents.next_keyframe = in.Get<std::int64_t>();
  map.contents.keyframes =
      GetAll(kPoseBytes, in, [&](std::size_t) { return GetKeyframe(camera, levels, in); });
  map.contents.culled = GetAll(kPoseBytes, in, [&](std::size_t) { return GetCulled(in); });
  map.contents.points = GetAll(
      kDescriptorBytes, in, [&](std::size_t i) { return GetPoint(static_cast<PointId>(i), in); });
  map.contents.loop_edges = GetAll(kPoseBytes, in, [&](std::size_t) { return GetLoopEdge(in); });
  if (in.remaining() > 0) throw InputError("it has bytes that belong to nothing");
  CheckMapContents(map.contents);
  return map;
}

}  // namespace semantic_slam
