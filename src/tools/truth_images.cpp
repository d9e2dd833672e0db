#include "tools/truth_images.h"

#include <filesystem>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/tum_images.h"
#include "semantic_slam/network_evaluation/box_file.h"

namespace semantic_slam {

namespace fs = std::filesystem;

TrueLabels::TrueLabels(const std::string& folder, const LabelVocabulary& vocabulary)
    : vocabulary_(vocabulary) {
  ProblemLog problems;
  for (const ImageFile& file : ReadImageList(folder, "labels.txt", problems)) {
    files_[file.stamp] = file.path;
  }
}

Segmentation TrueLabels::Find(const cv::Mat& colour, Stamp stamp) const {
  const auto file = files_.find(stamp);
  if (file == files_.end())
    throw InputError("there are no true labels at " + ToString(stamp) + " s");
  const cv::Mat labels = cv::imread(file->second, cv::IMREAD_UNCHANGED);
  if (labels.type() != CV_8UC1 || labels.size() != colour.size()) {
    throw InputError(file->second + " is no 8-bit image of the colour image's size");
  }
  const Segmentation segmentation = SureSegmentation(labels, stamp, vocabulary_.hash());
  CheckSegmentation(segmentation, vocabulary_);
  return segmentation;
}

TrueBoxes::TrueBoxes(const std::string& folder, const LabelVocabulary& vocabulary)
    : folder_((fs::path(folder) / "boxes").string()), vocabulary_(vocabulary) {
  if (!fs::is_directory(folder_)) throw InputError("no such folder: " + folder_);
}

Detections TrueBoxes::Find(const cv::Mat& colour, Stamp stamp) const {
  const std::string path = (fs::path(folder_) / (ToString(stamp) + ".txt")).string();
  if (!fs::exists(path)) throw InputError("there are no true boxes at " + ToString(stamp) + " s");
  Detections detections;
  detections.stamp = stamp;
  detections.vocabulary_hash = vocabulary_.hash();
  detections.image_size = colour.size();
  for (const FileBox& box : ReadBoxFile(path, colour.size())) {
    detections.boxes.push_back({static_cast<LabelId>(box.class_number), 1.0f, box.box});
  }
  CheckDetections(detections, vocabulary_);
  return detections;
}

}  // namespace semantic_slam
