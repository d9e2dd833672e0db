#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/features/orb_extractor.h"
#include "semantic_slam/local_mapping/local_mapper.h"
#include "semantic_slam/localization/mapping_pipeline.h"
#include "semantic_slam/loop_closing/loop_closer.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/place_recognition/place_index.h"
#include "semantic_slam/tracking/tracker.h"

namespace semantic_slam {

// The options of every stage of localization, in the groups that configuration files use.
struct LocalizationOptions {
  OrbExtractorOptions features;
  TrackerOptions tracking;
  ReadoutOptions readout;
  MovingThingsOptions moving;
  LocalMapperOptions local_mapping;
  PlaceIndexOptions place_recognition;
  LoopCloserOptions loop_closer;

  // Calls visit_group(name, group) for each.
  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("features", self.features);
    visit_group("tracking", self.tracking);
    visit_group("readout", self.readout);
    MovingThingsOptions::VisitGroups(self.moving, visit_group);
    LocalMapperOptions::VisitGroups(self.local_mapping, visit_group);
    visit_group("place_recognition", self.place_recognition);
    LoopCloserOptions::VisitGroups(self.loop_closer, visit_group);
  }
};

// One feature of the image tracked last, for people to look at.
struct FeatureView {
  Eigen::Vector2f pixel;  // raw image
  float size_px;          // diameter of the patch it was described from
  bool is_inlier;         // a map point that supports the pose; else just a corner
  bool is_left_out;       // it is on something that moves
};

// Thesis section 3.2, Visual Localization: tracking, local mapping and loop closing behind one door. Track() is
// for one thread; everything else may be called from any thread at any time.
class VisualLocalization {
 public:
  // Throws ConfigError if an option is out of range.
  VisualLocalization(const LocalizationOptions& options, std::shared_ptr<const CameraModel> camera,
                     MappingMode mode);
  ~VisualLocalization();

  // Where up is and where the map's origin lies: the pose that the first tracked image gets, in a
  // map with z up. Identity (the map is the first camera's optical frame) unless set before.
  void SetStart(const Rigid3d& T_map_camera);

  // Localizes one image. Throws InputError, and changes nothing, if the image does not fit the
  // camera or its stamp is not later than that of the image before.
  TrackedImage Track(const RgbdImage& image);

  // What an image shows, and which classes of it move: features on those are left out, of that image
  // if the labels come before it is given to Track(), else of later ones. Tells whether it is used.
  LabelImageFate AddLabels(const LabelImage& image);

  // Forgets the map and starts a new one with the next image; map_id grows by one, keyframe ids and
  // the revision go on. The way to go after a jump back in time.
  void Reset();

  // The same, and from now on images are `camera`'s: the way to go after a change of calibration.
  void Reset(std::shared_ptr<const CameraModel> camera);

  // Images of another time come, and perhaps of another place: the map stays, and the camera is lost
  // in it. Without a map, the same as Reset().
  void Restart();

  // Whether the map grows and changes with what is seen; on unless set. Off, poses come from the map
  // as it is: no image becomes a keyframe, nothing is begun where the camera is lost. What mapping
  // was given before is still worked off.
  void SetMapping(bool on);

  // Writes the present map and the dormant ones into a file, see map_file.h; waits for mapping and
  // loop closing first. Throws InputError naming the file if it cannot be written or there is no map
  // yet.
  void SaveMap(const std::string& path);

  // Replaces the maps by those of a file. The camera is lost in them until it comes to a place that
  // they know; with mapping on, a new map begins beside them if it does not, as after any loss.
  // Throws InputError naming the file, and changes nothing, if it is no such file, damaged, or made
  // with another camera or pyramid.
  void LoadMap(const std::string& path);

  // Waits until mapping and loop closing have worked off what they were given.
  void Finish();

  // Grows whenever the keyframe graph has changed; ask for the graph then.
  std::uint64_t revision() const;
  KeyframeGraph keyframe_graph() const;

  // All map points.
  std::vector<ColouredPoint> map_points() const;

  // Features of the image tracked last.
  std::vector<FeatureView> features() const;

  // Loops closed so far, in all maps.
  std::size_t closed_loops() const;

  // Keyframes that tracking wanted while local mapping was still busy.
  std::size_t rejected_keyframes() const;

  std::vector<StageTiming> timings() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace semantic_slam
