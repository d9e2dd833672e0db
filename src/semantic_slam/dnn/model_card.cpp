#include "semantic_slam/dnn/model_card.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "semantic_slam/common/yaml_options.h"

namespace semantic_slam {
namespace {

constexpr int kMaxSidePx = 8192;
constexpr std::size_t kSha256Digits = 64;

template <typename Choice>
using Choices = std::initializer_list<std::pair<const char*, Choice>>;

// Leaves `value` alone if the key is absent; refuses a word that is not among the choices.
template <typename Choice>
void ReadChoice(YamlReader& reader, const char* key, Choices<Choice> choices, Choice& value) {
  if (!reader.Has(key)) return;
  const auto word = reader.Require<std::string>(key);
  std::string expected;
  for (const auto& [name, choice] : choices) {
    if (word == name) {
      value = choice;
      return;
    }
    expected += (expected.empty() ? "" : " or ") + std::string(name);
  }
  reader.Refuse(key, expected);
}

template <typename Choice>
Choice RequireChoice(YamlReader& reader, const char* key, Choices<Choice> choices) {
  reader.Require<std::string>(key);
  Choice value{};
  ReadChoice(reader, key, choices, value);
  return value;
}

int RequireInt(YamlReader& reader, const char* key, int low, int high) {
  const int value = reader.Require<int>(key);
  if (value < low || value > high) {
    reader.Refuse(key, "in [" + std::to_string(low) + ", " + std::to_string(high) + "]");
  }
  return value;
}

// NaN is not positive.
bool IsPositive(double value) {
  return value > 0.0 && std::isfinite(value);
}

void ReadTriple(YamlReader& reader, const char* key, std::array<double, 3>& triple) {
  if (!reader.Has(key)) return;
  const auto values = reader.Require<std::vector<double>>(key);
  const bool finite =
      std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (values.size() != triple.size() || !finite) reader.Refuse(key, "three numbers");
  std::copy(values.begin(), values.end(), triple.begin());
}

NetworkInput ReadInput(YamlReader reader) {
  NetworkInput input;
  reader.Read("name", input.name);
  input.width_px = RequireInt(reader, "width", 1, kMaxSidePx);
  input.height_px = RequireInt(reader, "height", 1, kMaxSidePx);
  input.colour = RequireChoice<ColourOrder>(
      reader, "colour", {{"rgb", ColourOrder::kRgb}, {"bgr", ColourOrder::kBgr}});
  input.scale = reader.Require<double>("scale");
  if (!IsPositive(input.scale)) reader.Refuse("scale", "a positive number");
  ReadTriple(reader, "mean", input.mean);
  ReadTriple(reader, "std", input.std);
  if (!std::all_of(input.std.begin(), input.std.end(), IsPositive)) {
    reader.Refuse("std", "three positive numbers");
  }
  input.fit = RequireChoice<FitMode>(
      reader, "fit", {{"letterbox", FitMode::kLetterbox}, {"stretch", FitMode::kStretch}});
  if (reader.Has("pad")) input.pad = RequireInt(reader, "pad", 0, 255);
  reader.Finish();
  return input;
}

// Pairs of width and height, as YOLOv5's model files list them.
std::vector<cv::Size2f> ToAnchors(const YamlReader& reader, const std::vector<float>& numbers) {
  if (numbers.empty() || numbers.size() % 2 != 0 ||
      !std::all_of(numbers.begin(), numbers.end(), IsPositive)) {
    reader.Refuse("anchors", "lists of positive numbers: width, height, width, height...");
  }
  std::vector<cv::Size2f> anchors;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    anchors.emplace_back(numbers[i], numbers[i + 1]);
  }
  return anchors;
}

void ReadGrids(YamlReader& reader, NetworkHead& head) {
  reader.Read("strides", head.strides);
  if (!std::all_of(head.strides.begin(), head.strides.end(), IsPositive)) {
    reader.Refuse("strides", "a list of positive numbers");
  }
  std::vector<std::vector<float>> anchors;
  reader.Read("anchors", anchors);
  for (const std::vector<float>& numbers : anchors) {
    head.anchors.push_back(ToAnchors(reader, numbers));
  }
  if (head.anchors.size() != head.strides.size()) {
    reader.Refuse(reader.Has("anchors") ? "anchors" : "strides",
                  "given together: one list of anchors per stride");
  }
}

void ReadYoloHead(YamlReader& reader, NetworkHead& head) {
  ReadChoice<BoxFormat>(reader, "box", {{"cxcywh", BoxFormat::kCxcywh}, {"xyxy", BoxFormat::kXyxy}},
                        head.box);
  ReadChoice<BoxUnits>(reader, "units",
                       {{"pixels", BoxUnits::kPixels}, {"normalised", BoxUnits::kNormalised}},
                       head.units);
  ReadChoice<Objectness>(reader, "objectness",
                         {{"none", Objectness::kNone},
                          {"separate", Objectness::kSeparate},
                          {"included", Objectness::kIncluded}},
                         head.objectness);
  reader.Read("transposed", head.transposed);
  ReadChoice<Activation>(reader, "activation",
                         {{"none", Activation::kNone}, {"sigmoid", Activation::kSigmoid}},
                         head.activation);
  ReadGrids(reader, head);
}

NetworkHead ReadHead(YamlReader reader) {
  NetworkHead head;
  head.type = RequireChoice<HeadType>(reader, "type",
                                      {{"segmentation", HeadType::kSegmentation},
                                       {"yolo", HeadType::kYolo},
                                       {"ssd", HeadType::kSsd},
                                       {"reid", HeadType::kReid}});
  if (head.type == HeadType::kSegmentation) {
    head.activation = Activation::kSoftmax;
    ReadChoice<Activation>(reader, "activation",
                           {{"softmax", Activation::kSoftmax}, {"none", Activation::kNone}},
                           head.activation);
  } else if (head.type == HeadType::kYolo) {
    ReadYoloHead(reader, head);
  } else if (head.type == HeadType::kSsd) {
    head.box = BoxFormat::kXyxy;
    head.units = BoxUnits::kNormalised;
    ReadChoice<BoxUnits>(reader, "units",
                         {{"pixels", BoxUnits::kPixels}, {"normalised", BoxUnits::kNormalised}},
                         head.units);
  }
  reader.Finish();
  return head;
}

void ReadLabels(YamlReader reader, ModelCard& card) {
  card.labels_file = reader.Require<std::string>("file");
  reader.Read("map", card.label_map);
  reader.Finish();
}

void ReadSha256(YamlReader& reader, std::string& sha256) {
  if (!reader.Has("sha256")) return;
  reader.Read("sha256", sha256);
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) || (c >= 'a' && c <= 'f'); };
  if (sha256.size() != kSha256Digits || !std::all_of(sha256.begin(), sha256.end(), is_digit)) {
    reader.Refuse("sha256", "64 hexadecimal digits, lower case");
  }
}

}  // namespace

ModelCard ReadModelCard(const std::string& path) {
  YamlReader reader(LoadYamlMap(path), path);
  ModelCard card;
  card.path = path;
  card.file = reader.Require<std::string>("file");
  card.input = ReadInput(reader.Group("input"));
  reader.Read("outputs", card.outputs);
  card.head = ReadHead(reader.Group("head"));
  if (card.head.type != HeadType::kReid) ReadLabels(reader.Group("labels"), card);
  reader.Read("licence", card.licence);
  ReadSha256(reader, card.sha256);
  reader.Finish();
  return card;
}

}  // namespace semantic_slam
