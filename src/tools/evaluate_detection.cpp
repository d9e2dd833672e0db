// Scores a detection network on images with true boxes: thesis section 4.1.3, Table 4.1.

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "semantic_slam/detection/detection_overlay.h"
#include "semantic_slam/evaluation/trajectory_plot.h"
#include "semantic_slam/network_evaluation/confusion_picture.h"
#include "semantic_slam/network_evaluation/detection_evaluation.h"
#include "semantic_slam/network_evaluation/detection_report.h"
#include "semantic_slam/network_evaluation/image_files.h"
#include "semantic_slam/network_evaluation/precision_recall_picture.h"
#include "tools/command_line.h"
#include "tools/config_folder.h"
#include "tools/network_evaluation_options.h"
#include "tools/overview_figure.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

constexpr char kPurpose[] =
    "Runs a detection network as detection_node does and compares its boxes with the true ones:\n"
    "average precision of each class and its means mAP@0.5 and mAP@0.5:0.95; precision, recall "
    "and\n"
    "F1 at the detector's threshold and where F1 is best; the time per image. A SET is a rendered\n"
    "sequence or a folder with some below it, or a data.yaml of YOLO's tools or a folder with "
    "one;\n"
    "see docs/evaluation.md.";

struct Arguments {
  NetworkEvaluationOptions common;
  double threshold = DetectorOptions().min_confidence;
  double max_overlap = DetectorOptions().max_overlap;
};

// False after printing the help.
bool ParseArguments(CommandLine& command_line, Arguments& arguments) {
  arguments.common.split = "val";
  DeclareNetworkEvaluation(command_line, "train|val|test", arguments.common);
  command_line.Option("threshold", "P", &arguments.threshold,
                      "confidence from which on a box is believed, detection_node's "
                      "min_confidence");
  command_line.Option("max-overlap", "IOU", &arguments.max_overlap,
                      "of two boxes of a class that overlap more the surer stays");
  if (!command_line.Parse()) return false;
  CheckNetworkEvaluation(arguments.common, {"train", "val", "test"});
  CheckInRange("--threshold", arguments.threshold, 0.001, 1.0);
  CheckInRange("--max-overlap", arguments.max_overlap, 0.0, 1.0);
  return true;
}

// Colour, truth and prediction of the best, the median and the worst image.
cv::Mat DrawExamples(const std::vector<BoxedImage>& images, const std::vector<double>& scores,
                     const BoxCounting& counting, double threshold,
                     const LabelVocabulary& vocabulary, Detector& detector) {
  std::vector<FigurePanel> panels;
  for (const Example& chosen : ChooseExamples(scores)) {
    const BoxedImage& image = images[chosen.index];
    const cv::Mat colour = ReadColourImage(image.image_path);
    const auto draw = [&](const std::vector<ClassBox>& boxes) {
      const Detections shown =
          counting.ToDetections(boxes, threshold, colour.size(), vocabulary.hash());
      return DrawDetections(colour, ColourOrder::kBgr, shown, vocabulary);
    };
    const Detections found = detector.Detect(colour, ColourOrder::kBgr, Stamp{});
    panels.push_back({ExampleTitle(chosen, "F1", image.image_path), colour});
    panels.push_back({"truth", draw(counting.ReadTruth(image, colour.size()).boxes)});
    panels.push_back({"prediction", draw(counting.FoundBoxes(found.boxes))});
  }
  return ComposeFigure(panels, 3);
}

void WriteFigures(const DetectionEvaluation& evaluation, const ClassList& classes,
                  const NetworkEvaluationOptions& options) {
  const std::string title = "Boxes, " + fs::path(options.card).stem().string();
  WritePlot(DrawConfusion(evaluation.confusion, classes.names, kBackground, title),
            fs::path(*options.output) / "confusion.png");
  WritePlot(DrawPrecisionRecall(evaluation.score, classes.names),
            fs::path(*options.output) / "precision_recall.png");
}

int Run(CommandLine& command_line) {
  Arguments arguments;
  if (!ParseArguments(command_line, arguments)) return EXIT_SUCCESS;
  const NetworkEvaluationOptions& options = arguments.common;

  const LabelVocabulary vocabulary =
      LabelVocabulary::Load(ConfigFile(options.labels, "labels.yaml"));
  const Model model = LoadModel(options.card, options.models);
  const ClassList classes = FindClasses(options, model, vocabulary);
  const std::vector<BoxedImage> images =
      Spread(FindBoxedImages(options.sets, options.split, model.card, vocabulary), options.images);
  const BoxCounting counting(classes, model.card.input, arguments.max_overlap);
  Detector detector(model, vocabulary, options.network,
                    OptionsForEvaluation(arguments.max_overlap));
  ProgressBar progress("detecting", images.size());
  const DetectionEvaluation evaluation =
      EvaluateDetection(images, counting, classes.size(), arguments.threshold, detector,
                        [&](std::size_t done) { progress.Update(done); });

  const nlohmann::ordered_json json = ToJson(evaluation, classes);
  if (options.output) {
    WriteFigures(evaluation, classes, options);
    const cv::Mat examples = DrawExamples(images, evaluation.image_f1s, counting,
                                          arguments.threshold, vocabulary, detector);
    WritePlot(examples, fs::path(*options.output) / "examples.png");
    WriteJson(json, fs::path(*options.output) / "detection.json");
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
