// Scores a segmentation network on images with true labels: thesis section 4.2.2, Fig. 4.6.

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "semantic_slam/evaluation/trajectory_plot.h"
#include "semantic_slam/network_evaluation/confusion_picture.h"
#include "semantic_slam/network_evaluation/image_files.h"
#include "semantic_slam/network_evaluation/segmentation_evaluation.h"
#include "semantic_slam/network_evaluation/segmentation_report.h"
#include "semantic_slam/segmentation/segmentation_overlay.h"
#include "tools/command_line.h"
#include "tools/config_folder.h"
#include "tools/network_evaluation_options.h"
#include "tools/overview_figure.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

constexpr char kPurpose[] =
    "Runs a segmentation network as segmentation_node does and compares its labels with the true\n"
    "ones, pixel by pixel: pixel accuracy, mean class accuracy, mean IoU, frequency-weighted IoU,\n"
    "IoU, precision and recall of each class, and the time per image. A SET is a rendered "
    "sequence\n"
    "or a folder with some below it, a folder with images/ and labels/ (PNG of label ids), or\n"
    "SUN RGB-D; see docs/evaluation.md.";

// Colour, truth and prediction of the best, the median and the worst image.
cv::Mat DrawExamples(const std::vector<LabelledImage>& images, const std::vector<double>& scores,
                     const ClassList& classes, const LabelVocabulary& vocabulary,
                     Segmenter& segmenter) {
  std::vector<FigurePanel> panels;
  for (const Example& chosen : ChooseExamples(scores)) {
    const LabelledImage& image = images[chosen.index];
    const SegmentationExample example = MakeExample(image, classes, segmenter);
    const auto draw = [&](const Segmentation& segmentation) {
      return DrawSegmentation(example.colour, ColourOrder::kBgr, segmentation, vocabulary);
    };
    panels.push_back({ExampleTitle(chosen, "right", image.image_path), example.colour});
    panels.push_back({"truth; grey does not count", draw(example.truth)});
    panels.push_back({"prediction", draw(example.predicted)});
  }
  return ComposeFigure(panels, 3);
}

void WriteFigures(const SegmentationEvaluation& evaluation, const ClassList& classes,
                  const NetworkEvaluationOptions& options) {
  const std::string title = "Pixels, " + fs::path(options.card).stem().string();
  WritePlot(DrawConfusion(evaluation.confusion, classes.names, kOtherLabels, title),
            fs::path(*options.output) / "confusion.png");
}

int Run(CommandLine& command_line) {
  NetworkEvaluationOptions options;
  options.split = "test";
  DeclareNetworkEvaluation(command_line, "train|test", options);
  if (!command_line.Parse()) return EXIT_SUCCESS;
  CheckNetworkEvaluation(options, {"train", "test"});

  const LabelVocabulary vocabulary =
      LabelVocabulary::Load(ConfigFile(options.labels, "labels.yaml"));
  const Model model = LoadModel(options.card, options.models);
  const ClassList classes = FindClasses(options, model, vocabulary);
  const std::vector<LabelledImage> images =
      Spread(FindLabelledImages(options.sets, options.split), options.images);
  Segmenter segmenter(model, vocabulary, options.network);
  ProgressBar progress("segmenting", images.size());
  const SegmentationEvaluation evaluation = EvaluateSegmentation(
      images, classes, segmenter, [&](std::size_t done) { progress.Update(done); });

  const nlohmann::ordered_json json = ToJson(evaluation, classes);
  if (options.output) {
    WriteFigures(evaluation, classes, options);
    const cv::Mat examples =
        DrawExamples(images, evaluation.image_accuracies, classes, vocabulary, segmenter);
    WritePlot(examples, fs::path(*options.output) / "examples.png");
    WriteJson(json, fs::path(*options.output) / "segmentation.json");
  }
  if (options.json) {
    std::cout << json.dump(2) << '\n';
  } else {
    PrintTable(evaluation, classes, std::cout);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::Run);
}
