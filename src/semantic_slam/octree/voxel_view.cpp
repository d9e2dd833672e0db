#include "semantic_slam/octree/voxel_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "semantic_slam/octree/occupied_voxels.h"

namespace semantic_slam {
namespace {

// How bright the sides of a cube are: across x, across y, above and below.
constexpr double kShadeX = 0.86, kShadeY = 0.74, kShadeTop = 1.0, kShadeBottom = 0.6;

// A darker rim tells neighbouring cubes of one colour apart, where a cube is large enough for one.
constexpr double kRim = 0.05;  // of the side
constexpr double kRimShade = 0.82;
constexpr double kMinSidePx = 6.0;

// One side of a cube in the camera's frame.
struct Side {
  Eigen::Vector3d corner;
  Eigen::Vector3d edge_u, edge_v;
  cv::Vec3b colour;  // BGR
};

// Draws sides into an image, the nearest in front.
class SideRenderer {
 public:
  SideRenderer(const CameraIntrinsics& intrinsics, const VoxelViewOptions& options)
      : camera_(intrinsics),
        options_(options),
        image_(intrinsics.height_px, intrinsics.width_px, CV_8UC3, cv::Scalar(255, 255, 255)),
        depth_(intrinsics.height_px, intrinsics.width_px, CV_32FC1,
               cv::Scalar(std::numeric_limits<float>::max())) {}

  void Draw(const Side& side) {
    const cv::Rect box = Box(side);
    const Eigen::Vector3d normal = side.edge_u.cross(side.edge_v);
    const double offset = normal.dot(side.corner);
    const Eigen::Vector3d u = side.edge_u / side.edge_u.squaredNorm(),
                          v = side.edge_v / side.edge_v.squaredNorm();
    const bool rim = side.edge_u.norm() * camera_.fx_px / side.corner.z() >= kMinSidePx;
    for (int row = box.y; row < box.y + box.height; ++row) {
      for (int column = box.x; column < box.x + box.width; ++column) {
        const Eigen::Vector3d ray((column - camera_.cx_px) / camera_.fx_px,
                                  (row - camera_.cy_px) / camera_.fy_px, 1.0);
        const double z = offset / normal.dot(ray);
        if (!(z > 0.0 && z < depth_.at<float>(row, column))) continue;
        const Eigen::Vector3d inside = z * ray - side.corner;
        const double a = u.dot(inside), b = v.dot(inside);
        if (a < 0.0 || a > 1.0 || b < 0.0 || b > 1.0) continue;
        depth_.at<float>(row, column) = static_cast<float>(z);
        const bool on_rim = rim && std::min(std::min(a, 1.0 - a), std::min(b, 1.0 - b)) < kRim;
        image_.at<cv::Vec3b>(row, column) = on_rim ? Shaded(side.colour, kRimShade) : side.colour;
      }
    }
  }

  static cv::Vec3b Shaded(const cv::Vec3b& colour, double shade) {
    return {cv::saturate_cast<std::uint8_t>(shade * colour[0]),
            cv::saturate_cast<std::uint8_t>(shade * colour[1]),
            cv::saturate_cast<std::uint8_t>(shade * colour[2])};
  }

  const cv::Mat& image() const { return image_; }

 private:
  // The pixels that the side may cover; none if a corner is too near to project.
  cv::Rect Box(const Side& side) const {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d p =
          side.corner + (i & 1 ? 1.0 : 0.0) * side.edge_u + (i & 2 ? 1.0 : 0.0) * side.edge_v;
      if (p.z() < options_.near_m) return {};
      const double column = camera_.fx_px * p.x() / p.z() + camera_.cx_px;
      const double row = camera_.fy_px * p.y() / p.z() + camera_.cy_px;
      left = std::min(left, column), right = std::max(right, column);
      top = std::min(top, row), bottom = std::max(bottom, row);
    }
    if (right < 0.0 || left > camera_.width_px || bottom < 0.0 || top > camera_.height_px)
      return {};
    const int x = std::max(0, static_cast<int>(left)), y = std::max(0, static_cast<int>(top));
    return cv::Rect(cv::Point(x, y),
                    cv::Point(std::min(camera_.width_px, static_cast<int>(right) + 2),
                              std::min(camera_.height_px, static_cast<int>(bottom) + 2)));
  }

  const CameraIntrinsics camera_;
  const VoxelViewOptions options_;
  cv::Mat image_;
  cv::Mat depth_;
};

bool IsOccupiedAt(const SemanticOcTree& tree, const Eigen::Vector3d& p) {
  octomap::OcTreeKey key;
  if (!tree.coordToKeyChecked(p.x(), p.y(), p.z(), key)) return false;
  const SemanticNode* node = tree.search(key);
  return node != nullptr && tree.isNodeOccupied(node);
}

double ShadeOf(int axis, bool positive) {
  return axis == 0 ? kShadeX : axis == 1 ? kShadeY : positive ? kShadeTop : kShadeBottom;
}

}  // namespace

cv::Mat RenderVoxels(const SemanticOcTree& tree, const VoxelColours& colours,
                     const CameraIntrinsics& intrinsics, const Rigid3d& T_map_camera,
                     const VoxelViewOptions& options) {
  SideRenderer renderer(intrinsics, options);
  const Rigid3d T_camera_map = T_map_camera.inverse();
  const Eigen::Vector3d eye = T_map_camera.translation();
  ForEachOccupiedLeaf(
      tree, [&](const Eigen::Vector3d& centre, double size_m, const SemanticNode& node) {
        const Eigen::Vector3d centre_camera = T_camera_map * centre;
        if (centre.z() > options.max_z_m || centre_camera.z() < options.near_m ||
            centre_camera.z() > options.far_m)
          return;
        const auto rgb = colours(node, centre.z());
        for (int axis = 0; axis < 3; ++axis) {
          const double to_eye = eye[axis] - centre[axis];
          if (std::abs(to_eye) <= 0.5 * size_m)
            continue;  // neither of the two sides faces the camera
          const bool positive = to_eye > 0.0;
          Eigen::Vector3d outward = Eigen::Vector3d::Zero();
          outward[axis] = positive ? size_m : -size_m;
          if (IsOccupiedAt(tree,
                           centre + 0.5 * outward + 0.5 * tree.getResolution() * outward / size_m))
            continue;
          Eigen::Vector3d edge_u = Eigen::Vector3d::Zero(), edge_v = Eigen::Vector3d::Zero();
          edge_u[(axis + 1) % 3] = edge_v[(axis + 2) % 3] = size_m;
          const Eigen::Vector3d corner = centre + 0.5 * (outward - edge_u - edge_v);
          const cv::Vec3b bgr(rgb[2], rgb[1], rgb[0]);
          renderer.Draw({T_camera_map * corner, T_camera_map.linear() * edge_u,
                         T_camera_map.linear() * edge_v,
                         SideRenderer::Shaded(bgr, ShadeOf(axis, positive))});
        }
      });
  return renderer.image();
}

}  // namespace semantic_slam
