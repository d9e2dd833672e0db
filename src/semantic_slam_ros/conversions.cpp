#include "semantic_slam_ros/conversions.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/image_encodings.h>
#include <boost/make_shared.hpp>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/image_decoding.h"
#include "semantic_slam_ros/shared_pixels.h"

namespace semantic_slam_ros {

namespace enc = sensor_msgs::image_encodings;
using semantic_slam::AccelerometerReading;
using semantic_slam::CameraIntrinsics;
using semantic_slam::ColourOrder;
using semantic_slam::InputError;

namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr std::uint32_t kMaxSidePx = 16384;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

void CheckPixels(const sensor_msgs::Image& msg, int cv_type) {
  const std::string size = std::to_string(msg.width) + " x " + std::to_string(msg.height);
  if (msg.width == 0 || msg.height == 0 || msg.width > kMaxSidePx || msg.height > kMaxSidePx) {
    throw InputError("image size is " + size);
  }
  const std::size_t row_bytes = msg.width * static_cast<std::size_t>(CV_ELEM_SIZE(cv_type));
  if (msg.step < row_bytes || msg.step % CV_ELEM_SIZE1(cv_type) != 0) {
    throw InputError("step of a " + size + " " + msg.encoding + " image is " +
                     std::to_string(msg.step) + ", expected " + std::to_string(row_bytes));
  }
  const std::size_t bytes = static_cast<std::size_t>(msg.step) * msg.height;
  if (msg.data.size() < bytes) {
    throw InputError(size + " " + msg.encoding + " image has " + std::to_string(msg.data.size()) +
                     " bytes, expected " + std::to_string(bytes));
  }
  if (msg.is_bigendian != 0 && CV_ELEM_SIZE1(cv_type) > 1) {
    throw InputError("big-endian " + msg.encoding + " images are not supported");
  }
}

cv::Mat Share(const sensor_msgs::ImageConstPtr& msg, int cv_type) {
  CheckPixels(*msg, cv_type);
  return SharePixels(msg, msg->data.data(), static_cast<int>(msg->height),
                     static_cast<int>(msg->width), cv_type, msg->step);
}

ColourImage Converted(const cv::Mat& image, cv::ColorConversionCodes code) {
  ColourImage colour{{}, ColourOrder::kBgr};
  cv::cvtColor(image, colour.pixels, code);
  return colour;
}

cv::Mat MetresFromMillimetres(const cv::Mat& depth_mm) {
  cv::Mat depth_m;
  depth_mm.convertTo(depth_m, CV_32FC1, 1e-3);
  depth_m.setTo(kNan, depth_mm == 0);
  return depth_m;
}

cv::Mat Decode(const std::uint8_t* data, std::size_t size, int flags, const std::string& format) {
  cv::Mat image = semantic_slam::DecodeImage(data, size, flags);
  if (image.empty()) {
    throw InputError("cannot decode a compressed image of format '" + format + "', " +
                     std::to_string(size) + " bytes");
  }
  return image;
}

// What compressed_depth_image_transport puts before the PNG.
struct CompressedDepthHeader {
  std::int32_t format;
  float quant_a;
  float quant_b;
};
static_assert(sizeof(CompressedDepthHeader) == 12, "the layout on the wire");

cv::Mat MetresFromInverseDepth(const cv::Mat& inverse_depth, const CompressedDepthHeader& header) {
  cv::Mat depth_m(inverse_depth.size(), CV_32FC1);
  for (int v = 0; v < inverse_depth.rows; ++v) {
    const auto* in = inverse_depth.ptr<std::uint16_t>(v);
    auto* out = depth_m.ptr<float>(v);
    for (int u = 0; u < inverse_depth.cols; ++u) {
      out[u] = in[u] == 0 ? kNan : header.quant_a / (static_cast<float>(in[u]) - header.quant_b);
    }
  }
  return depth_m;
}

cv::Mat CheckedDepthPng(const cv::Mat& image, const std::string& format) {
  if (image.type() == CV_16UC1) return image;
  throw InputError("compressed depth of format '" + format + "' is " +
                   cv::typeToString(image.type()) + ", expected a 16-bit PNG");
}

Rigid3d ToRigid(const geometry_msgs::Quaternion& q, double x, double y, double z) {
  const Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
  const Eigen::Vector3d translation(x, y, z);
  if (!rotation.coeffs().allFinite() || !translation.allFinite()) {
    throw InputError("transform has a number that is not finite");
  }
  if (std::abs(rotation.norm() - 1.0) > 0.01) {
    throw InputError("transform's quaternion has length " + std::to_string(rotation.norm()) +
                     ", expected 1");
  }
  return Eigen::Translation3d(translation) * rotation.normalized();
}

template <typename Quaternion>
void SetQuaternion(const Rigid3d& T, Quaternion& msg) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(T.linear()).normalized();
  msg.w = q.w(), msg.x = q.x(), msg.y = q.y(), msg.z = q.z();
}

}  // namespace

Stamp ToStamp(const ros::Time& time) {
  return {time.sec * kNsPerSecond + time.nsec};
}

ros::Time ToRos(Stamp stamp) {
  assert(stamp.ns >= 0 && stamp.ns / kNsPerSecond <= std::numeric_limits<std::uint32_t>::max());
  return {static_cast<std::uint32_t>(stamp.ns / kNsPerSecond),
          static_cast<std::uint32_t>(stamp.ns % kNsPerSecond)};
}

std::string FrameName(const std::string& frame_id) {
  const std::size_t start = frame_id.find_first_not_of('/');
  return start == std::string::npos ? "" : frame_id.substr(start);
}

std_msgs::Header MakeHeader(Stamp stamp, const std::string& frame_id) {
  std_msgs::Header header;
  header.stamp = ToRos(stamp);
  header.frame_id = frame_id;
  return header;
}

ColourImage ToColour(const sensor_msgs::ImageConstPtr& msg) {
  const std::string& encoding = msg->encoding;
  if (encoding == enc::RGB8) return {Share(msg, CV_8UC3), ColourOrder::kRgb};
  if (encoding == enc::BGR8 || encoding == enc::TYPE_8UC3) {
    return {Share(msg, CV_8UC3), ColourOrder::kBgr};
  }
  if (encoding == enc::RGBA8) return Converted(Share(msg, CV_8UC4), cv::COLOR_RGBA2BGR);
  if (encoding == enc::BGRA8) return Converted(Share(msg, CV_8UC4), cv::COLOR_BGRA2BGR);
  if (encoding == enc::MONO8 || encoding == enc::TYPE_8UC1) {
    return Converted(Share(msg, CV_8UC1), cv::COLOR_GRAY2BGR);
  }
  if (enc::isBayer(encoding)) {
    throw InputError("colour encoding is '" + encoding + "'; debayer it first (image_proc does)");
  }
  throw InputError("colour encoding is '" + encoding +
                   "', expected rgb8, bgr8, rgba8, bgra8 or mono8");
}

ColourImage ToColour(const sensor_msgs::CompressedImage& msg) {
  if (msg.format.compare(0, 5, "bayer") == 0) {
    throw InputError("compressed colour image is '" + msg.format + "'; debayer it first");
  }
  return {Decode(msg.data.data(), msg.data.size(), cv::IMREAD_COLOR, msg.format),
          ColourOrder::kBgr};
}

cv::Mat ToDepthMetres(const sensor_msgs::ImageConstPtr& msg) {
  if (msg->encoding == enc::TYPE_32FC1) return Share(msg, CV_32FC1);
  if (msg->encoding == enc::TYPE_16UC1 || msg->encoding == enc::MONO16) {
    return MetresFromMillimetres(Share(msg, CV_16UC1));
  }
  throw InputError("depth encoding is '" + msg->encoding + "', expected 32FC1 [m] or 16UC1 [mm]");
}

cv::Mat ToDepthMetres(const sensor_msgs::CompressedImage& msg) {
  const auto decode_after = [&msg](std::size_t offset) {
    const std::size_t size = msg.data.size() < offset ? 0 : msg.data.size() - offset;
    return CheckedDepthPng(
        Decode(msg.data.data() + (size == 0 ? 0 : offset), size, cv::IMREAD_UNCHANGED, msg.format),
        msg.format);
  };
  if (msg.format.find("compressedDepth") == std::string::npos) {
    return MetresFromMillimetres(decode_after(0));
  }
  const cv::Mat image = decode_after(sizeof(CompressedDepthHeader));
  if (msg.format.compare(0, 5, "32FC1") != 0) return MetresFromMillimetres(image);
  CompressedDepthHeader header{};
  std::memcpy(&header, msg.data.data(), sizeof(header));
  return MetresFromInverseDepth(image, header);
}

ColourImage ToColour(const ImageMessage& msg) {
  if (const auto* raw = std::get_if<sensor_msgs::ImageConstPtr>(&msg)) return ToColour(*raw);
  return ToColour(*std::get<sensor_msgs::CompressedImageConstPtr>(msg));
}

cv::Mat ToDepthMetres(const ImageMessage& msg) {
  if (const auto* raw = std::get_if<sensor_msgs::ImageConstPtr>(&msg)) return ToDepthMetres(*raw);
  return ToDepthMetres(*std::get<sensor_msgs::CompressedImageConstPtr>(msg));
}

CameraIntrinsics ToIntrinsics(const sensor_msgs::CameraInfo& msg) {
  const std::string who = "camera_info in frame '" + FrameName(msg.header.frame_id) + "' ";
  CameraIntrinsics c;
  c.width_px = static_cast<int>(std::min(msg.width, kMaxSidePx + 1));
  c.height_px = static_cast<int>(std::min(msg.height, kMaxSidePx + 1));
  c.fx_px = msg.K[0], c.fy_px = msg.K[4], c.cx_px = msg.K[2], c.cy_px = msg.K[5];
  c.distortion.assign(msg.D.begin(), msg.D.end());
  for (const double k : msg.K) {
    if (!std::isfinite(k)) throw InputError(who + "has a K that is not finite");
  }
  if (!(c.fx_px > 0.0 && c.fy_px > 0.0)) throw InputError(who + "is not calibrated (K is 0)");
  namespace models = sensor_msgs::distortion_models;
  if (!msg.D.empty() && !msg.distortion_model.empty() &&
      msg.distortion_model != models::PLUMB_BOB &&
      msg.distortion_model != models::RATIONAL_POLYNOMIAL) {
    throw InputError(who + "has distortion model '" + msg.distortion_model +
                     "', expected plumb_bob or rational_polynomial");
  }
  const bool is_part = (msg.roi.width != 0 && msg.roi.width != msg.width) ||
                       (msg.roi.height != 0 && msg.roi.height != msg.height);
  if (msg.binning_x > 1 || msg.binning_y > 1 || is_part) {
    throw InputError(who + "has binning or a region of interest; neither is supported");
  }
  try {
    semantic_slam::CheckIntrinsics(c);
  } catch (const semantic_slam::ConfigError& e) {
    throw InputError(who + "is not usable: " + e.what());
  }
  return c;
}

AccelerometerReading ToAccelerometerReading(const sensor_msgs::Imu& msg) {
  const auto& a = msg.linear_acceleration;
  if (msg.linear_acceleration_covariance[0] == -1.0) {
    throw InputError("imu message says that it has no acceleration");
  }
  if (!std::isfinite(a.x) || !std::isfinite(a.y) || !std::isfinite(a.z)) {
    throw InputError("imu message has an acceleration that is not finite");
  }
  return {ToStamp(msg.header.stamp), {a.x, a.y, a.z}};
}

Rigid3d ToRigid(const geometry_msgs::Pose& msg) {
  return ToRigid(msg.orientation, msg.position.x, msg.position.y, msg.position.z);
}

Rigid3d ToRigid(const geometry_msgs::Transform& msg) {
  return ToRigid(msg.rotation, msg.translation.x, msg.translation.y, msg.translation.z);
}

geometry_msgs::Pose ToPose(const Rigid3d& T_frame_object) {
  geometry_msgs::Pose msg;
  const Eigen::Vector3d p = T_frame_object.translation();
  msg.position.x = p.x(), msg.position.y = p.y(), msg.position.z = p.z();
  SetQuaternion(T_frame_object, msg.orientation);
  return msg;
}

geometry_msgs::Transform ToTransform(const Rigid3d& T_parent_child) {
  geometry_msgs::Transform msg;
  const Eigen::Vector3d p = T_parent_child.translation();
  msg.translation.x = p.x(), msg.translation.y = p.y(), msg.translation.z = p.z();
  SetQuaternion(T_parent_child, msg.rotation);
  return msg;
}

geometry_msgs::TransformStamped ToTransformStamped(Stamp stamp, const std::string& parent,
                                                   const std::string& child,
                                                   const Rigid3d& T_parent_child) {
  geometry_msgs::TransformStamped msg;
  msg.header = MakeHeader(stamp, parent);
  msg.child_frame_id = child;
  msg.transform = ToTransform(T_parent_child);
  return msg;
}

sensor_msgs::ImagePtr ToImage(const cv::Mat& image, const std::string& encoding,
                              const std_msgs::Header& header) {
  assert(static_cast<int>(image.elemSize()) * 8 ==
         enc::numChannels(encoding) * enc::bitDepth(encoding));
  auto msg = boost::make_shared<sensor_msgs::Image>();
  msg->header = header;
  msg->encoding = encoding;
  msg->width = static_cast<std::uint32_t>(image.cols);
  msg->height = static_cast<std::uint32_t>(image.rows);
  msg->step = static_cast<std::uint32_t>(image.cols * image.elemSize());
  msg->data.resize(static_cast<std::size_t>(msg->step) * msg->height);
  for (int v = 0; v < image.rows; ++v) {
    std::memcpy(msg->data.data() + static_cast<std::size_t>(v) * msg->step, image.ptr(v),
                msg->step);
  }
  return msg;
}

sensor_msgs::ImagePtr ToImage(const ColourImage& image, const std_msgs::Header& header) {
  return ToImage(image.pixels, image.order == ColourOrder::kRgb ? enc::RGB8 : enc::BGR8, header);
}

sensor_msgs::CameraInfo ToCameraInfo(const CameraIntrinsics& c, const std_msgs::Header& header) {
  sensor_msgs::CameraInfo msg;
  msg.header = header;
  msg.width = static_cast<std::uint32_t>(c.width_px);
  msg.height = static_cast<std::uint32_t>(c.height_px);
  namespace models = sensor_msgs::distortion_models;
  msg.distortion_model = c.distortion.size() > 5 ? models::RATIONAL_POLYNOMIAL : models::PLUMB_BOB;
  msg.D = c.distortion;
  if (msg.D.size() < 5) msg.D.resize(5, 0.0);  // plumb_bob has five
  msg.K = {c.fx_px, 0, c.cx_px, 0, c.fy_px, c.cy_px, 0, 0, 1};
  msg.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  msg.P = {c.fx_px, 0, c.cx_px, 0, 0, c.fy_px, c.cy_px, 0, 0, 0, 1, 0};
  return msg;
}

}  // namespace semantic_slam_ros
