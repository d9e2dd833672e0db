#pragma once

#include <string>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/map/map_encoding.h"

// The file that keeps a localization map: eight bytes that no other kind of file begins with, the
// version (4 bytes), the length of the rest (8), its CRC-32 (4), and the rest, see EncodeMap(). All
// numbers have their least significant byte first.

namespace semantic_slam {

// Written whole or not at all, with the same bytes for the same map. Throws InputError naming the
// path if it cannot be written, or if there is no keyframe to be written.
void WriteMapFile(const std::string& path, const StoredMap& map);

// Throws InputError naming the path and what is wrong: another kind of file, a newer version, cut
// short, or damaged.
StoredMap ReadMapFile(const std::string& path);

// Throws InputError naming the path if the map was made with another camera, telling both, or with
// another pyramid. Calibrations are the same if they differ by less than files and messages round;
// how long the readout takes is no part of the map.
void CheckMapFits(const std::string& path, const StoredMap& map, const CameraIntrinsics& camera,
                  const std::vector<float>& scales);

}  // namespace semantic_slam
