#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <image_transport/publisher.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <semantic_slam/SemanticObjectArray.h>
#include <std_srvs/Trigger.h>

#include "semantic_slam/common/worker.h"
#include "semantic_slam/semantic_grid/semantic_grid_builder.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/label_parameter.h"
#include "semantic_slam_ros/map_saver.h"
#include "semantic_slam_ros/node_health.h"

namespace semantic_slam_ros {

struct SemanticGridNodeOptions {
  double update_period_s = 0.5;  // of the wall's clock, between two grids while input changes
  std::string output_directory;  // where the grid is written on shutdown; empty: nowhere

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("update_period_s", self.update_period_s, 0.05, 60.0);
    visit("output_directory", self.output_directory);
  }
};

// Everything that semantic_grid_node reads from its private parameters.
struct SemanticGridNodeParameters {
  SemanticGridNodeOptions node;
  LabelOptions labels;
  semantic_slam::SemanticGridOptions grid;
  semantic_slam::SemanticCostOptions costs;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.node);
    visit("", self.labels);
    visit("grid", self.grid);
    visit("costs", self.costs);
  }
};

// Wires SemanticGridBuilder to topics; docs/ros_api.md lists them. Callbacks only keep the newest
// floor plan and object map; reading them, building and publishing happen on a thread of its own.
class SemanticGridNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  SemanticGridNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

  // Finishes the grid that is being built and writes it.
  ~SemanticGridNode();

 private:
  using Clock = std::chrono::steady_clock;
  // The newest messages, or nullptr where none has come.
  struct Input {
    nav_msgs::OccupancyGridConstPtr map;
    semantic_slam::SemanticObjectArrayConstPtr objects;
    Clock::time_point received;  // when the first of them came that no grid shows yet
  };
  // A grid and what it was built of.
  struct Snapshot {
    std::string frame;
    semantic_slam::OccupancyMap map;
    semantic_slam::ObjectMap objects;
    semantic_slam::SemanticCells cells;
  };

  SemanticGridNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                   const SemanticGridNodeParameters& parameters);

  void OnMap(const nav_msgs::OccupancyGridConstPtr& msg);
  void OnObjects(const semantic_slam::SemanticObjectArrayConstPtr& msg);
  bool OnReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void MarkChanged();
  void HandOver();

  void Process(const Input& input);
  bool Read(const Input& input, Snapshot& snapshot);
  void Publish(const Snapshot& snapshot);
  std::shared_ptr<const Snapshot> snapshot() const;
  std::string Save(const std::string& folder) const;
  void Diagnose(NodeHealth::Status& status) const;

  const semantic_slam::SemanticGridBuilder builder_;
  DropCounter drops_;
  ros::Publisher grid_pub_;
  ros::Publisher map_pub_;
  image_transport::Publisher image_pub_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Snapshot> snapshot_;  // pointer guarded by mutex_; nullptr before the first
  NodeHealth health_;
  MapSaver saver_;
  Input newest_;                              // for the spinning thread
  std::optional<Clock::time_point> changed_;  // likewise: since when newest_ is not in a grid
  std::unique_ptr<semantic_slam::Worker<Input>> worker_;
  ros::WallTimer timer_;
  ros::ServiceServer reset_service_;
  ros::Subscriber map_sub_;
  ros::Subscriber objects_sub_;
};

}  // namespace semantic_slam_ros
