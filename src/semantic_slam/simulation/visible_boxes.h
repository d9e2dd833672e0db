#pragma once

#include <memory>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/detection/detections.h"
#include "semantic_slam/simulation/scene_renderer.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

struct VisibleBoxesOptions {
  int min_pixels = 64;             // things of which fewer pixels are visible get no box
  double min_visible_share = 0.2;  // nor those whose box is a smaller share, by area, of the box
                                   // that they would have in this image if nothing hid them

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("min_pixels", self.min_pixels, 1, 1000000);
    visit("min_visible_share", self.min_visible_share, 0.0, 1.0);
  }
};

// The objects in view, and which ones they are.
struct VisibleObjects {
  Detections detections;              // with confidence 1, by ascending instance
  std::vector<InstanceId> instances;  // one per box
  std::vector<float> visible_shares;  // one per box: of its silhouette, 0 to 1
};

// Knows which boxes a perfect detector would find in a rendered view. Immutable, so safe from any
// thread.
class VisibleBoxes {
 public:
  // Objects of structure and of the classes "wall", "floor" and "ceiling" get no box, nor do those
  // that are unknown. Throws ConfigError if an option is out of range.
  VisibleBoxes(const VisibleBoxesOptions& options, std::shared_ptr<const World> world,
               const LabelVocabulary& vocabulary);

  // The smallest boxes around the visible pixels of each object in a view that was rendered with
  // `camera` at `T_world_camera` and `time_s`. The detections carry `stamp`.
  VisibleObjects Find(const RenderedView& view, const Rigid3d& T_world_camera,
                      const CameraModel& camera, double time_s, Stamp stamp) const;

 private:
  bool GetsBox(const WorldObject& object) const;
  double FullArea(const WorldObject& object, const Rigid3d& T_world_camera,
                  const CameraModel& camera, double time_s) const;

  const VisibleBoxesOptions options_;
  const std::shared_ptr<const World> world_;
  const std::uint64_t vocabulary_hash_;
  std::vector<LabelId> excluded_;
};

}  // namespace semantic_slam
