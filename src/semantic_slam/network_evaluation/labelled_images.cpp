#include "semantic_slam/network_evaluation/labelled_images.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/tum_images.h"
#include "semantic_slam/network_evaluation/image_files.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

constexpr char kArchiveLabels[] = "sunrgbd_train_test_labels";
constexpr char kReorganisedLabels[] = "label37";

bool HasFolder(const fs::path& set, const char* name) {
  return fs::is_directory(set / name);
}

void AddSequence(const std::string& folder, std::vector<LabelledImage>& found) {
  ProblemLog problems;
  std::map<Stamp, std::string> labels;
  for (const ImageFile& file : ReadImageList(folder, "labels.txt", problems)) {
    labels[file.stamp] = file.path;
  }
  for (const ImageFile& image : ReadImageList(folder, "rgb.txt", problems)) {
    const auto match = labels.find(image.stamp);
    if (match != labels.end()) found.push_back({image.path, match->second});
  }
}

std::vector<LabelledImage> OfSequences(const std::string& set) {
  std::vector<LabelledImage> found;
  for (const std::string& folder : SequenceFolders(set)) AddSequence(folder, found);
  return found;
}

std::vector<LabelledImage> OfPlainFolder(const fs::path& set) {
  std::vector<LabelledImage> found;
  for (const std::string& image : ImagesIn(set / "images")) {
    const fs::path labels = set / "labels" / (fs::path(image).stem().string() + ".png");
    if (fs::exists(labels)) found.push_back({image, labels.string()});
  }
  return found;
}

// In the archives' one folder of labels those of the test photos come first.
std::vector<std::string> ArchiveLabels(const fs::path& set, const std::string& split) {
  const std::vector<std::string> labels = ImagesIn(set / kArchiveLabels);
  const std::size_t tests = std::min(ImagesIn(set / "SUNRGBD-test_images").size(), labels.size());
  const auto middle = labels.begin() + static_cast<std::ptrdiff_t>(tests);
  return split == "test" ? std::vector(labels.begin(), middle) : std::vector(middle, labels.end());
}

std::vector<LabelledImage> OfSunRgbd(const fs::path& set, const std::string& split) {
  const bool is_archive = HasFolder(set, kArchiveLabels);
  const auto images =
      ImagesIn(is_archive ? set / ("SUNRGBD-" + split + "_images") : set / "image" / split);
  const auto labels =
      is_archive ? ArchiveLabels(set, split) : ImagesIn(set / kReorganisedLabels / split);
  if (images.size() != labels.size()) {
    throw ConfigError(set.string() + ": " + std::to_string(images.size()) + " photos and " +
                      std::to_string(labels.size()) + " label images of the split " + split +
                      "; expected equally many");
  }
  std::vector<LabelledImage> found;
  for (std::size_t i = 0; i < images.size(); ++i) found.push_back({images[i], labels[i]});
  return found;
}

std::vector<LabelledImage> OfSet(const std::string& set, const std::string& split) {
  if (!fs::is_directory(set)) throw ConfigError("no such folder: " + set);
  if (HasFolder(set, kArchiveLabels) || HasFolder(set, kReorganisedLabels)) {
    return OfSunRgbd(set, split);
  }
  if (HasFolder(set, "images") && HasFolder(set, "labels")) return OfPlainFolder(set);
  return OfSequences(set);
}

}  // namespace

std::vector<LabelledImage> FindLabelledImages(const std::vector<std::string>& sets,
                                              const std::string& split) {
  std::vector<LabelledImage> all;
  for (const std::string& set : sets) {
    const std::vector<LabelledImage> found = OfSet(set, split);
    if (found.empty()) {
      throw ConfigError(set + ": no images with labels in it or below it; see docs/evaluation.md");
    }
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

}  // namespace semantic_slam
