#include "testing/textured_room.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/random_stream.h"

namespace semantic_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kNearestM = 0.45f;
constexpr float kFarthestM = 7.0f;
constexpr float kGrazingCosine = 0.12f;
// Khoshelham and Elberink, Sensors 2012, eq. (11): a Kinect's depth error is 1.425e-3 z^2 [m].
constexpr float kDepthNoisePerM2 = 1.425e-3f;
constexpr float kColourNoise = 2.0f;
constexpr double kRoomTexelM = 0.003;
constexpr double kBoxTexelM = 0.0015;

// Mean 0, standard deviation 1: the sum of four uniform numbers is near enough to a normal one.
float Normal(std::uint64_t bits) {
  const auto sum = static_cast<float>((bits & 0xFFFF) + (bits >> 16 & 0xFFFF) +
                                      (bits >> 32 & 0xFFFF) + (bits >> 48));
  return (sum / 65536.0f - 2.0f) * 1.7320508f;
}

// How bright a surface is, by its normal in the world: lamps at the ceiling, a window at +y.
float Brightness(const Eigen::Vector3d& normal_world) {
  const Eigen::Vector3d light = Eigen::Vector3d(0.25, 0.35, 0.9).normalized();
  return static_cast<float>(0.78 + 0.24 * normal_world.dot(light));
}

}  // namespace

CameraConfig Freiburg1Camera() {
  CameraConfig camera;
  camera.intrinsics = {640,
                       480,
                       517.306,
                       516.469,
                       318.643,
                       255.314,
                       {0.262383, -0.953104, -0.005358, 0.002628, 1.163314}};
  camera.R_camera_imu = Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();
  return camera;
}

struct TexturedRoom::View {
  const Box* box = nullptr;
  Eigen::Matrix3f R_box_camera;
  Eigen::Vector3f p_camera_box;  // the camera's place, in the box's axes
  Eigen::Vector2f low, high;     // rays outside these bounds miss the box
  float brightness[6] = {};
  bool is_room = false;
};

struct TexturedRoom::Hit {
  float z_m = std::numeric_limits<float>::infinity();
  const View* view = nullptr;
  int axis = 0;
  bool positive = false;  // face at +half of the axis
  float cosine = 0.0f;    // of the angle between ray and normal
};

namespace {

// Where a ray enters a box (leaves it, for the room); `z_m` is depth, as rays have z = 1. Kay and
// Kajiya, SIGGRAPH 1986: slabs.
struct Slabs {
  float enter = -std::numeric_limits<float>::infinity();
  float leave = std::numeric_limits<float>::infinity();
  int enter_axis = 0, leave_axis = 0;

  Slabs(const Eigen::Vector3f& origin, const Eigen::Vector3f& ray, const Eigen::Vector3f& half) {
    for (int i = 0; i < 3; ++i) {
      const float inverse = 1.0f / ray[i];
      const float a = (-half[i] - origin[i]) * inverse, b = (half[i] - origin[i]) * inverse;
      const float near = std::min(a, b), far = std::max(a, b);
      if (near > enter) enter = near, enter_axis = i;
      if (far < leave) leave = far, leave_axis = i;
    }
  }
};

}  // namespace

TexturedRoom::TexturedRoom(const TexturedRoomOptions& options)
    : options_(options), camera_(options.intrinsics) {
  AddBox({0.0, 0.0, kHeightM / 2}, {kLengthM, kWidthM, kHeightM}, 0.0, FaceStuff::kWallpaper);
  // The desk: a top and four legs.
  AddBox({1.75, 0.0, 0.72}, {0.9, 2.0, 0.05}, 0.0, FaceStuff::kWood);
  for (const double x_m : {1.38, 2.12}) {
    for (const double y_m : {-0.93, 0.93}) {
      AddBox({x_m, y_m, 0.3475}, {0.07, 0.07, 0.695}, 0.0, FaceStuff::kWood);
    }
  }
  // On the desk, whose top is at 0.745 m: two screens, a box, books, a mug.
  AddBox({2.05, 0.45, 1.005}, {0.06, 0.62, 0.40}, 0.15, FaceStuff::kPackaging);
  AddBox({2.02, 0.45, 0.775}, {0.22, 0.28, 0.06}, 0.15, FaceStuff::kPackaging);
  AddBox({2.05, -0.30, 1.005}, {0.06, 0.62, 0.40}, -0.2, FaceStuff::kPackaging);
  AddBox({2.02, -0.30, 0.775}, {0.22, 0.28, 0.06}, -0.2, FaceStuff::kPackaging);
  AddBox({1.62, -0.70, 0.865}, {0.30, 0.24, 0.24}, 0.5, FaceStuff::kPackaging);
  AddBox({1.55, 0.72, 0.770}, {0.24, 0.32, 0.05}, -0.3, FaceStuff::kPackaging);
  AddBox({1.56, 0.71, 0.815}, {0.20, 0.27, 0.04}, 0.2, FaceStuff::kPackaging);
  AddBox({1.48, 0.22, 0.795}, {0.08, 0.08, 0.10}, 0.7, FaceStuff::kPackaging);
  AddBox({1.60, -0.15, 0.757}, {0.16, 0.44, 0.024}, 0.05, FaceStuff::kPackaging);
  // Around it: a chest of drawers, a crate, a chair without a back.
  AddBox({1.9, -1.6, 0.5}, {0.8, 0.5, 1.0}, 0.1, FaceStuff::kWood);
  AddBox({1.6, 1.55, 0.3}, {0.6, 0.6, 0.6}, 0.4, FaceStuff::kPackaging);
  AddBox({0.85, 0.35, 0.23}, {0.42, 0.42, 0.46}, -0.5, FaceStuff::kPackaging);
  AddBox({-2.0, 1.2, 0.9}, {0.5, 1.0, 1.8}, 0.0, FaceStuff::kWood);
}

void TexturedRoom::AddBox(const Eigen::Vector3d& centre_m, const Eigen::Vector3d& size_m,
                          double yaw_rad, FaceStuff stuff) {
  const bool is_room = boxes_.empty();
  Box box;
  box.T_world_box =
      Eigen::Translation3d(centre_m) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
  box.half_m = (0.5 * size_m).cast<float>();
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    // Across and down the picture: vertical faces have z downwards.
    const double across_m = axis == 0 ? size_m.y() : size_m.x();
    const double down_m = axis == 2 ? size_m.y() : size_m.z();
    FaceStuff face_stuff = stuff;
    if (is_room && face == 4) face_stuff = FaceStuff::kParquet;
    if (is_room && face == 5) face_stuff = FaceStuff::kCeiling;
    const std::uint64_t seed = Mixed(options_.seed * 1000 + 6 * boxes_.size() + face);
    box.faces.push_back(
        PaintFace(face_stuff, across_m, down_m, is_room ? kRoomTexelM : kBoxTexelM, seed));
  }
  boxes_.push_back(std::move(box));
}

std::vector<TexturedRoom::View> TexturedRoom::ViewsFrom(const Rigid3d& T_world_camera) const {
  std::vector<View> views;
  for (const Box& box : boxes_) {
    View view;
    const Rigid3d T_box_camera = box.T_world_box.inverse() * T_world_camera;
    view.box = &box;
    view.is_room = &box == &boxes_.front();
    view.R_box_camera = T_box_camera.linear().cast<float>();
    view.p_camera_box = T_box_camera.translation().cast<float>();
    for (int face = 0; face < 6; ++face) {
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      normal[face / 2] = (face % 2 == 0) != view.is_room ? -1.0 : 1.0;
      view.brightness[face] = Brightness(box.T_world_box.linear() * normal);
    }
    const float everywhere = std::numeric_limits<float>::max();
    view.low.setConstant(everywhere);
    view.high.setConstant(-everywhere);
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1,
                                 (corner & 4) ? 1 : -1);
      const Eigen::Vector3d p =
          T_box_camera.inverse() * sign.cwiseProduct(box.half_m.cast<double>());
      if (p.z() < 1e-3) {  // reaches behind the camera: no bounds
        view.low.setConstant(-everywhere);
        view.high.setConstant(everywhere);
        break;
      }
      const Eigen::Vector2f ray = (p.head<2>() / p.z()).cast<float>();
      view.low = view.low.cwiseMin(ray);
      view.high = view.high.cwiseMax(ray);
    }
    views.push_back(view);
  }
  return views;
}

cv::Vec3f TexturedRoom::Shade(const Hit& hit, const Eigen::Vector3f& ray_camera) const {
  const View& view = *hit.view;
  const Eigen::Vector3f& half = view.box->half_m;
  const Eigen::Vector3f ray = view.R_box_camera * ray_camera;
  const Eigen::Vector3f p = view.p_camera_box + hit.z_m * ray;
  // Pictures are not mirrored: across is to the right of who looks at the face, down is down.
  const bool looks_along_axis = hit.positive == view.is_room;
  const int across = hit.axis == 0 ? 1 : 0;
  const int down = hit.axis == 2 ? 1 : 2;
  const bool flip_across = hit.axis == 0 ? looks_along_axis : hit.axis == 1 && !looks_along_axis;
  const bool flip_down = hit.axis != 2 || !looks_along_axis;
  const float x_m = half[across] + (flip_across ? -p[across] : p[across]);
  const float y_m = half[down] + (flip_down ? -p[down] : p[down]);
  // A pixel covers a patch that incidence stretches one way: the geometric mean of its two sides.
  const float footprint_m = hit.z_m / static_cast<float>(camera_.intrinsics().fx_px) /
                            std::sqrt(std::max(hit.cosine, 0.05f));
  const int face = 2 * hit.axis + (hit.positive ? 1 : 0);
  return view.brightness[face] * view.box->faces[face].Sample(x_m, y_m, footprint_m);
}

TexturedRoom::Hit TexturedRoom::Cast(const std::vector<View>& views,
                                     const Eigen::Vector3f& ray_camera) {
  Hit hit;
  for (const View& view : views) {
    if (ray_camera.x() < view.low.x() || ray_camera.x() > view.high.x() ||
        ray_camera.y() < view.low.y() || ray_camera.y() > view.high.y()) {
      continue;
    }
    const Eigen::Vector3f ray = view.R_box_camera * ray_camera;
    const Slabs slabs(view.p_camera_box, ray, view.box->half_m);
    if (view.is_room) {
      hit = {slabs.leave, &view, slabs.leave_axis, ray[slabs.leave_axis] > 0.0f};
    } else if (slabs.enter < slabs.leave && slabs.enter > 0.0f && slabs.enter < hit.z_m) {
      hit = {slabs.enter, &view, slabs.enter_axis, ray[slabs.enter_axis] < 0.0f};
    }
  }
  const Eigen::Vector3f ray = hit.view->R_box_camera * ray_camera;
  hit.cosine = std::abs(ray[hit.axis]) / ray.norm();
  return hit;
}

RgbdImage TexturedRoom::Render(const Rigid3d& T_world_camera, Stamp stamp) const {
  const std::vector<View> views = ViewsFrom(T_world_camera);
  RgbdImage image;
  image.stamp = image.depth_stamp = stamp;
  image.colour.create(camera_.height_px(), camera_.width_px(), CV_8UC3);
  image.depth_m.create(camera_.height_px(), camera_.width_px(), CV_32FC1);
  for (int v = 0; v < camera_.height_px(); ++v) {
    for (int u = 0; u < camera_.width_px(); ++u) {
      const Eigen::Vector3f ray = camera_.Ray(u, v).homogeneous();
      const Hit hit = Cast(views, ray);
      image.colour.at<cv::Vec3b>(v, u) = Shade(hit, ray);
      const bool is_seen = !options_.noise || (hit.z_m > kNearestM && hit.z_m < kFarthestM &&
                                               hit.cosine > kGrazingCosine);
      image.depth_m.at<float>(v, u) = is_seen ? hit.z_m : kNan;
    }
  }
  // A lens does not resolve single pixels; without this, edges would be stairs.
  cv::GaussianBlur(image.colour, image.colour, cv::Size(3, 3), 0.6);
  if (options_.noise) AddNoise(image);
  return image;
}

void TexturedRoom::AddNoise(RgbdImage& image) const {
  std::uint64_t bits = Mixed(Mixed(options_.seed) ^ static_cast<std::uint64_t>(image.stamp.ns));
  for (int v = 0; v < image.colour.rows; ++v) {
    auto* colour = image.colour.ptr<cv::Vec3b>(v);
    auto* depth_m = image.depth_m.ptr<float>(v);
    for (int u = 0; u < image.colour.cols; ++u) {
      bits = Mixed(bits);
      depth_m[u] += kDepthNoisePerM2 * depth_m[u] * depth_m[u] * Normal(bits);
      bits = Mixed(bits);
      // Of brightness: what remains of a sensor's noise after JPEG.
      const cv::Vec3f noise = cv::Vec3f::all(kColourNoise * Normal(bits));
      colour[u] = cv::Vec3f(colour[u]) + noise;
    }
  }
}

}  // namespace semantic_slam
