// Puts the four pictures that the nodes leave into one figure.

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/image_decoding.h"
#include "tools/command_line.h"
#include "tools/overview_figure.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Composes camera, segmentation, cloud and map into one two by two figure with titles.";

cv::Mat ReadPicture(const std::string& path) {
  const std::vector<std::uint8_t> bytes = ReadFileBytes(path);
  cv::Mat picture = DecodeImage(bytes.data(), bytes.size(), cv::IMREAD_COLOR);
  if (picture.empty()) throw InputError("cannot read a picture from " + path);
  return picture;
}

int Compose(CommandLine& command_line) {
  std::array<std::string, 4> paths;
  std::string out;
  command_line.Argument("CAMERA", &paths[0], "what the camera saw");
  command_line.Argument("SEGMENTATION", &paths[1], "the labels of its pixels");
  command_line.Argument("CLOUD", &paths[2], "the semantic cloud of that image");
  command_line.Argument("MAP", &paths[3], "the map, seen from there");
  command_line.RequiredOption("out", "OUT.png", &out, "the figure");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  const std::array<const char*, 4> titles{"camera", "segmentation", "semantic cloud", "semantic map"};
  std::array<FigurePanel, 4> panels;
  for (std::size_t i = 0; i < panels.size(); ++i) panels[i] = {titles[i], ReadPicture(paths[i])};
  const cv::Mat figure = ComposeOverview(panels);
  WriteFileAtomicallyVia(out, [&](const std::string& path) { return cv::imwrite(path, figure); });
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::Compose);
}
