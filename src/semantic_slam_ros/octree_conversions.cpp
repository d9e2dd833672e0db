#include "semantic_slam_ros/octree_conversions.h"

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstring>

#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/point_field.h"

namespace semantic_slam_ros {

using semantic_slam::LabelClass;
using semantic_slam::LabelId;
using semantic_slam::SemanticNode;
using semantic_slam::SemanticOcTree;
using sensor_msgs::PointField;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace {

constexpr double kLegendRowM = 0.4;
constexpr double kLegendColumnM = 1.2;
constexpr int kLegendRows = 10;  // of a column
constexpr double kLegendSwatchM = 0.12;
constexpr double kLegendTextM = 0.14;
constexpr double kLegendGapM = 0.5;  // from the cells

struct WireCell {
  float x, y, z;
  std::uint8_t blue, green, red, zero;  // PCL's packing: 0x00rrggbb, little-endian
  LabelId label;
  std::uint8_t padding[3];
  float probability;
  float size;
};
static_assert(sizeof(WireCell) == 28);

std_msgs::ColorRGBA ToColour(const std::array<std::uint8_t, 3>& rgb) {
  std_msgs::ColorRGBA colour;
  colour.r = static_cast<float>(rgb[0]) / 255.0f;
  colour.g = static_cast<float>(rgb[1]) / 255.0f;
  colour.b = static_cast<float>(rgb[2]) / 255.0f;
  colour.a = 1.0f;
  return colour;
}

geometry_msgs::Point ToPoint(const Eigen::Vector3f& p) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

Marker MakeMarker(const std_msgs::Header& header, const char* ns, int id, int type,
                  double scale_m) {
  Marker marker;
  marker.header = header;
  marker.ns = ns;
  marker.id = id;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = scale_m;
  return marker;
}

// Where the legend's first row stands: at the top of the far left edge.
Eigen::Vector3f LegendCorner(const OccupiedCells& cells) {
  Eigen::Vector3f low = Eigen::Vector3f::Zero(), high = Eigen::Vector3f::Zero();
  if (!cells.cells.empty()) low = high = cells.cells.front().centre;
  for (const auto& cell : cells.cells) {
    low = low.cwiseMin(cell.centre);
    high = high.cwiseMax(cell.centre);
  }
  return {low.x() - static_cast<float>(kLegendGapM), high.y(), high.z()};
}

// How far to the right of it and below it an entry stands: column by column.
Eigen::Vector3f LegendOffset(int entry) {
  return {0.0f, static_cast<float>(kLegendColumnM * (entry / kLegendRows)),
          static_cast<float>(kLegendRowM * (entry % kLegendRows))};
}

}  // namespace

OccupiedCells CollectOccupiedCells(const SemanticOcTree& tree,
                                   const semantic_slam::VoxelColours& colours) {
  OccupiedCells occupied;
  for (unsigned depth = 0; depth <= tree.getTreeDepth(); ++depth) {
    occupied.size_at_depth_m.push_back(tree.getNodeSize(depth));
  }
  for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    const octomap::point3d centre = leaf.getCoordinate();
    const semantic_slam::CompactLabels& labels = leaf->labels();
    occupied.cells.push_back({{centre.x(), centre.y(), centre.z()},
                              static_cast<int>(leaf.getDepth()),
                              colours(*leaf, centre.z()),
                              labels.label(0),
                              labels.Unpacked().probabilities[0]});
  }
  return occupied;
}

MarkerArray ToMarkers(const OccupiedCells& cells, const std_msgs::Header& header, double max_z_m) {
  MarkerArray array;
  for (std::size_t depth = 0; depth < cells.size_at_depth_m.size(); ++depth) {
    array.markers.push_back(MakeMarker(header, "map", static_cast<int>(depth), Marker::CUBE_LIST,
                                       cells.size_at_depth_m[depth]));
  }
  for (const auto& cell : cells.cells) {
    if (cell.centre.z() > max_z_m) continue;
    Marker& marker = array.markers[cell.depth];
    marker.points.push_back(ToPoint(cell.centre));
    marker.colors.push_back(ToColour(cell.rgb));
  }
  for (Marker& marker : array.markers) {
    if (marker.points.empty()) marker.action = Marker::DELETE;
  }
  return array;
}

sensor_msgs::PointCloud2 ToPointCloud2(const OccupiedCells& cells, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 msg;
  msg.header = header;
  msg.height = 1;
  msg.width = static_cast<std::uint32_t>(cells.cells.size());
  msg.fields = {MakePointField("x", offsetof(WireCell, x), PointField::FLOAT32),
                MakePointField("y", offsetof(WireCell, y), PointField::FLOAT32),
                MakePointField("z", offsetof(WireCell, z), PointField::FLOAT32),
                MakePointField("rgb", offsetof(WireCell, blue), PointField::FLOAT32),
                MakePointField("label", offsetof(WireCell, label), PointField::UINT8),
                MakePointField("probability", offsetof(WireCell, probability), PointField::FLOAT32),
                MakePointField("size", offsetof(WireCell, size), PointField::FLOAT32)};
  msg.point_step = sizeof(WireCell);
  msg.row_step = msg.width * msg.point_step;
  msg.is_dense = true;
  msg.data.resize(msg.row_step);
  std::uint8_t* bytes = msg.data.data();
  for (const auto& cell : cells.cells) {
    const WireCell wire{cell.centre.x(),
                        cell.centre.y(),
                        cell.centre.z(),
                        cell.rgb[2],
                        cell.rgb[1],
                        cell.rgb[0],
                        0,
                        cell.label,
                        {0, 0, 0},
                        cell.probability,
                        static_cast<float>(cells.size_at_depth_m[cell.depth])};
    std::memcpy(bytes, &wire, sizeof(wire));
    bytes += sizeof(wire);
  }
  return msg;
}

std::vector<LabelId> LabelsIn(const OccupiedCells& cells) {
  std::bitset<256> present;
  for (const auto& cell : cells.cells) present.set(cell.label);
  std::vector<LabelId> labels;
  for (int id = 0; id < 256; ++id) {
    if (present[id]) labels.push_back(static_cast<LabelId>(id));
  }
  return labels;
}

MarkerArray ToLegend(const OccupiedCells& cells, const semantic_slam::LabelVocabulary& vocabulary,
                     const std_msgs::Header& header) {
  MarkerArray array;
  Marker clear = MakeMarker(header, "legend", 0, Marker::CUBE, 1.0);
  clear.action = Marker::DELETEALL;
  array.markers.push_back(clear);
  const Eigen::Vector3f corner = LegendCorner(cells);
  int entry = 0;
  for (const LabelId id : LabelsIn(cells)) {
    if (!vocabulary.Contains(id)) continue;
    const LabelClass& label = vocabulary[id];
    const Eigen::Vector3f place = corner - LegendOffset(entry++);
    Marker swatch = MakeMarker(header, "legend_colours", id, Marker::CUBE, kLegendSwatchM);
    swatch.pose.position = ToPoint(place);
    swatch.color = ToColour(label.rgb);
    Marker text = MakeMarker(header, "legend_names", id, Marker::TEXT_VIEW_FACING, kLegendTextM);
    // Above its cube, as the text turns with the view and may stand on any side.
    text.pose.position =
        ToPoint(place + Eigen::Vector3f(0.0f, 0.0f, 0.25f * static_cast<float>(kLegendRowM)));
    text.color = ToColour({255, 255, 255});
    text.text = label.name;
    array.markers.push_back(swatch);
    array.markers.push_back(text);
  }
  return array;
}

nav_msgs::OccupancyGrid ToOccupancyGrid(const semantic_slam::ProjectedMap& map,
                                        const std_msgs::Header& header) {
  nav_msgs::OccupancyGrid msg;
  msg.header = header;
  msg.info.map_load_time = header.stamp;
  msg.info.resolution = static_cast<float>(map.resolution_m);
  msg.info.width = static_cast<std::uint32_t>(map.width);
  msg.info.height = static_cast<std::uint32_t>(map.height);
  msg.info.origin.position.x = map.origin_m.x();
  msg.info.origin.position.y = map.origin_m.y();
  msg.info.origin.orientation.w = 1.0;
  msg.data = map.cells;
  return msg;
}

}  // namespace semantic_slam_ros
