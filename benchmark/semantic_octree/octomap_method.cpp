#include "semantic_octree/octomap_method.h"

#include <array>
#include <cstdint>

#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <Eigen/Geometry>

#include "semantic_octree/tree_method.h"
#include "semantic_slam/octree/semantic_octree.h"

namespace semantic_slam {
namespace {

octomap::pose6d ToPose(const synthetic_room::Frame& frame) {
  const Eigen::Quaterniond q(frame.R_map_camera.cast<double>());
  const Eigen::Vector3f& t = frame.position;
  return {{t.x(), t.y(), t.z()}, octomath::Quaternion(q.w(), q.x(), q.y(), q.z())};
}

template <typename Tree>
class OctomapMethod : public TreeMethod<Tree> {
 public:
  OctomapMethod(const MappingSettings& settings, InnerNodes inner)
      : range_m_(settings.range_m), inner_(inner), tree_(settings.resolution_m) {
    const OccupancyOptions occupancy;  // what our mapper has
    tree_.setProbHit(occupancy.hit);
    tree_.setProbMiss(occupancy.miss);
    tree_.setClampingThresMin(occupancy.clamp_min);
    tree_.setClampingThresMax(occupancy.clamp_max);
  }

  void Prepare(synthetic_room::Frame& frame) override {
    scan_.clear();
    scan_.reserve(frame.points.size());
    for (const SemanticPoint& point : frame.points)
      scan_.push_back(point.position.x(), point.position.y(), point.position.z());
  }

  void Insert(const synthetic_room::Frame& frame) override { InsertCloud(frame); }

 protected:
  // Returns the cloud in the map.
  octomap::Pointcloud InsertCloud(const synthetic_room::Frame& frame) {
    const octomap::pose6d T_map_camera = ToPose(frame);
    octomap::Pointcloud cloud(scan_);
    cloud.transform(T_map_camera);
    InsertInMap(cloud, T_map_camera.trans());
    return cloud;
  }

  void InsertInMap(const octomap::Pointcloud& cloud, const octomap::point3d& origin) {
    const bool lazy = inner_ == InnerNodes::kLazy;
    tree_.insertPointCloud(cloud, origin, range_m_, lazy, true);
    if (lazy) tree_.updateInnerOccupancy();
  }

  const Tree& tree() const override { return tree_; }
  Tree& mutable_tree() { return tree_; }

 private:
  const double range_m_;
  const InnerNodes inner_;
  Tree tree_;
  octomap::Pointcloud scan_;
};

class ColourOctomapMethod : public OctomapMethod<octomap::ColorOcTree> {
 public:
  explicit ColourOctomapMethod(const MappingSettings& settings)
      : OctomapMethod(settings, InnerNodes::kEager) {}

  void Prepare(synthetic_room::Frame& frame) override {
    OctomapMethod::Prepare(frame);
    colours_.clear();
    for (const SemanticPoint& point : frame.points) colours_.push_back(point.rgb);
  }

  void Insert(const synthetic_room::Frame& frame) override {
    const octomap::Pointcloud cloud = InsertCloud(frame);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const auto& [r, g, b] = colours_[i];
      mutable_tree().averageNodeColor(cloud[i].x(), cloud[i].y(), cloud[i].z(), r, g, b);
    }
  }

 private:
  std::vector<std::array<std::uint8_t, 3>> colours_;
};

class SamePointsMethod : public OctomapMethod<octomap::OcTree> {
 public:
  explicit SamePointsMethod(const MappingSettings& settings)
      : OctomapMethod(settings, InnerNodes::kLazy) {}

  void Insert(const synthetic_room::Frame& frame) override {
    const Rigid3d T_map_camera = frame.T_map_camera();
    octomap::Pointcloud cloud;
    cloud.reserve(frame.points.size());
    for (const SemanticPoint& point : frame.points) {
      const Eigen::Vector3f p = (T_map_camera * point.position.cast<double>()).cast<float>();
      cloud.push_back(p.x(), p.y(), p.z());
    }
    const Eigen::Vector3f& origin = frame.position;
    InsertInMap(cloud, {origin.x(), origin.y(), origin.z()});
  }
};

}  // namespace

std::unique_ptr<MappingMethod> MakeSamePointsMethod(const MappingSettings& settings) {
  return std::make_unique<SamePointsMethod>(settings);
}

std::unique_ptr<MappingMethod> MakeOctomapMethod(const MappingSettings& settings,
                                                 InnerNodes inner) {
  return std::make_unique<OctomapMethod<octomap::OcTree>>(settings, inner);
}

std::unique_ptr<MappingMethod> MakeColourOctomapMethod(const MappingSettings& settings) {
  return std::make_unique<ColourOctomapMethod>(settings);
}

}  // namespace semantic_slam
