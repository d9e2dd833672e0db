#include "semantic_slam/network_evaluation/boxed_images.h"

#include <filesystem>
#include <numeric>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/tum_images.h"
#include "semantic_slam/network_evaluation/image_files.h"
#include "semantic_slam/network_evaluation/model_classes.h"
#include "semantic_slam/network_evaluation/yolo_data_file.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

using LabelTable = std::shared_ptr<const std::vector<LabelId>>;

LabelTable LabelIds() {
  std::vector<LabelId> ids(256);
  std::iota(ids.begin(), ids.end(), LabelId{0});
  return std::make_shared<const std::vector<LabelId>>(std::move(ids));
}

std::vector<BoxedImage> OfSequences(const std::string& set) {
  const LabelTable ids = LabelIds();
  std::vector<BoxedImage> found;
  ProblemLog problems;
  for (const std::string& folder : SequenceFolders(set)) {
    for (const ImageFile& image : ReadImageList(folder, "rgb.txt", problems)) {
      const fs::path boxes =
          fs::path(folder) / "boxes" / (fs::path(image.path).stem().string() + ".txt");
      if (fs::exists(boxes)) found.push_back({image.path, boxes.string(), ids});
    }
  }
  return found;
}

// The last folder called images is called labels; without one the file lies beside the image.
std::string LabelsFile(const fs::path& image) {
  std::vector<fs::path> parts(image.begin(), image.end());
  for (std::size_t i = parts.size() - 1; i-- > 0;) {
    if (parts[i] != "images") continue;
    parts[i] = "labels";
    break;
  }
  fs::path file;
  for (const fs::path& part : parts) file /= part;
  return file.replace_extension(".txt").string();
}

std::vector<BoxedImage> OfYoloData(const std::string& path, const std::string& split,
                                   const ModelCard& card, const LabelVocabulary& vocabulary) {
  const YoloData data = ReadYoloData(path, split);
  std::vector<LabelId> labels;
  for (const std::string& name : data.names) labels.push_back(LabelOfName(name, card, vocabulary));
  const auto table = std::make_shared<const std::vector<LabelId>>(std::move(labels));
  std::vector<BoxedImage> found;
  for (const std::string& image : data.images) found.push_back({image, LabelsFile(image), table});
  return found;
}

bool IsYamlFile(const fs::path& path) {
  return path.extension() == ".yaml" || path.extension() == ".yml";
}

}  // namespace

std::vector<BoxedImage> FindBoxedImages(const std::vector<std::string>& sets,
                                        const std::string& split, const ModelCard& card,
                                        const LabelVocabulary& vocabulary) {
  std::vector<BoxedImage> all;
  for (const std::string& set : sets) {
    const fs::path data = IsYamlFile(set) ? fs::path(set) : fs::path(set) / "data.yaml";
    if (!IsYamlFile(set) && !fs::is_directory(set)) throw ConfigError("no such folder: " + set);
    const bool is_yolo = IsYamlFile(set) || fs::exists(data);
    const std::vector<BoxedImage> found =
        is_yolo ? OfYoloData(data.string(), split, card, vocabulary) : OfSequences(set);
    if (found.empty()) {
      throw ConfigError(set + ": no images with boxes in it or below it; see docs/evaluation.md");
    }
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

}  // namespace semantic_slam
