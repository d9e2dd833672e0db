#include "semantic_slam/simulation/visible_boxes.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "semantic_slam/common/options.h"
#include "semantic_slam/simulation/silhouette.h"

namespace semantic_slam {
namespace {

constexpr double kNearM = 0.05;  // what is nearer to the camera's plane cannot be projected

// The visible pixels of one object.
struct Extent {
  int pixels = 0;
  cv::Point first{0, 0}, last{-1, -1};  // corners of the box around them, both within

  void Add(cv::Point pixel) {
    if (pixels++ == 0) {
      first = last = pixel;
      return;
    }
    first = {std::min(first.x, pixel.x), std::min(first.y, pixel.y)};
    last = {std::max(last.x, pixel.x), std::max(last.y, pixel.y)};
  }

  // Edges of pixels, whose centres have whole coordinates.
  cv::Rect2f Box() const {
    return {static_cast<float>(first.x) - 0.5f, static_cast<float>(first.y) - 0.5f,
            static_cast<float>(last.x - first.x + 1), static_cast<float>(last.y - first.y + 1)};
  }
};

// By instance.
std::vector<Extent> ExtentsIn(const cv::Mat& instances, std::size_t objects) {
  std::vector<Extent> extents(objects + 1);
  for (int v = 0; v < instances.rows; ++v) {
    const auto* const row = instances.ptr<InstanceId>(v);
    for (int u = 0; u < instances.cols; ++u) {
      assert(row[u] <= objects);
      if (row[u] != kNoInstance) extents[row[u]].Add({u, v});
    }
  }
  return extents;
}

}  // namespace

VisibleBoxes::VisibleBoxes(const VisibleBoxesOptions& options, std::shared_ptr<const World> world,
                           const LabelVocabulary& vocabulary)
    : options_(Validated(options)),
      world_(std::move(world)),
      vocabulary_hash_(vocabulary.hash()),
      excluded_{kUnknownLabel} {
  for (const char* const name : {"wall", "floor", "ceiling"}) {
    if (const auto label = vocabulary.Find(name)) excluded_.push_back(*label);
  }
}

VisibleObjects VisibleBoxes::Find(const RenderedView& view, const Rigid3d& T_world_camera,
                                  const CameraModel& camera, double time_s, Stamp stamp) const {
  VisibleObjects found;
  found.detections.stamp = stamp;
  found.detections.vocabulary_hash = vocabulary_hash_;
  found.detections.image_size = view.instances.size();
  const std::vector<Extent> extents = ExtentsIn(view.instances, world_->objects.size());
  for (const WorldObject& object : world_->objects) {
    const Extent& extent = extents[object.instance];
    if (extent.pixels < options_.min_pixels || !GetsBox(object)) continue;
    const cv::Rect2f box = extent.Box();
    const double full_area = FullArea(object, T_world_camera, camera, time_s);
    if (box.area() < options_.min_visible_share * full_area) continue;
    found.detections.boxes.push_back({object.label, 1.0f, box});
    found.instances.push_back(object.instance);
    const int whole = SilhouettePixels(object, T_world_camera.inverse() * object.Pose(time_s),
                                       camera.intrinsics());
    found.visible_shares.push_back(
        std::min(1.0f, static_cast<float>(extent.pixels) / static_cast<float>(std::max(whole, 1))));
  }
  return found;
}

bool VisibleBoxes::GetsBox(const WorldObject& object) const {
  return !object.is_structure &&
         std::find(excluded_.begin(), excluded_.end(), object.label) == excluded_.end();
}

// Of the box around all of the object that is in the image [px^2].
double VisibleBoxes::FullArea(const WorldObject& object, const Rigid3d& T_world_camera,
                              const CameraModel& camera, double time_s) const {
  const Rigid3d T_camera_object = T_world_camera.inverse() * object.Pose(time_s);
  Eigen::AlignedBox2d box;
  for (const Surface& surface : object.surfaces) {
    for (const Eigen::Vector3f& p : surface.mesh.positions_m) {
      const Eigen::Vector3d p_camera = T_camera_object * p.cast<double>();
      if (p_camera.z() > kNearM) box.extend(camera.Project(p_camera));
    }
  }
  const Eigen::AlignedBox2d image(
      Eigen::Vector2d::Constant(-0.5),
      Eigen::Vector2d(camera.width_px() - 0.5, camera.height_px() - 0.5));
  const Eigen::AlignedBox2d in_image = box.intersection(image);
  return in_image.isEmpty() ? 0.0 : in_image.volume();
}

}  // namespace semantic_slam
