#pragma once

// The names of topics and services, listed once. All are relative, so launch files may remap them;
// docs/ros_api.md describes each.

namespace semantic_slam_ros::topics {

// From the sensors
constexpr char kColour[] = "rgb/image_raw";  // + "/compressed" with ~image_transport
constexpr char kDepth[] = "depth_registered/image_raw";  // + "/compressedDepth" likewise
constexpr char kCameraInfo[] = "rgb/camera_info";
constexpr char kImu[] = "imu";
constexpr char kGroundTruthTf[] = "tf_ground_truth";

// From tracking
constexpr char kOdometry[] = "odometry";
constexpr char kPath[] = "path";
constexpr char kMapPoints[] = "map_points";
constexpr char kTrackingState[] = "tracking_state";
constexpr char kKeyframes[] = "keyframes";
constexpr char kDebugImage[] = "debug_image";
constexpr char kGroundTruthPath[] = "ground_truth_path";

// From the 3D branch
constexpr char kLabels[] = "labels";
constexpr char kSemanticImage[] = "semantic_image";
constexpr char kSemanticOverlay[] = "semantic_overlay";
constexpr char kSemanticCloud[] = "semantic_cloud";
constexpr char kOccupiedCells[] = "occupied_cells";
constexpr char kOccupiedCellsMarkers[] = "occupied_cells_vis_array";
constexpr char kLegend[] = "legend";
constexpr char kProjectedMap[] = "projected_map";

// From the 2.5D branch
constexpr char kDetections[] = "detections";
constexpr char kDetectionOverlay[] = "detection_overlay";
constexpr char kTrackedObjects[] = "tracked_objects";
constexpr char kObjects[] = "objects";
constexpr char kObjectMarkers[] = "object_markers";
constexpr char kScan[] = "scan";
constexpr char kMap[] = "map";
constexpr char kMapMetadata[] = "map_metadata";
constexpr char kSemanticGrid[] = "semantic_grid";
constexpr char kSemanticMap[] = "semantic_map";
constexpr char kSemanticGridImage[] = "semantic_grid_image";

// From the simulator
constexpr char kClock[] = "/clock";
constexpr char kGroundTruthOdometry[] = "ground_truth/odometry";

// Of flying
constexpr char kWaypoints[] = "waypoints";
constexpr char kGoal[] = "goal";
constexpr char kAttitudeThrust[] = "attitude_thrust";
constexpr char kWaypointStatus[] = "waypoint_status";
constexpr char kReferencePath[] = "reference_path";

// Services; private to their node
constexpr char kReset[] = "reset";
constexpr char kPause[] = "pause";
constexpr char kClear[] = "clear";
constexpr char kClearBox[] = "clear_box";
constexpr char kSaveTrajectory[] = "save_trajectory";
constexpr char kSaveMap[] = "save_map";
constexpr char kLoadMap[] = "load_map";
constexpr char kSetMapping[] = "set_mapping";
constexpr char kQuery[] = "query";

}  // namespace semantic_slam_ros::topics
