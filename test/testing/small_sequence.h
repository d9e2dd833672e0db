#pragma once

#include "semantic_slam/localization/visual_localization.h"
#include "testing/small_room.h"

namespace semantic_slam {

// A second of HandheldPath at its fastest through TexturedRoom, as SmallCamera() sees it at 15
// images/s. Rendered once, whoever asks.
constexpr int kSmallSequenceImages = 16;
Stamp SmallSequenceStamp(int image);
Rigid3d SmallSequencePose(int image);  // T_world_camera
const RgbdImage& SmallSequenceImage(int image);

// Options that make the short sequence exercise everything: few features, a keyframe at least every
// third image.
LocalizationOptions SmallSequenceOptions();

}  // namespace semantic_slam
