#include "semantic_slam/dnn/network.h"

#include <gtest/gtest.h>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/shared_data.h"
#include "testing/temporary_folder.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

std::string ErrorOf(const Model& model, const NetworkOptions& options = {}) {
  return MessageOf<ConfigError>([&] { Network(model, options); });
}

std::vector<std::uint8_t> BytesOf(const cv::Mat& array) {
  return {array.ptr(), array.ptr() + array.total() * array.elemSize()};
}

TEST(NetworkTest, RunsAndSaysWhatItGives) {
  Network network(ColourSegmenter(), {});
  ASSERT_EQ(network.output_shapes().size(), 1u);
  EXPECT_EQ(ToString(network.output_shapes()[0]), "1 x 4 x 24 x 32");
  // Pure red: 10 * 1 - 5 for red, -10 * 1 - 5 for green.
  const cv::Mat red(24, 32, CV_8UC3, cv::Scalar(0, 0, 255));
  const cv::Mat& scores = network.Forward(red, ColourOrder::kBgr)[0];
  EXPECT_NEAR(scores.ptr<float>(0, 0, 5)[7], 5.0f, 1e-4);  // single precision
  EXPECT_NEAR(scores.ptr<float>(0, 1, 5)[7], -15.0f, 1e-4);
}

TEST(NetworkTest, KeepsToTheInputOfItsCard) {
  const Network network(ColourSegmenter(), {});
  EXPECT_EQ(network.FitOf({640, 480}).content(), cv::Rect(0, 0, 32, 24));
  EXPECT_EQ(network.FitOf({320, 120}).content(), cv::Rect(0, 6, 32, 12));
}

TEST(NetworkTest, RefusesImagesThatAreNone) {
  Network network(ColourSegmenter(), {});
  ExpectOneLineWith(MessageOf<InputError>([&] { network.Forward({}, ColourOrder::kBgr); }),
                    {"network input", "0 x 0 px"});
}

TEST(NetworkTest, NamesAFileThatIsNoNetwork) {
  const TemporaryFolder folder;
  Model model = ColourSegmenter();
  model.weights_path.clear();
  for (const std::string& content : {std::string(), std::string(1000, 'x')}) {
    model.network_path = folder.Write("net.onnx", content);
    ExpectOneLineWith(ErrorOf(model), {"colour_segmenter.yaml: cannot load ", "net.onnx"});
  }
}

TEST(NetworkTest, RefusesInputsAndOutputsThatAreNotThere) {
  Model model = ColourSegmenter();
  model.card.outputs = {"probabilities"};
  ExpectOneLineWith(ErrorOf(model),
                    {"colour_segmenter.cfg does not run", "its outputs are: conv_0"});
  model = ColourSegmenter();
  model.card.input.name = "picture";
  ExpectOneLineWith(ErrorOf(model), {"colour_segmenter.cfg does not run", "picture"});
}

TEST(NetworkTest, RefusesABackendThatIsNotThere) {
  NetworkOptions options;
  options.backend = "abacus";
  ExpectOneLineWith(ErrorOf(ColourSegmenter(), options),
                    {"backend = abacus, but must be one that this OpenCV has: cpu"});
}

TEST(NetworkTest, RefusesAnImpossibleNumberOfThreads) {
  NetworkOptions options;
  options.threads = -1;
  EXPECT_EQ(ErrorOf(ColourSegmenter(), options), "threads = -1, but must be in [0, 256]");
}

TEST(NetworkTest, ShapesOfSeveralOutputsAreListed) {
  EXPECT_EQ(ToString(std::vector<Shape>{{1, 84, 10}, {}, {5}}), "1 x 84 x 10, , 5");
}

// What makes the outputs of the whole program independent of the number of cores.
TEST(NetworkTest, OutputsDoNotDependOnTheNumberOfThreads) {
  const auto models = SharedData("models");
  SEMANTIC_SLAM_SKIP_WITHOUT(models, "the models folder");
  const cv::Mat photo = cv::imread(*models + "/photos_coco8/000000000009.jpg");
  ASSERT_FALSE(photo.empty());
  const int threads_before = cv::getNumThreads();
  for (const char* card : {"deeplabv3p_mnv2_ade20k32_320x240", "yolov8n_coco_320x256"}) {
    const Model model =
        LoadModel(SEMANTIC_SLAM_SOURCE_DIR "/config/cards/" + std::string(card) + ".yaml", *models);
    std::vector<std::vector<std::uint8_t>> results;
    for (const int threads : {1, 2, 3}) {
      NetworkOptions options;
      options.threads = threads;
      results.push_back(BytesOf(Network(model, options).Forward(photo, ColourOrder::kBgr)[0]));
    }
    EXPECT_FALSE(results[0].empty());
    EXPECT_EQ(results[0], results[1]) << card;
    EXPECT_EQ(results[0], results[2]) << card;
  }
  cv::setNumThreads(threads_before);
}

}  // namespace
}  // namespace semantic_slam
