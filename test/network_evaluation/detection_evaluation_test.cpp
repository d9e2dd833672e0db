#include "semantic_slam/network_evaluation/detection_evaluation.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/network_evaluation/model_classes.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

constexpr double kThreshold = 0.5;
constexpr double kMaxOverlap = 0.5;

// Ten times the size of the network's input; its cells are 80 px here, an eighth and a sixth of the
// sides.
const cv::Size kSize(640, 480);

class DetectionEvaluationTest : public ::testing::Test {
 protected:
  // A red block, which the network calls a chair, in a cell of the grid, and a file of true boxes.
  BoxedImage Write(const std::string& name, cv::Point cell, const std::string& boxes) {
    cv::Mat colour(kSize, CV_8UC3, cv::Scalar::all(90));
    colour(cv::Rect(80 * cell.x, 80 * cell.y, 80, 80)) = cv::Scalar(0, 0, 255);
    cv::imwrite(folder_ / (name + ".png"), colour);
    return {folder_ / (name + ".png"), folder_.Write(name + ".txt", boxes), labels_};
  }

  // "number cx cy width height" of a cell of the grid.
  static std::string CellBox(int number, cv::Point cell) {
    return std::to_string(number) + " " + std::to_string((cell.x + 0.5) / 8) + " " +
           std::to_string((cell.y + 0.5) / 6) + " 0.125 0.166667\n";
  }

  DetectionEvaluation Evaluate(const std::vector<BoxedImage>& images) {
    return EvaluateDetection(images, counting_, classes_.size(), kThreshold, detector_,
                             [](std::size_t) {});
  }

  TemporaryFolder folder_;
  const std::shared_ptr<const std::vector<LabelId>> labels_ =
      std::make_shared<const std::vector<LabelId>>(
          std::vector<LabelId>{LabelOf("chair"), LabelOf("tv"), LabelOf("desk")});
  const Model model_ = BlockDetector();
  const ClassList classes_ = ClassesOfModel(model_, Vocabulary());  // chair, tv
  const BoxCounting counting_{classes_, model_.card.input, kMaxOverlap};
  Detector detector_{model_, Vocabulary(), {}, OptionsForEvaluation(kMaxOverlap)};
};

TEST_F(DetectionEvaluationTest, CountsWhatIsFoundMissedAndConfused) {
  const DetectionEvaluation evaluation = Evaluate({
      Write("right", {2, 3}, CellBox(0, {2, 3})),
      Write("confused", {2, 3}, CellBox(1, {2, 3})),                      // truly a tv
      Write("ignored", {2, 3}, CellBox(0, {2, 3}) + CellBox(2, {5, 1})),  // desks do not count
  });
  EXPECT_EQ(evaluation.score.truths(0), 2);
  EXPECT_EQ(evaluation.score.truths(1), 1);
  const DetectionRates rates = evaluation.score.At(kThreshold).rates;
  EXPECT_EQ(rates.hits, 2);
  EXPECT_EQ(rates.extras, 1);
  EXPECT_EQ(rates.misses, 1);
  EXPECT_EQ(evaluation.confusion.count(0, 0), 2);
  EXPECT_EQ(evaluation.confusion.count(1, 0), 1);
  EXPECT_EQ(evaluation.image_f1s, (std::vector<double>{1.0, 0.0, 1.0}));
  EXPECT_EQ(evaluation.timing.count, 3);
}

TEST_F(DetectionEvaluationTest, TrueBoxesThatTheNetworkCannotSeeAreLeftOut) {
  // 3 px of the network's input are 30 px here, 0.0469 of the width.
  const BoxedImage image = Write("small", {2, 3}, "0 0.5 0.5 0.046 0.5\n0 0.5 0.5 0.048 0.5\n");
  EXPECT_EQ(counting_.ReadTruth(image, kSize).boxes.size(), 1u);
}

TEST_F(DetectionEvaluationTest, ObjectsOfWhichTooLittleIsVisibleAreOptional) {
  ClassList classes = classes_;
  classes.least_visible_share = 0.5;
  const BoxCounting counting(classes, model_.card.input, kMaxOverlap);
  std::string hidden = CellBox(0, {2, 3}), clear = CellBox(0, {4, 1});
  hidden.insert(hidden.size() - 1, " 0.4");
  clear.insert(clear.size() - 1, " 0.6");
  const BoxedImage image = Write("hidden", {2, 3}, hidden + clear);
  const ImageTruth truth = counting.ReadTruth(image, kSize);
  EXPECT_EQ(truth.optional.size(), 1u);
  EXPECT_EQ(truth.boxes.size(), 1u);
}

TEST_F(DetectionEvaluationTest, WhatIsFoundOnAnOptionalObjectDoesNotCount) {
  ClassList classes = classes_;
  classes.is_optional[LabelOf("desk")] = true;
  const BoxCounting counting(classes, model_.card.input, kMaxOverlap);
  const BoxedImage image = Write("optional", {2, 3}, CellBox(2, {2, 3}));
  EXPECT_EQ(counting.ReadTruth(image, kSize).optional.size(), 1u);
  const DetectionEvaluation evaluation = EvaluateDetection(
      {image}, counting, classes.size(), kThreshold, detector_, [](std::size_t) {});
  EXPECT_EQ(evaluation.score.At(kThreshold).rates.extras, 0);
  EXPECT_EQ(Evaluate({image}).score.At(kThreshold).rates.extras, 1);
}

TEST_F(DetectionEvaluationTest, OfMergedLabelsThatOverlapTheSurestStays) {
  ClassList classes = classes_;
  classes.of_label[LabelOf("tv")] = classes.of_label[LabelOf("chair")];
  const BoxCounting counting(classes, model_.card.input, kMaxOverlap);
  const cv::Rect2f box(0.0f, 0.0f, 50.0f, 50.0f);
  const std::vector<ClassBox> found = counting.FoundBoxes(
      {{LabelOf("tv"), 0.9f, box}, {LabelOf("chair"), 0.8f, box}, {LabelOf("desk"), 0.7f, box}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].confidence, 0.9f);
  const Detections shown = counting.ToDetections(found, 0.5, kSize, Vocabulary().hash());
  ASSERT_EQ(shown.boxes.size(), 1u);
  EXPECT_EQ(shown.boxes[0].label, LabelOf("chair"));
  EXPECT_TRUE(counting.ToDetections(found, 0.95, kSize, 0).boxes.empty());
}

TEST_F(DetectionEvaluationTest, RefusesAClassThatThereIsNot) {
  const BoxedImage image = Write("image", {2, 3}, CellBox(3, {2, 3}));
  const std::string error = MessageOf<InputError>([&] { Evaluate({image}); });
  ExpectOneLineWith(error, {"image.txt", "class 3", "0 to 2"});
}

TEST_F(DetectionEvaluationTest, AnImageWithoutAFileHasNoObjects) {
  BoxedImage image = Write("image", {2, 3}, "");
  image.boxes_path = folder_ / "missing.txt";
  const DetectionEvaluation evaluation = Evaluate({image});
  EXPECT_EQ(evaluation.score.At(kThreshold).rates.extras, 1);
  EXPECT_TRUE(std::isnan(evaluation.score.MeanAp50()));
}

}  // namespace
}  // namespace semantic_slam
