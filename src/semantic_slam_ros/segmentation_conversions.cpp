#include "semantic_slam_ros/segmentation_conversions.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <vector>

#include <boost/make_shared.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/semantic_cloud/check_cloud.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/point_field.h"
#include "semantic_slam_ros/shared_pixels.h"

namespace semantic_slam_ros {

using semantic_slam::InputError;
using semantic_slam::kTopLabels;
using semantic_slam::LabelClass;
using semantic_slam::LabelId;
using semantic_slam::LabelVocabulary;
using semantic_slam::SemanticPoint;
using sensor_msgs::PointField;

static_assert(semantic_slam::SemanticImage::PLANES == kTopLabels);
static_assert(semantic_slam::Label::UNKNOWN == semantic_slam::kUnknownLabel);
static_assert(semantic_slam::Label::RESERVED == semantic_slam::kReservedLabel);

namespace {

constexpr std::uint32_t kMaxSidePx = 16384;

semantic_slam::Label ToLabel(const LabelClass& label) {
  semantic_slam::Label msg;
  msg.id = label.id;
  msg.name = label.name;
  msg.colour.r = static_cast<float>(label.rgb[0]) / 255.0f;
  msg.colour.g = static_cast<float>(label.rgb[1]) / 255.0f;
  msg.colour.b = static_cast<float>(label.rgb[2]) / 255.0f;
  msg.colour.a = 1.0f;
  msg.movable = label.movable;
  msg.hollow = label.hollow;
  return msg;
}

void CheckPlaneSizes(const semantic_slam::SemanticImage& msg) {
  const std::string size = std::to_string(msg.width) + " x " + std::to_string(msg.height);
  if (msg.width == 0 || msg.height == 0 || msg.width > kMaxSidePx || msg.height > kMaxSidePx) {
    throw InputError("semantic image: size is " + size);
  }
  const std::size_t expected = std::size_t{kTopLabels} * msg.width * msg.height;
  if (msg.labels.size() == expected && msg.confidences.size() == expected) return;
  throw InputError("semantic image: " + size + " px have " + std::to_string(msg.labels.size()) +
                   " labels and " + std::to_string(msg.confidences.size()) +
                   " confidences, expected " + std::to_string(expected));
}

void AppendPlane(const cv::Mat& plane, std::vector<std::uint8_t>& bytes) {
  for (int v = 0; v < plane.rows; ++v) {
    bytes.insert(bytes.end(), plane.ptr<std::uint8_t>(v), plane.ptr<std::uint8_t>(v) + plane.cols);
  }
}

// A point as it is sent. Other senders may order fields in other ways.
struct WirePoint {
  float x, y, z;
  std::uint8_t blue, green, red, zero;  // PCL's packing: 0x00rrggbb, little-endian
  std::array<LabelId, kTopLabels> labels;
  std::uint8_t padding;
  std::array<float, kTopLabels> confidences;
};
static_assert(sizeof(WirePoint) == 32 && offsetof(WirePoint, labels) == 16 &&
              offsetof(WirePoint, confidences) == 20);

const std::vector<std::string>& LabelFields() {
  static const std::vector<std::string> names{"label1", "label2", "label3"};
  return names;
}

const std::vector<std::string>& ConfidenceFields() {
  static const std::vector<std::string> names{"confidence1", "confidence2", "confidence3"};
  return names;
}

std::vector<PointField> WireFields() {
  std::vector<PointField> fields{
      MakePointField("x", offsetof(WirePoint, x), PointField::FLOAT32),
      MakePointField("y", offsetof(WirePoint, y), PointField::FLOAT32),
      MakePointField("z", offsetof(WirePoint, z), PointField::FLOAT32),
      MakePointField("rgb", offsetof(WirePoint, blue), PointField::FLOAT32)};
  for (int i = 0; i < kTopLabels; ++i) {
    fields.push_back(
        MakePointField(LabelFields()[i], offsetof(WirePoint, labels) + i, PointField::UINT8));
  }
  for (int i = 0; i < kTopLabels; ++i) {
    fields.push_back(MakePointField(ConfidenceFields()[i],
                                    offsetof(WirePoint, confidences) + sizeof(float) * i,
                                    PointField::FLOAT32));
  }
  return fields;
}

WirePoint ToWire(const SemanticPoint& point) {
  const auto& [red, green, blue] = point.rgb;
  return {point.position.x(),
          point.position.y(),
          point.position.z(),
          blue,
          green,
          red,
          0,
          point.labels,
          0,
          point.confidences};
}

// Where the fields lie in a point.
struct CloudLayout {
  std::array<std::uint32_t, 3> xyz;
  std::uint32_t rgb;
  std::array<std::uint32_t, kTopLabels> labels;
  std::array<std::uint32_t, kTopLabels> confidences;
};

// The offset of a field of that size. `datatypes` are those that will do.
std::uint32_t FindField(const sensor_msgs::PointCloud2& msg, const std::string& name,
                        const std::vector<std::uint8_t>& datatypes, std::uint32_t bytes) {
  for (const PointField& field : msg.fields) {
    if (field.name != name) continue;
    if (std::find(datatypes.begin(), datatypes.end(), field.datatype) == datatypes.end()) {
      throw InputError("semantic cloud: field " + name + " has datatype " +
                       std::to_string(field.datatype) + ", expected " +
                       std::to_string(datatypes.front()));
    }
    if (field.offset > msg.point_step || msg.point_step - field.offset < bytes) {
      throw InputError("semantic cloud: field " + name + " at offset " +
                       std::to_string(field.offset) + " does not fit into points of " +
                       std::to_string(msg.point_step) + " bytes");
    }
    return field.offset;
  }
  throw InputError("semantic cloud: has no field " + name);
}

CloudLayout FindLayout(const sensor_msgs::PointCloud2& msg) {
  CloudLayout layout;
  layout.xyz = {FindField(msg, "x", {PointField::FLOAT32}, 4),
                FindField(msg, "y", {PointField::FLOAT32}, 4),
                FindField(msg, "z", {PointField::FLOAT32}, 4)};
  layout.rgb = FindField(msg, "rgb", {PointField::FLOAT32, PointField::UINT32}, 4);
  for (int i = 0; i < kTopLabels; ++i) {
    layout.labels[i] = FindField(msg, LabelFields()[i], {PointField::UINT8}, 1);
    layout.confidences[i] = FindField(msg, ConfidenceFields()[i], {PointField::FLOAT32}, 4);
  }
  return layout;
}

void CheckCloudSize(const sensor_msgs::PointCloud2& msg) {
  if (msg.is_bigendian != 0) throw InputError("semantic cloud: big-endian is not supported");
  const std::uint64_t row_bytes = std::uint64_t{msg.width} * msg.point_step;
  if (msg.row_step < row_bytes) {
    throw InputError("semantic cloud: row_step is " + std::to_string(msg.row_step) +
                     ", expected at least " + std::to_string(row_bytes));
  }
  const std::uint64_t bytes = std::uint64_t{msg.height} * msg.row_step;
  if (msg.data.size() < bytes) {
    throw InputError("semantic cloud: has " + std::to_string(msg.data.size()) +
                     " bytes, expected " + std::to_string(bytes));
  }
}

SemanticPoint ReadPoint(const std::uint8_t* bytes, const CloudLayout& layout) {
  SemanticPoint point;
  for (int i = 0; i < 3; ++i) std::memcpy(&point.position[i], bytes + layout.xyz[i], sizeof(float));
  for (int i = 0; i < 3; ++i) point.rgb[i] = bytes[layout.rgb + 2 - i];
  for (int i = 0; i < kTopLabels; ++i) {
    point.labels[i] = bytes[layout.labels[i]];
    std::memcpy(&point.confidences[i], bytes + layout.confidences[i], sizeof(float));
  }
  return point;
}

}  // namespace

semantic_slam::LabelSet ToLabelSet(const LabelVocabulary& vocabulary, semantic_slam::Stamp loaded) {
  semantic_slam::LabelSet msg;
  msg.header = MakeHeader(loaded, "");
  msg.hash = vocabulary.hash();
  for (const LabelClass& label : vocabulary.classes()) msg.labels.push_back(ToLabel(label));
  return msg;
}

semantic_slam::SemanticImagePtr ToSemanticImage(const semantic_slam::Segmentation& segmentation,
                                                const std::string& frame_id) {
  auto msg = boost::make_shared<semantic_slam::SemanticImage>();
  msg->header = MakeHeader(segmentation.stamp, frame_id);
  msg->label_set_hash = segmentation.vocabulary_hash;
  msg->width = static_cast<std::uint32_t>(segmentation.size().width);
  msg->height = static_cast<std::uint32_t>(segmentation.size().height);
  const std::size_t bytes = std::size_t{kTopLabels} * msg->width * msg->height;
  msg->labels.reserve(bytes);
  msg->confidences.reserve(bytes);
  for (int i = 0; i < kTopLabels; ++i) {
    assert(segmentation.labels[i].type() == CV_8UC1 &&
           segmentation.confidences[i].type() == CV_8UC1);
    AppendPlane(segmentation.labels[i], msg->labels);
    AppendPlane(segmentation.confidences[i], msg->confidences);
  }
  return msg;
}

semantic_slam::Segmentation ToSegmentation(const semantic_slam::SemanticImageConstPtr& msg,
                                           const LabelVocabulary& vocabulary) {
  CheckPlaneSizes(*msg);
  semantic_slam::Segmentation segmentation;
  segmentation.stamp = ToStamp(msg->header.stamp);
  segmentation.vocabulary_hash = msg->label_set_hash;
  const int rows = static_cast<int>(msg->height), cols = static_cast<int>(msg->width);
  const std::size_t plane = std::size_t{msg->width} * msg->height;
  for (int i = 0; i < kTopLabels; ++i) {
    segmentation.labels[i] =
        SharePixels(msg, msg->labels.data() + i * plane, rows, cols, CV_8UC1, msg->width);
    segmentation.confidences[i] =
        SharePixels(msg, msg->confidences.data() + i * plane, rows, cols, CV_8UC1, msg->width);
  }
  semantic_slam::CheckSegmentation(segmentation, vocabulary);
  return segmentation;
}

sensor_msgs::PointCloud2Ptr ToPointCloud2(const semantic_slam::SemanticCloud& cloud,
                                          const std::string& frame_id) {
  auto msg = boost::make_shared<sensor_msgs::PointCloud2>();
  msg->header = MakeHeader(cloud.stamp, frame_id);
  msg->height = 1;
  msg->width = static_cast<std::uint32_t>(cloud.points.size());
  msg->fields = WireFields();
  msg->point_step = sizeof(WirePoint);
  msg->row_step = msg->width * msg->point_step;
  msg->is_dense = true;
  msg->data.resize(msg->row_step);
  std::uint8_t* bytes = msg->data.data();
  for (const SemanticPoint& point : cloud.points) {
    const WirePoint wire = ToWire(point);
    std::memcpy(bytes, &wire, sizeof(wire));
    bytes += sizeof(wire);
  }
  return msg;
}

semantic_slam::SemanticCloud ToSemanticCloud(const sensor_msgs::PointCloud2& msg,
                                             const LabelVocabulary& vocabulary) {
  semantic_slam::SemanticCloud cloud;
  cloud.stamp = ToStamp(msg.header.stamp);
  cloud.vocabulary_hash = vocabulary.hash();
  if (msg.width == 0 || msg.height == 0) return cloud;
  CheckCloudSize(msg);
  const CloudLayout layout = FindLayout(msg);
  cloud.points.reserve(std::size_t{msg.width} * msg.height);
  for (std::size_t v = 0; v < msg.height; ++v) {
    const std::uint8_t* bytes = msg.data.data() + v * msg.row_step;
    for (std::size_t u = 0; u < msg.width; ++u, bytes += msg.point_step) {
      const SemanticPoint point = ReadPoint(bytes, layout);
      if (!point.position.allFinite()) continue;
      cloud.points.push_back(point);
    }
  }
  semantic_slam::CheckSemanticCloud(cloud, vocabulary);
  return cloud;
}

}  // namespace semantic_slam_ros
