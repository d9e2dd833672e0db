#pragma once

#include <map>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/features/frame_features.h"

namespace semantic_slam {

struct SemanticMaskOptions {
  double max_age_s = 0.5;  // labels of an older image say nothing of the present one
  int margin_px = 8;  // about what is left out: labels are rough at borders, and people walk on

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_age_s", self.max_age_s, 0.0, 10.0);
    visit("margin_px", self.margin_px, 0, 200);
  }
};

// What one image shows, and which of that is to be left out.
struct LabelImage {
  Stamp stamp;     // the colour image's
  cv::Mat labels;  // H x W, CV_8UC1, label ids by raw pixel; shared, never changed
  std::vector<LabelId> left_out;
};

// What became of a label image: it is used, or it came after a later one, of an image that is too
// long ago, of another size than the camera's, or of an image whose pose is not known.
enum class LabelImageFate { kUsed, kOutOfOrder, kLate, kBadSize, kNotTracked };

// Which features are on things of classes that are left out, by the labels of that image or of a
// recent one. Labels of a recent one are looked up where that image's camera would have seen the
// feature, by its depth. Not thread-safe.
class SemanticMask {
 public:
  // Throws ConfigError if an option is out of range.
  explicit SemanticMask(const SemanticMaskOptions& options);

  // Labels may come before their image is tracked or after.
  LabelImageFate Add(const LabelImage& image, const CameraModel& camera);

  // The image with that stamp was tracked there. Stamps ascend.
  void AddPose(Stamp stamp, const Rigid3d& T_odom_camera);

  // Per feature of an image that comes after all poses: it is left out. Nothing is known about
  // `T_odom_camera`, the image's pose, but that it is near.
  std::vector<bool> Find(const FrameFeatures& features, const Rigid3d& T_odom_camera,
                         const CameraModel& camera) const;

  // Begins anew: what was added is of another camera or time.
  void Reset();

 private:
  const cv::Mat* NewestUntil(Stamp stamp, const Rigid3d& T_odom_now, Rigid3d& T_mask_now) const;

  const SemanticMaskOptions options_;
  std::map<Stamp, cv::Mat> masks_;           // by image; CV_8UC1, not 0 where features are left out
  std::map<Stamp, Rigid3d> T_odom_cameras_;  // of the images tracked in the last max_age_s
};

}  // namespace semantic_slam
