#include "testing/small_sequence.h"

#include "testing/handheld_path.h"

namespace semantic_slam {
namespace {

constexpr double kImagesPerS = 15.0;
constexpr double kFirstImageS = 3.0;  // into the path, when the camera is up to speed

}  // namespace

Stamp SmallSequenceStamp(int image) {
  return {1'000'000'000'000 + static_cast<std::int64_t>(1e9 / kImagesPerS) * image};
}

Rigid3d SmallSequencePose(int image) {
  return HandheldPath::T_world_camera(kFirstImageS + image / kImagesPerS);
}

const RgbdImage& SmallSequenceImage(int image) {
  static const std::vector<RgbdImage> kImages = [] {
    std::vector<RgbdImage> images;
    for (int i = 0; i < kSmallSequenceImages; ++i) {
      images.push_back(SmallRoomImage(SmallSequencePose(i), SmallSequenceStamp(i)));
    }
    return images;
  }();
  return kImages.at(image);
}

LocalizationOptions SmallSequenceOptions() {
  LocalizationOptions options;
  options.features.max_features = 500;
  options.tracking.max_keyframe_gap = 3;
  return options;
}

}  // namespace semantic_slam
