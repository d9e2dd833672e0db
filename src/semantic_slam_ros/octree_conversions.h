#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>
#include <Eigen/Core>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/octree/map_projection.h"
#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/octree/voxel_colours.h"

// The semantic octree as messages, for rviz and for whoever wants the voxels.

namespace semantic_slam_ros {

// What is shown of an octree: its occupied leaves.
struct OccupiedCells {
  struct Cell {
    Eigen::Vector3f centre;
    int depth;  // in the tree; 16 is the smallest
    std::array<std::uint8_t, 3> rgb;
    semantic_slam::LabelId label;
    float probability;  // of the label
  };
  std::vector<Cell> cells;              // in the tree's order
  std::vector<double> size_at_depth_m;  // edge of a cell, by depth
};

OccupiedCells CollectOccupiedCells(const semantic_slam::SemanticOcTree& tree,
                                   const semantic_slam::VoxelColours& colours);

// One CUBE_LIST per depth of the tree, as octomap_server has them: where a depth has no cell, a
// marker that deletes what was there. Cells whose centre is above `max_z_m` are left out.
visualization_msgs::MarkerArray ToMarkers(const OccupiedCells& cells,
                                          const std_msgs::Header& header, double max_z_m);

// One point per cell: x y z (float32) [m], rgb (float32, PCL's packing), label (uint8), probability
// and size (float32) [m].
sensor_msgs::PointCloud2 ToPointCloud2(const OccupiedCells& cells, const std_msgs::Header& header);

// The classes that some cell has, by ascending id.
std::vector<semantic_slam::LabelId> LabelsIn(const OccupiedCells& cells);

// A cube in the colour of each class with its name beside it, in columns of ten, standing at the
// edge of the cells. What an earlier legend had more of is deleted.
visualization_msgs::MarkerArray ToLegend(const OccupiedCells& cells,
                                         const semantic_slam::LabelVocabulary& vocabulary,
                                         const std_msgs::Header& header);

nav_msgs::OccupancyGrid ToOccupancyGrid(const semantic_slam::ProjectedMap& map,
                                        const std_msgs::Header& header);

}  // namespace semantic_slam_ros
