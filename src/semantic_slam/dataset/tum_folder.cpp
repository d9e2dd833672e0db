#include "semantic_slam/dataset/tum_folder.h"

#include <filesystem>
#include <sstream>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/accelerometer_file.h"

namespace semantic_slam {

namespace fs = std::filesystem;

namespace {

std::vector<Stamp> Stamps(const std::vector<ImageFile>& files) {
  std::vector<Stamp> stamps;
  stamps.reserve(files.size());
  for (const ImageFile& file : files) stamps.push_back(file.stamp);
  return stamps;
}

}  // namespace

bool IsTumFolder(const std::string& path) {
  return fs::is_regular_file(fs::path(path) / "rgb.txt");
}

TumFolder::TumFolder(const std::string& folder, const CameraConfig& camera,
                     const ImagePairerOptions& pairing)
    : camera_(camera) {
  Validate(pairing);
  if (!fs::is_directory(folder)) throw InputError("no such folder: " + folder);
  colour_ = ReadImageList(folder, "rgb.txt", problems_);
  depth_ = ReadImageList(folder, "depth.txt", problems_);
  pairs_ = PairStamps(Stamps(colour_), Stamps(depth_), pairing.max_gap_s);
  if (pairs_.empty()) {
    std::ostringstream what;
    what << folder << ": none of " << colour_.size() << " colour and " << depth_.size()
         << " depth images are within " << pairing.max_gap_s << " s of each other";
    throw InputError(what.str());
  }
  const fs::path accelerometer = fs::path(folder) / "accelerometer.txt";
  if (fs::exists(accelerometer)) accelerometer_ = ReadAccelerometerFile(accelerometer.string());
}

std::optional<RgbdImage> TumFolder::Next() {
  while (next_ < pairs_.size()) {
    const PairIndices& pair = pairs_[next_++];
    try {
      return Load(colour_[pair.colour], depth_[pair.depth]);
    } catch (const InputError& e) {
      problems_.Add(e.what());
    }
  }
  return std::nullopt;
}

RgbdImage TumFolder::Load(const ImageFile& colour, const ImageFile& depth) const {
  return {colour.stamp, depth.stamp, LoadColour(colour.path, camera_), ColourOrder::kBgr,
          LoadDepthMetres(depth.path, camera_)};
}

}  // namespace semantic_slam
