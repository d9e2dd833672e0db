#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/map/map_contents.h"

namespace semantic_slam {

// A map with what it takes to go on with it.
struct StoredMap {
  CameraIntrinsics camera;
  std::vector<float> scales;  // of the feature pyramid
  MapContents contents;
};

// The map as bytes: the same for the same map on every machine, and nothing is rounded.
std::string EncodeMap(const StoredMap& map);

// Throws InputError saying what is wrong, whatever the bytes are.
StoredMap DecodeMap(std::string_view bytes);

}  // namespace semantic_slam
