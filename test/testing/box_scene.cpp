#include "testing/box_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace semantic_slam {
namespace {

constexpr double kRoomHalfM = 4.0;
constexpr double kBoardM = 0.04;
constexpr double kLegM = 0.05;

Rigid3d OnFloorPlan(const Eigen::Vector2d& at, double yaw_rad) {
  return Eigen::Translation3d(at.x(), at.y(), 0.0) *
         Rigid3d(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
}

// Where a ray enters a box around the origin and leaves it (Kay and Kajiya, SIGGRAPH 1986: slabs).
std::pair<double, double> Slabs(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray,
                                const Eigen::Vector3d& half) {
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double a = (-half[i] - eye[i]) / ray[i], b = (half[i] - eye[i]) / ray[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return {enter, leave};
}

// How far it is to the floor or to a wall.
double ToRoom(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) {
  const Eigen::Vector3d half(kRoomHalfM, kRoomHalfM, kRoomHalfM);
  return Slabs(eye - Eigen::Vector3d(0.0, 0.0, kRoomHalfM), ray, half).second;
}

}  // namespace

void BoxScene::AddPart(int object, const Rigid3d& T_world_object, const Eigen::Vector3d& centre_m,
                       const Eigen::Vector3d& size_m) {
  const Rigid3d T_world_part = T_world_object * Eigen::Translation3d(centre_m);
  parts_.push_back({object, T_world_part.inverse(), 0.5 * size_m});
}

int BoxScene::AddCrate(const Eigen::Vector2d& at, const Eigen::Vector3d& size_m, double yaw_rad,
                       double floor_m) {
  const double z = floor_m + 0.5 * size_m.z();
  AddPart(objects_, OnFloorPlan(at, yaw_rad), {0.0, 0.0, z}, size_m);
  return objects_++;
}

int BoxScene::AddTable(const Eigen::Vector2d& at, const Eigen::Vector3d& size_m, double yaw_rad) {
  const Rigid3d T = OnFloorPlan(at, yaw_rad);
  const double leg_m = size_m.z() - kBoardM;
  AddPart(objects_, T, {0.0, 0.0, leg_m + 0.5 * kBoardM}, {size_m.x(), size_m.y(), kBoardM});
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Eigen::Vector3d centre(0.5 * x * (size_m.x() - kLegM), 0.5 * y * (size_m.y() - kLegM),
                                   0.5 * leg_m);
      AddPart(objects_, T, centre, {kLegM, kLegM, leg_m});
    }
  }
  return objects_++;
}

int BoxScene::AddChair(const Eigen::Vector2d& at, double yaw_rad) {
  const int chair = AddTable(at, {0.45, 0.45, 0.45}, yaw_rad);
  AddPart(chair, OnFloorPlan(at, yaw_rad), {-0.205, 0.0, 0.675}, {0.04, 0.45, 0.45});
  return chair;
}

BoxScene::View BoxScene::Render(const Rigid3d& T_world_camera, const CameraModel& camera,
                                Stamp stamp) const {
  View view;
  view.image.stamp = view.image.depth_stamp = stamp;
  view.image.colour.create(camera.height_px(), camera.width_px(), CV_8UC3);
  view.image.depth_m.create(view.image.colour.size(), CV_32FC1);
  view.objects = cv::Mat::zeros(view.image.colour.size(), CV_8UC1);
  const Eigen::Vector3d eye = T_world_camera.translation();
  for (int v = 0; v < camera.height_px(); ++v) {
    for (int u = 0; u < camera.width_px(); ++u) {
      const Eigen::Vector3d ray =
          T_world_camera.linear() * camera.Ray(u, v).homogeneous().cast<double>();
      double depth = ToRoom(eye, ray);
      int shown = 0;
      for (const Part& part : parts_) {
        const auto [enter, leave] =
            Slabs(part.T_part_world * eye, part.T_part_world.linear() * ray, part.half_m);
        if (enter > 0.0 && enter <= leave && enter < depth) depth = enter, shown = part.object + 1;
      }
      view.image.depth_m.at<float>(v, u) = static_cast<float>(depth);
      view.objects.at<unsigned char>(v, u) = static_cast<unsigned char>(shown);
      view.image.colour.at<cv::Vec3b>(v, u) =
          cv::Vec3b::all(static_cast<unsigned char>(60 + 30 * shown));
    }
  }
  return view;
}

cv::Rect2f BoxScene::VisibleBox(const View& view, int object) {
  cv::Rect pixels;
  for (int v = 0; v < view.objects.rows; ++v) {
    for (int u = 0; u < view.objects.cols; ++u) {
      if (view.objects.at<unsigned char>(v, u) == object + 1) pixels |= cv::Rect(u, v, 1, 1);
    }
  }
  if (pixels.empty()) return {};
  const cv::Rect2f box(pixels);
  return {box.x - 0.5f, box.y - 0.5f, box.width, box.height};
}

Rigid3d LookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  const Eigen::Vector3d z = (target - eye).normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  Rigid3d T_world_camera = Rigid3d::Identity();
  T_world_camera.linear() << x, z.cross(x), z;
  T_world_camera.translation() = eye;
  return T_world_camera;
}

}  // namespace semantic_slam
