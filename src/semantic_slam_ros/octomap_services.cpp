#include "semantic_slam_ros/octomap_services.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/semantic_tree_file.h"
#include "semantic_slam/octree/voxel_query.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/query_conditions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using semantic_slam::ClearBox;
using semantic_slam::InputError;
using semantic_slam::LabelVocabulary;
using semantic_slam::LoadMap;
using semantic_slam::QueryMap;
using semantic_slam::VoxelsFound;
using semantic_slam::VoxelState;

namespace {

Eigen::Vector3d ToFinitePoint(const geometry_msgs::Point& point) {
  const Eigen::Vector3d p(point.x, point.y, point.z);
  if (!p.allFinite()) throw InputError("point is not finite");
  return p;
}

void Write(const VoxelsFound& found, double resolution_m, const LabelVocabulary& vocabulary,
           QueryMap::Response& response) {
  for (const VoxelsFound::OfLabel& of_label : found.labels) {
    semantic_slam::ClassVolume volume;
    volume.id = of_label.label;
    volume.name = vocabulary[of_label.label].name;
    volume.voxels = static_cast<std::uint32_t>(of_label.voxels);
    volume.volume = static_cast<double>(of_label.voxels) * std::pow(resolution_m, 3);
    response.classes.push_back(std::move(volume));
  }
  response.found = found.nearest.has_value();
  if (!found.nearest) return;
  response.nearest_class = vocabulary[found.nearest->label].name;
  response.nearest.x = found.nearest->centre_m.x();
  response.nearest.y = found.nearest->centre_m.y();
  response.nearest.z = found.nearest->centre_m.z();
  response.distance = found.nearest->distance_m;
}

void Write(const VoxelState& state, const LabelVocabulary& vocabulary,
           QueryMap::Response& response) {
  response.state = !state.is_known     ? QueryMap::Response::UNKNOWN
                   : state.is_occupied ? QueryMap::Response::OCCUPIED
                                       : QueryMap::Response::FREE;
  response.occupancy = state.occupancy;
  for (int i = 0; i < state.labels.size(); ++i) {
    response.names.push_back(vocabulary[state.labels.labels[i]].name);
    response.probabilities.push_back(state.labels.probabilities[i]);
  }
}

// The map's file, whether its folder is named or itself.
std::string FileOf(const std::string& path) {
  return std::filesystem::is_directory(path) ? path + "/semantic_map.ot" : path;
}

}  // namespace

OctomapServices::OctomapServices(ros::NodeHandle private_nh, std::string map_frame,
                                 std::mutex& mutex, semantic_slam::SemanticMapper& mapper,
                                 std::function<void()> on_load)
    : map_frame_(std::move(map_frame)),
      mutex_(mutex),
      mapper_(mapper),
      on_load_(std::move(on_load)),
      query_service_(private_nh.advertiseService(topics::kQuery, &OctomapServices::OnQuery, this)),
      load_service_(private_nh.advertiseService(topics::kLoadMap, &OctomapServices::OnLoad, this)),
      clear_service_(
          private_nh.advertiseService(topics::kClearBox, &OctomapServices::OnClearBox, this)) {}

bool OctomapServices::OnQuery(QueryMap::Request& request, QueryMap::Response& response) {
  try {
    const LabelVocabulary& vocabulary = mapper_.vocabulary();  // never changes
    semantic_slam::VoxelQuery query;
    query.label = ToLabel(request.class_name, vocabulary);
    query.box_m = ToBox(request.box_min, request.box_max);
    query.near_m = ToFinitePoint(request.point);
    std::lock_guard<std::mutex> lock(mutex_);
    const semantic_slam::SemanticOcTree& tree = mapper_.tree();
    const VoxelsFound found = FindVoxels(tree, query);
    response.header = MakeHeader(mapper_.stamp(), map_frame_);
    response.resolution = tree.getResolution();
    Write(found, tree.getResolution(), vocabulary, response);
    Write(StateAt(tree, query.near_m), vocabulary, response);
    response.message = std::to_string(found.voxels) + " voxels found";
    response.success = true;
  } catch (const InputError& e) {
    response.success = false;
    response.message = e.what();
  }
  return true;
}

bool OctomapServices::OnLoad(LoadMap::Request& request, LoadMap::Response& response) {
  try {
    const std::string path = FileOf(request.path);
    auto tree = semantic_slam::ReadSemanticTree(path, mapper_.vocabulary());
    const std::size_t nodes = tree->size();
    on_load_();
    std::lock_guard<std::mutex> lock(mutex_);
    mapper_.Load(std::move(tree));
    response.message = path + ": " + std::to_string(nodes) + " nodes; mapping goes on from there";
    response.success = true;
  } catch (const InputError& e) {
    response.success = false;
    response.message = e.what();
  }
  return true;
}

bool OctomapServices::OnClearBox(ClearBox::Request& request, ClearBox::Response& response) {
  try {
    const auto box = ToBox(request.box_min, request.box_max);
    if (!box) throw InputError("box_min and box_max are the same: the box holds nothing");
    std::lock_guard<std::mutex> lock(mutex_);
    response.message = std::to_string(mapper_.Clear(*box)) + " voxels cleared";
    response.success = true;
  } catch (const InputError& e) {
    response.success = false;
    response.message = e.what();
  }
  return true;
}

}  // namespace semantic_slam_ros
