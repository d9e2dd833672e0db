#include "semantic_slam/map/map_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>

#include <boost/crc.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/map/byte_stream.h"

namespace semantic_slam {
namespace {

// The end of line tells when a transfer as text has changed it.
constexpr std::string_view kMagic = "SEMSLAM\n";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kHeaderBytes = 8 + 4 + 8 + 4;

constexpr double kSamePixels = 0.01;      // focal lengths and principal points
constexpr double kSameDistortion = 1e-5;  // coefficients
constexpr float kSameScale = 1e-4f;
constexpr std::size_t kMaxDistortion = 8;

std::uint32_t Crc32(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

std::string ReadAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  std::vector<char> block(1 << 16);
  do {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    bytes.append(block.data(), static_cast<std::size_t>(file.gcount()));
  } while (file);
  if (!file.eof() || file.bad()) throw InputError("cannot open " + path);  // or it is a folder
  return bytes;
}

StoredMap Decode(std::string_view file) {
  if (file.substr(0, kMagic.size()) != kMagic) throw InputError("it is no localization map");
  if (file.size() < kHeaderBytes) throw InputError("it is cut short");
  ByteReader header(file.substr(kMagic.size()));
  const auto version = header.Get<std::uint32_t>();
  const auto length = header.Get<std::uint64_t>();
  const auto checksum = header.Get<std::uint32_t>();
  if (version != kVersion) {
    throw InputError("it is of version " + std::to_string(version) + ", expected " +
                     std::to_string(kVersion));
  }
  const std::string_view content = file.substr(kHeaderBytes);
  if (content.size() < length) {
    throw InputError("it is cut short: " + std::to_string(content.size()) + " of " +
                     std::to_string(length) + " bytes are there");
  }
  if (content.size() > length || Crc32(content) != checksum) {
    throw InputError("it is damaged: its checksum does not fit");
  }
  try {
    return DecodeMap(content);
  } catch (const InputError& e) {
    throw InputError("it is damaged: " + std::string(e.what()));
  }
}

double Coefficient(const CameraIntrinsics& camera, std::size_t i) {
  return i < camera.distortion.size() ? camera.distortion[i] : 0.0;
}

bool IsSameCamera(const CameraIntrinsics& a, const CameraIntrinsics& b) {
  bool same = a.width_px == b.width_px && a.height_px == b.height_px;
  for (const double difference :
       {a.fx_px - b.fx_px, a.fy_px - b.fy_px, a.cx_px - b.cx_px, a.cy_px - b.cy_px}) {
    same = same && std::abs(difference) < kSamePixels;
  }
  for (std::size_t i = 0; i < kMaxDistortion; ++i) {
    same = same && std::abs(Coefficient(a, i) - Coefficient(b, i)) < kSameDistortion;
  }
  return same;
}

std::string Describe(const CameraIntrinsics& camera) {
  std::ostringstream text;
  text << camera.width_px << " x " << camera.height_px << " px, fx " << camera.fx_px << " fy "
       << camera.fy_px << " cx " << camera.cx_px << " cy " << camera.cy_px << ", distortion [";
  for (std::size_t i = 0; i < camera.distortion.size(); ++i) {
    text << (i > 0 ? " " : "") << camera.distortion[i];
  }
  text << "]";
  return text.str();
}

bool IsSamePyramid(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](float x, float y) { return std::abs(x - y) < kSameScale * y; });
}

std::string Describe(const std::vector<float>& scales) {
  std::ostringstream text;
  text << scales.size() << " levels up to scale " << scales.back();
  return text.str();
}

}  // namespace

void WriteMapFile(const std::string& path, const StoredMap& map) {
  if (map.contents.keyframes.empty()) {
    throw InputError("cannot write " + path + ": there is no map yet");
  }
  const std::string content = EncodeMap(map);
  ByteWriter header;
  for (const char c : kMagic) header.Put(c);
  header.Put(kVersion);
  header.Put<std::uint64_t>(content.size());
  header.Put(Crc32(content));
  WriteFileAtomically(path, [&](std::ostream& file) {
    file.write(header.bytes().data(), static_cast<std::streamsize>(header.bytes().size()));
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
  });
}

StoredMap ReadMapFile(const std::string& path) {
  const std::string bytes = ReadAll(path);
  try {
    return Decode(bytes);
  } catch (const InputError& e) {
    throw InputError("cannot read " + path + ": " + e.what());
  }
}

void CheckMapFits(const std::string& path, const StoredMap& map, const CameraIntrinsics& camera,
                  const std::vector<float>& scales) {
  if (!IsSameCamera(map.camera, camera)) {
    throw InputError("cannot use " + path + ": the map's camera is " + Describe(map.camera) +
                     ", but this one is " + Describe(camera));
  }
  if (!IsSamePyramid(map.scales, scales)) {
    throw InputError("cannot use " + path + ": the map's features are of " + Describe(map.scales) +
                     ", but these are of " + Describe(scales));
  }
}

}  // namespace semantic_slam
