#include "semantic_slam_ros/bag_source.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include <ros/serialization.h>
#include <rosbag/exceptions.h>
#include <rosbag/query.h>
#include <tf2_msgs/TFMessage.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {

using semantic_slam::CameraIntrinsics;
using semantic_slam::ImagePairerOptions;
using semantic_slam::InputError;
using semantic_slam::RgbdImage;

namespace {

const std::string kImage = "sensor_msgs/Image";
const std::string kCompressedImage = "sensor_msgs/CompressedImage";

std::string Joined(const std::vector<std::string>& words) {
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : ", ") + word;
  return joined;
}

// `names` with the topics under which image_transport publishes them compressed.
std::vector<std::string> WithTransports(const std::vector<std::string>& names) {
  std::vector<std::string> topics;
  for (const std::string& name : names) {
    for (const char* transport : {"", "/compressed", "/compressedDepth"}) {
      topics.push_back(name + transport);
    }
  }
  return topics;
}

// The message, or nullptr if it is malformed or of another type.
template <typename Message>
boost::shared_ptr<const Message> Instantiate(const rosbag::MessageInstance& instance) {
  try {
    return instance.instantiate<Message>();
  } catch (const ros::serialization::StreamOverrunException&) {
    return nullptr;
  }
}

// Runs `read`, with rosbag's exceptions as one line that names the file.
template <typename Read>
auto NamingTheBag(const std::string& path, Read&& read) {
  try {
    return read();
  } catch (const rosbag::BagException& e) {
    throw InputError(path + " is damaged: " + e.what());
  }
}

}  // namespace

ImagePairerOptions BagSource::WaitForNearest() {
  ImagePairerOptions options;
  options.min_period_share = 0.0;
  options.capacity = 30;  // bags are in order of arrival, and drivers hold one stream back
  return options;
}

BagSource::BagSource(const std::string& path, const BagTopics& topics,
                     const ImagePairerOptions& pairing)
    : path_(path), pairer_(pairing) {
  Open();
  NamingTheBag(path_, [&] {
    ChooseTopics(topics);
    const TransformTree tree = ReadTransforms();
    const std::string camera_frame = ReadColourFrame();
    ground_truth_ = tree.Path(FrameName(topics.world_frame), camera_frame);
    ReadAccelerometer(tree, camera_frame);
    images_.addQuery(bag_, rosbag::TopicQuery({colour_topic_, depth_topic_}));
    next_image_ = images_.begin();
  });
}

void BagSource::Open() {
  if (!std::filesystem::is_regular_file(path_)) throw InputError("no such file: " + path_);
  try {
    bag_.open(path_, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw InputError(path_ + " was not closed properly; 'rosbag reindex' may repair it");
  } catch (const rosbag::BagException& e) {
    throw InputError(path_ + " is not a bag: " + e.what());
  }
}

void BagSource::ChooseTopics(const BagTopics& topics) {
  rosbag::View all(bag_);
  for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
    types_[connection->topic] = connection->datatype;
  }
  colour_topic_ = RequireImages("colour", topics.colour);
  depth_topic_ = RequireImages("depth", topics.depth);
  camera_info_topic_ = FirstPresent(topics.camera_info, {"sensor_msgs/CameraInfo"});
  imu_topic_ = FirstPresent(topics.imu, {"sensor_msgs/Imu"});
  // The index counts them; which of them pair up is known when they are read.
  size_ = std::min(rosbag::View(bag_, rosbag::TopicQuery(colour_topic_)).size(),
                   rosbag::View(bag_, rosbag::TopicQuery(depth_topic_)).size());
}

std::optional<std::string> BagSource::FirstPresent(const std::vector<std::string>& names,
                                                   const std::vector<std::string>& types) const {
  for (const std::string& name : names) {
    const auto found = types_.find(name);
    if (found == types_.end()) continue;
    if (std::find(types.begin(), types.end(), found->second) != types.end()) return name;
  }
  return std::nullopt;
}

std::string BagSource::RequireImages(const char* what,
                                     const std::vector<std::string>& names) const {
  const auto topic = FirstPresent(WithTransports(names), {kImage, kCompressedImage});
  if (topic) return *topic;
  std::vector<std::string> found;
  for (const auto& [name, type] : types_) {
    found.push_back(name);
    found.back().append(" (").append(type).append(")");
  }
  throw InputError(path_ + " has no " + what + " images; looked for " + Joined(names) + "; found " +
                   (found.empty() ? "nothing" : Joined(found)));
}

TransformTree BagSource::ReadTransforms() const {
  TransformTree tree;
  // "/tf" was tf/tfMessage when the TUM bags were recorded; the two have one definition.
  rosbag::View messages(bag_, rosbag::TopicQuery({"/tf", "tf", "/tf_static", "tf_static"}));
  for (const rosbag::MessageInstance& instance : messages) {
    const auto msg = Instantiate<tf2_msgs::TFMessage>(instance);
    if (!msg) continue;
    for (const geometry_msgs::TransformStamped& transform : msg->transforms) {
      try {
        tree.Add(FrameName(transform.header.frame_id), FrameName(transform.child_frame_id),
                 ToStamp(transform.header.stamp), ToRigid(transform.transform));
      } catch (const InputError&) {
        continue;
      }
    }
  }
  return tree;
}

std::string BagSource::ReadColourFrame() const {
  rosbag::View messages(bag_, rosbag::TopicQuery(colour_topic_));
  if (messages.size() == 0) return "";
  const rosbag::MessageInstance first = *messages.begin();
  if (const auto msg = Instantiate<sensor_msgs::Image>(first)) {
    return FrameName(msg->header.frame_id);
  }
  const auto msg = Instantiate<sensor_msgs::CompressedImage>(first);
  return msg ? FrameName(msg->header.frame_id) : "";
}

void BagSource::ReadAccelerometer(const TransformTree& tree, const std::string& camera_frame) {
  if (!imu_topic_) return;
  rosbag::View messages(bag_, rosbag::TopicQuery(*imu_topic_));
  for (const rosbag::MessageInstance& instance : messages) {
    const auto msg = Instantiate<sensor_msgs::Imu>(instance);
    if (!msg) continue;
    try {
      accelerometer_.push_back(ToAccelerometerReading(*msg));
    } catch (const InputError&) {
      continue;
    }
    if (R_camera_imu_) continue;
    const auto T_camera_imu = tree.Fixed(camera_frame, FrameName(msg->header.frame_id));
    if (T_camera_imu) R_camera_imu_ = T_camera_imu->linear();
  }
  std::stable_sort(accelerometer_.begin(), accelerometer_.end(),
                   [](const auto& a, const auto& b) { return a.stamp < b.stamp; });
}

CameraIntrinsics BagSource::Intrinsics() const {
  if (!camera_info_topic_) throw InputError(path_ + " has no camera_info");
  return NamingTheBag(path_, [this] {
    rosbag::View messages(bag_, rosbag::TopicQuery(*camera_info_topic_));
    const auto msg =
        messages.size() == 0 ? nullptr : Instantiate<sensor_msgs::CameraInfo>(*messages.begin());
    if (!msg) throw InputError(path_ + ": " + *camera_info_topic_ + " is malformed");
    try {
      return ToIntrinsics(*msg);
    } catch (const InputError& e) {
      throw InputError(path_ + ": " + e.what());
    }
  });
}

std::optional<RgbdImage> BagSource::Next() {
  while (true) {
    if (pairs_.empty() && !NamingTheBag(path_, [this] { return ReadPairs(); })) {
      CheckAnyPaired();
      return std::nullopt;
    }
    const Pairer::Pair pair = std::move(pairs_.front());
    pairs_.pop_front();
    try {
      return Decode(pair);
    } catch (const InputError& e) {
      problems_.Add(path_ + " at " + ToString(pair.stamp) + ": " + e.what());
    }
  }
}

bool BagSource::ReadPairs() {
  for (; pairs_.empty() && next_image_ != images_.end(); ++next_image_) AddImage(*next_image_);
  if (pairs_.empty() && !flushed_) {
    flushed_ = true;
    Keep(pairer_.Flush());
  }
  return !pairs_.empty();
}

void BagSource::AddImage(const rosbag::MessageInstance& instance) {
  ImageMessage image;
  Stamp stamp;
  if (const auto raw = Instantiate<sensor_msgs::Image>(instance)) {
    image = raw;
    stamp = ToStamp(raw->header.stamp);
  } else if (const auto compressed = Instantiate<sensor_msgs::CompressedImage>(instance)) {
    image = compressed;
    stamp = ToStamp(compressed->header.stamp);
  } else {
    problems_.Add(path_ + ": a message on " + instance.getTopic() + " is malformed");
    return;
  }
  auto result = instance.getTopic() == colour_topic_ ? pairer_.AddColour(stamp, std::move(image))
                                                     : pairer_.AddDepth(stamp, std::move(image));
  if (result.jumped_back) {
    throw InputError(path_ + ": stamps on " + instance.getTopic() + " jump back to " +
                     ToString(stamp) + "; is it two recordings in one?");
  }
  Keep(std::move(result.pairs));
}

void BagSource::Keep(std::vector<Pairer::Pair> pairs) {
  any_paired_ = any_paired_ || !pairs.empty();
  std::move(pairs.begin(), pairs.end(), std::back_inserter(pairs_));
}

void BagSource::CheckAnyPaired() const {
  if (any_paired_) return;
  const auto& counts = pairer_.counts();
  throw InputError(path_ + ": none of " + std::to_string(counts.unpaired_colour) + " colour and " +
                   std::to_string(counts.unpaired_depth) + " depth images have stamps that fit");
}

RgbdImage BagSource::Decode(const Pairer::Pair& pair) {
  ColourImage colour = ToColour(pair.colour);
  RgbdImage image{pair.stamp, pair.depth_stamp, std::move(colour.pixels), colour.order,
                  ToDepthMetres(pair.depth)};
  CheckRgbdImage(image);
  return image;
}

}  // namespace semantic_slam_ros
