#pragma once

#include <string>
#include <vector>

#include <nav_msgs/Path.h>
#include <semantic_slam/KeyframeArray.h>
#include <semantic_slam/TrackingState.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/map/map.h"

// What tracking tells as messages, and back. Frames are given without leading slash. What reads a
// message throws semantic_slam::InputError with one line that names the fault if it is malformed.

namespace semantic_slam_ros {

semantic_slam::TrackingState ToTrackingState(const semantic_slam::TrackedImage& image,
                                             const std::string& map_frame,
                                             const std::string& camera_frame);
// Refuses an unstamped message, an unknown state, and with STATE_TRACKING poses that are no
// transforms or no keyframe. Without STATE_TRACKING the poses are identity, whatever the message
// says.
semantic_slam::TrackedImage ToTrackedImage(const semantic_slam::TrackingState& msg);

// Stamped with the newest keyframe; zero if there is none.
semantic_slam::KeyframeArray ToKeyframeArray(const semantic_slam::KeyframeGraph& graph,
                                             const std::string& map_frame);
// Refuses an unknown reason, ids that do not ascend, parents that are not listed, and poses that
// are no transforms.
semantic_slam::KeyframeGraph ToKeyframeGraph(const semantic_slam::KeyframeArray& msg);

// Stamped with the last pose. Precondition: not empty.
nav_msgs::Path ToPath(const semantic_slam::Trajectory& trajectory, const std::string& frame);

// Fields x y z (float32) [m] and rgb (PCL's packing).
sensor_msgs::PointCloud2 ToPointCloud2(const std::vector<semantic_slam::ColouredPoint>& points,
                                       const std_msgs::Header& header);

}  // namespace semantic_slam_ros
