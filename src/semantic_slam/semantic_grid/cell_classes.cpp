#include "semantic_slam/semantic_grid/cell_classes.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

// Keeps one more class of a cell if it is among the most probable. Of equal ones the earlier stays.
void Insert(LabelId label, std::uint8_t probability, LabelId* labels, std::uint8_t* probabilities,
            int classes) {
  int place = classes;
  while (place > 0 && probability > probabilities[place - 1]) --place;
  if (place == classes) return;
  std::copy_backward(labels + place, labels + classes - 1, labels + classes);
  std::copy_backward(probabilities + place, probabilities + classes - 1, probabilities + classes);
  labels[place] = label;
  probabilities[place] = probability;
}

float ProbabilityOf(const MapObject& object, LabelId label) {
  for (const LabelProbability& entry : object.labels) {
    if (entry.label == label) return entry.probability;
  }
  return 0.0f;
}

// One class over the whole grid: for each cell the probability that no object covers it and is of
// the class.
class ClassLayer {
 public:
  ClassLayer(int width, int height) : absent_(height, width, CV_32FC1, cv::Scalar(1.0)) {}

  void Add(const PresencePatch& patch, float class_probability) {
    cv::Mat absent = absent_(patch.cells);
    for (int v = 0; v < absent.rows; ++v) {
      const auto* presence = patch.probability.ptr<float>(v);
      auto* row = absent.ptr<float>(v);
      for (int u = 0; u < absent.cols; ++u) row[u] *= 1.0f - presence[u] * class_probability;
    }
  }

  // Hands the patch's cells over to `cells` and clears them here, so that each counts once.
  void Take(const cv::Rect& patch, LabelId label, std::uint8_t least, SemanticCells& cells) {
    const int classes = cells.classes_per_cell;
    for (int y = patch.y; y < patch.y + patch.height; ++y) {
      auto* row = absent_.ptr<float>(y);
      for (int x = patch.x; x < patch.x + patch.width; ++x) {
        const auto probability = static_cast<std::uint8_t>(255.0f * (1.0f - row[x]));
        row[x] = 1.0f;
        if (probability == 0 || probability < least) continue;
        const std::size_t first = (static_cast<std::size_t>(y) * cells.width + x) * classes;
        Insert(label, probability, &cells.labels[first], &cells.probabilities[first], classes);
      }
    }
  }

 private:
  cv::Mat absent_;
};

}  // namespace

void FillClasses(const std::vector<PlacedObject>& objects, const LabelVocabulary& vocabulary,
                 double min_probability, SemanticCells& cells) {
  const auto least = static_cast<std::uint8_t>(std::ceil(255.0 * min_probability));
  ClassLayer layer(cells.width, cells.height);
  for (const LabelClass& label : vocabulary.classes()) {
    if (label.id == kUnknownLabel) continue;
    std::vector<const PlacedObject*> of_class;
    for (const PlacedObject& placed : objects) {
      const float probability = ProbabilityOf(*placed.object, label.id);
      if (probability <= 0.0f) continue;
      layer.Add(placed.patch, probability);
      of_class.push_back(&placed);
    }
    for (const PlacedObject* placed : of_class) {
      layer.Take(placed->patch.cells, label.id, least, cells);
    }
  }
}

}  // namespace semantic_slam
