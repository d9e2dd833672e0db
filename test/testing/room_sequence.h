#pragma once

#include <functional>
#include <memory>
#include <string>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/dataset/rgbd_source.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "testing/textured_room.h"

namespace semantic_slam {

constexpr Stamp kRoomSequenceStart{1'000'000'000'000};  // 1000 s

// TexturedRoom as HandheldPath shows it, `seconds` long at 30 images/s, rendered as it is read.
// Depth's stamps are 8 ms after colour's. Accelerometer at 100 Hz in the axes of
// Freiburg1Camera().
std::unique_ptr<RgbdSource> MakeRoomSequence(double seconds,
                                             const TexturedRoomOptions& options = {});

// Where its camera was: an exact pose for every colour image.
Trajectory RoomSequencePoses(double seconds);

// Writes the sequence as a TUM folder (rgb/*.jpg, depth/*.png, rgb.txt, depth.txt, groundtruth.txt,
// accelerometer.txt), with camera.yaml for its calibration. Calls `on_image(done, all)` after every
// image. Throws InputError if the folder cannot be written.
void WriteRoomSequence(const std::string& folder, double seconds,
                       const TexturedRoomOptions& options = {},
                       const std::function<void(std::size_t, std::size_t)>& on_image = {});

}  // namespace semantic_slam
