#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/semantic_fusion/voxel_observation.h"

namespace semantic_slam {

// When and from where a cloud was seen. The pose relative to a keyframe stays true when the map is
// corrected.
struct CloudAnchor {
  Stamp stamp;
  KeyframeId keyframe_id = kNoKeyframe;
  Rigid3d T_keyframe_camera = Rigid3d::Identity();
};

// A VoxelObservation in 16 bytes.
struct PackedObservation {
  std::array<std::int16_t, 3> position;  // in the cloud's units
  std::array<std::uint8_t, 3> rgb;
  std::array<LabelId, 3> labels;
  std::array<std::uint8_t, 3> probabilities;  // in 255ths
  std::uint8_t points;                        // stops at 255; 0: is only seen
};
static_assert(sizeof(PackedObservation) == 16, "no padding: there are millions");

// What one image showed, one observation per voxel, packed. The finest step of a position is a
// 32767th of the farthest one: 0.15 mm at 5 m.
struct PackedCloud {
  float unit_m = 1.0f;  // of positions
  std::vector<PackedObservation> observations;
};

PackedCloud Pack(const std::vector<VoxelObservation>& observations);
std::vector<VoxelObservation> Unpack(const PackedCloud& cloud);

}  // namespace semantic_slam
