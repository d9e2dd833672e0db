#pragma once

// The names of topics and services, listed once. All are relative, so launch files may remap them;
// docs/ros_api.md describes each.

namespace semantic_slam_ros::topics {

// In
constexpr char kColour[] = "rgb/image_raw";  // + "/compressed" with ~image_transport
constexpr char kDepth[] = "depth_registered/image_raw";  // + "/compressedDepth" likewise
constexpr char kCameraInfo[] = "rgb/camera_info";
constexpr char kImu[] = "imu";
constexpr char kGroundTruthTf[] = "tf_ground_truth";

// Out
constexpr char kOdometry[] = "odometry";
constexpr char kPath[] = "path";
constexpr char kMapPoints[] = "map_points";
constexpr char kTrackingState[] = "tracking_state";
constexpr char kKeyframes[] = "keyframes";
constexpr char kDebugImage[] = "debug_image";
constexpr char kGroundTruthPath[] = "ground_truth_path";

// Services; private to their node
constexpr char kReset[] = "reset";
constexpr char kPause[] = "pause";
constexpr char kSaveTrajectory[] = "save_trajectory";

}  // namespace semantic_slam_ros::topics
