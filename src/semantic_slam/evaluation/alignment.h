#pragma once

#include <vector>

#include "semantic_slam/common/transform.h"
#include "semantic_slam/evaluation/association.h"

namespace semantic_slam {

// T_reference_estimate, the rigid motion without scale that brings the estimated positions nearest
// to the reference's in the sense of least squares (Umeyama, PAMI 1991). Orientations decide only
// what positions leave open: a path along a straight line says nothing about the rotation around
// it. Needs at least one match.
Rigid3d AlignTrajectories(const std::vector<MatchedPose>& matches);

}  // namespace semantic_slam
