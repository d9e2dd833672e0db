#include "semantic_slam/dnn/model_card.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

constexpr char kInput[] = "input: {width: 64, height: 48, colour: bgr, scale: 1, fit: stretch}\n";
constexpr char kLabels[] = "labels: {file: a.names}\n";

std::string Card(const std::string& input, const std::string& head, const std::string& rest) {
  return "file: a.onnx\n" + input + "head: " + head + "\n" + rest;
}

std::string HeadCard(const std::string& head) {
  return Card(kInput, head, kLabels);
}

class ModelCardTest : public testing::Test {
 protected:
  ModelCard Read(const std::string& yaml) {
    return ReadModelCard(folder_.Write("card.yaml", yaml));
  }

  std::string ErrorOf(const std::string& yaml) {
    std::string message = MessageOf<ConfigError>([&] { Read(yaml); });
    const std::size_t at = message.find(folder_.path());
    return at == std::string::npos ? message : message.erase(at, folder_.path().size() + 1);
  }

  TemporaryFolder folder_;
};

TEST_F(ModelCardTest, ReadsEveryKey) {
  const ModelCard card = Read(
      "file: nets/a.onnx\n"
      "sha256: 0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef\n"
      "licence: MIT\n"
      "input: {name: data, width: 64, height: 48, colour: rgb, scale: 0.5, mean: [1, 2, 3],\n"
      "        std: [4, 5, 6], fit: letterbox, pad: 114}\n"
      "outputs: [boxes, scores]\n"
      "head: {type: yolo, box: xyxy, units: normalised, objectness: separate, transposed: true,\n"
      "       activation: sigmoid, strides: [8, 16], anchors: [[1, 2, 3, 4], [5, 6, 7, 8]]}\n"
      "labels: {file: a.names, map: {couch: sofa, tv: tv}}\n");
  EXPECT_EQ(card.file, "nets/a.onnx");
  EXPECT_EQ(card.sha256.substr(0, 6), "012345");
  EXPECT_EQ(card.licence, "MIT");
  EXPECT_EQ(card.input.name, "data");
  EXPECT_EQ(card.input.size(), cv::Size(64, 48));
  EXPECT_EQ(card.input.colour, ColourOrder::kRgb);
  EXPECT_EQ(card.input.scale, 0.5);
  EXPECT_EQ(card.input.mean, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(card.input.std, (std::array<double, 3>{4, 5, 6}));
  EXPECT_EQ(card.input.fit, FitMode::kLetterbox);
  EXPECT_EQ(card.input.pad, 114);
  EXPECT_EQ(card.outputs, (std::vector<std::string>{"boxes", "scores"}));
  EXPECT_EQ(card.head.type, HeadType::kYolo);
  EXPECT_EQ(card.head.box, BoxFormat::kXyxy);
  EXPECT_EQ(card.head.units, BoxUnits::kNormalised);
  EXPECT_EQ(card.head.objectness, Objectness::kSeparate);
  EXPECT_TRUE(card.head.transposed);
  EXPECT_EQ(card.head.activation, Activation::kSigmoid);
  EXPECT_EQ(card.head.strides, (std::vector<float>{8, 16}));
  ASSERT_EQ(card.head.anchors.size(), 2u);
  EXPECT_EQ(card.head.anchors[1], (std::vector<cv::Size2f>{{5, 6}, {7, 8}}));
  EXPECT_EQ(card.labels_file, "a.names");
  EXPECT_EQ(card.label_map.at("couch"), "sofa");
}

TEST_F(ModelCardTest, DefaultsDependOnTheHead) {
  const ModelCard segmentation = Read(HeadCard("{type: segmentation}"));
  EXPECT_EQ(segmentation.head.activation, Activation::kSoftmax);
  EXPECT_EQ(segmentation.input.fit, FitMode::kStretch);
  EXPECT_EQ(segmentation.input.mean, (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(segmentation.input.std, (std::array<double, 3>{1, 1, 1}));
  const ModelCard yolo = Read(HeadCard("{type: yolo}"));
  EXPECT_EQ(yolo.head.activation, Activation::kNone);
  EXPECT_EQ(yolo.head.box, BoxFormat::kCxcywh);
  EXPECT_EQ(yolo.head.units, BoxUnits::kPixels);
  EXPECT_EQ(yolo.head.objectness, Objectness::kNone);
  EXPECT_EQ(Read(HeadCard("{type: ssd}")).head.units, BoxUnits::kNormalised);
}

TEST_F(ModelCardTest, AReidentificationNetworkHasNoLabels) {
  EXPECT_EQ(Read(Card(kInput, "{type: reid}", "")).labels_file, "");
  ExpectOneLineWith(ErrorOf(HeadCard("{type: reid}")), {"card.yaml:4: unknown key labels"});
}

TEST_F(ModelCardTest, RefusesUnknownKeysByLine) {
  ExpectOneLineWith(ErrorOf("file: a\nweight: b\n" + std::string(kInput) +
                            "head: {type: segmentation}\n" + kLabels),
                    {"card.yaml:2: unknown key weight"});
  ExpectOneLineWith(
      ErrorOf(Card("input:\n  width: 1\n  height: 1\n  colour: rgb\n  scale: 1\n  fit: stretch\n"
                   "  scaling: 2\n",
                   "{type: segmentation}", kLabels)),
      {"card.yaml:8: unknown key input/scaling"});
  ExpectOneLineWith(ErrorOf(HeadCard("{type: segmentation, box: xyxy}")),
                    {"card.yaml:3: unknown key head/box"});
  ExpectOneLineWith(ErrorOf(Card(kInput, "{type: ssd}", "labels: {file: a, mapping: {}}\n")),
                    {"card.yaml:4: unknown key labels/mapping"});
}

TEST_F(ModelCardTest, NamesMissingKeys) {
  EXPECT_EQ(ErrorOf("input: {}\n"), "card.yaml: missing key file");
  EXPECT_EQ(ErrorOf("file: a\n"), "card.yaml: missing key input/width");
  EXPECT_EQ(ErrorOf(Card(kInput, "{}", kLabels)), "card.yaml: missing key head/type");
  EXPECT_EQ(ErrorOf(Card(kInput, "{type: yolo}", "")), "card.yaml: missing key labels/file");
  // What would ruin the results without a word must be said.
  for (const char* key : {"width", "height", "colour", "scale", "fit"}) {
    std::string input = "input: {width: 1, height: 1, colour: rgb, scale: 1, fit: stretch}\n";
    input.insert(input.find(key), "no_");
    EXPECT_EQ(ErrorOf(Card(input, "{type: yolo}", kLabels)),
              std::string("card.yaml: missing key input/") + key);
  }
}

TEST_F(ModelCardTest, RefusesValuesByLineAndSaysWhatIsExpected) {
  EXPECT_EQ(ErrorOf(HeadCard("{type: mask}")),
            "card.yaml:3: head/type = mask, but must be segmentation or yolo or ssd or reid");
  EXPECT_EQ(ErrorOf(HeadCard("{type: yolo, activation: softmax}")),
            "card.yaml:3: head/activation = softmax, but must be none or sigmoid");
  EXPECT_EQ(ErrorOf(HeadCard("{type: yolo, transposed: 7}")),
            "card.yaml:3: head/transposed = 7 has the wrong type");
  const auto input_error = [&](const std::string& keys) {
    return ErrorOf(Card("input: {" + keys + "}\n", "{type: yolo}", kLabels));
  };
  EXPECT_EQ(input_error("width: 0, height: 1"),
            "card.yaml:2: input/width = 0, but must be in [1, 8192]");
  EXPECT_EQ(input_error("width: 1, height: many"),
            "card.yaml:2: input/height = many has the wrong type");
  EXPECT_EQ(input_error("width: 1, height: 1, colour: grey"),
            "card.yaml:2: input/colour = grey, but must be rgb or bgr");
  const std::string good = "width: 1, height: 1, colour: rgb, fit: stretch, ";
  EXPECT_EQ(input_error(good + "scale: .nan"),
            "card.yaml:2: input/scale = .nan, but must be a positive number");
  EXPECT_EQ(input_error(good + "scale: 1, mean: [1, 2]"),
            "card.yaml:2: input/mean = [1, 2], but must be three numbers");
  EXPECT_EQ(input_error(good + "scale: 1, std: [1, 0, 1]"),
            "card.yaml:2: input/std = [1, 0, 1], but must be three positive numbers");
  EXPECT_EQ(input_error(good + "scale: 1, pad: 256"),
            "card.yaml:2: input/pad = 256, but must be in [0, 255]");
}

TEST_F(ModelCardTest, RefusesAnchorsThatDoNotFitTheStrides) {
  ExpectOneLineWith(ErrorOf(HeadCard("{type: yolo, strides: [8]}")),
                    {"card.yaml:3: head/strides = ", "one list of anchors per stride"});
  ExpectOneLineWith(ErrorOf(HeadCard("{type: yolo, anchors: [[1, 2]]}")),
                    {"card.yaml:3: head/anchors = ", "one list of anchors per stride"});
  ExpectOneLineWith(ErrorOf(HeadCard("{type: yolo, strides: [8], anchors: [[1, 2, 3]]}")),
                    {"head/anchors = ", "width, height"});
  ExpectOneLineWith(ErrorOf(HeadCard("{type: yolo, strides: [-8], anchors: [[1, 2]]}")),
                    {"head/strides = ", "positive"});
}

TEST_F(ModelCardTest, RefusesAHashThatIsNone) {
  ExpectOneLineWith(ErrorOf("sha256: 12\n" + HeadCard("{type: yolo}")),
                    {"card.yaml:1: sha256 = 12, but must be 64 hexadecimal digits"});
}

TEST_F(ModelCardTest, NamesAMissingCard) {
  EXPECT_EQ(MessageOf<ConfigError>([] { ReadModelCard("/nowhere/card.yaml"); }),
            "cannot open configuration file /nowhere/card.yaml");
}

}  // namespace
}  // namespace semantic_slam
