// Shows what a simulated world looks like: a figure to look at, not to read.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/check.h"
#include "semantic_slam/control/waypoint_file.h"
#include "semantic_slam/segmentation/segmentation_overlay.h"
#include "semantic_slam/simulation/camera_path.h"
#include "semantic_slam/simulation/simulated_camera.h"
#include "semantic_slam/worlds/world_file.h"
#include "tools/command_line.h"
#include "tools/config_folder.h"
#include "tools/overview_figure.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Draws a simulated world into one picture: views along a tour, each with its labels and its\n"
    "depth beside it, as the drone's camera measures them.";

constexpr double kFarM = 6.0;  // the colour scale's end

struct Arguments {
  std::string world;
  std::string tour;
  std::string out;
  int views = 4;
};

cv::Mat DrawLabels(const RenderedView& view, const LabelVocabulary& vocabulary) {
  Segmentation segmentation;
  segmentation.vocabulary_hash = vocabulary.hash();
  for (int i = 0; i < kTopLabels; ++i) {
    segmentation.labels[i] = i == 0 ? view.labels : cv::Mat::zeros(view.labels.size(), CV_8UC1);
    segmentation.confidences[i] =
        cv::Mat(view.labels.size(), CV_8UC1, cv::Scalar(i == 0 ? 255 : 0));
  }
  return DrawSegmentation(view.colour, ColourOrder::kBgr, segmentation, vocabulary);
}

// Red near, blue far, black where there is no return.
cv::Mat DrawDepth(const cv::Mat& depth_m) {
  const cv::Mat has_no_return = depth_m != depth_m;
  cv::Mat finite = depth_m.clone(), grey, colours;
  finite.setTo(kFarM, has_no_return);
  finite.convertTo(grey, CV_8UC1, -255.0 / kFarM, 255.0);
  cv::applyColorMap(grey, colours, cv::COLORMAP_TURBO);
  colours.setTo(cv::Scalar::all(0), has_no_return);
  return colours;
}

std::vector<FigurePanel> Panels(const Arguments& arguments, const LabelVocabulary& vocabulary) {
  const auto world =
      std::make_shared<const World>(LoadWorld(FindInConfig(arguments.world, "worlds"), vocabulary));
  const Tour tour = LoadTour(FindInConfig(arguments.tour, "tours"));
  const Trajectory path = FlyTour(tour, SimulatedFlightOptions(), Stamp{}).T_world_camera;
  if (path.empty()) throw ConfigError(arguments.tour + " has no waypoints");
  const SimulatedCamera camera(std::make_shared<const SceneRenderer>(world),
                               LoadCameraConfig(ConfigFile("", "simulated_d455.yaml")).intrinsics,
                               SimulatedCameraOptions());
  std::vector<FigurePanel> panels;
  for (int i = 0; i < arguments.views; ++i) {
    const StampedPose& at = path[path.size() * i / arguments.views];
    const SimulatedImage image = camera.Capture(at.pose, at.stamp, at.stamp.seconds());
    panels.push_back({"after " + std::to_string(static_cast<int>(at.stamp.seconds())) + " s",
                      image.measured.colour});
    panels.push_back({"labels", DrawLabels(image.truth, vocabulary)});
    panels.push_back({"depth, 0 to 6 m", DrawDepth(image.measured.depth_m)});
  }
  return panels;
}

int DrawWorld(CommandLine& command_line) {
  Arguments arguments;
  command_line.Argument("WORLD", &arguments.world,
                        "world file, or the name of one in config/worlds");
  command_line.Argument("TOUR", &arguments.tour, "tour, or the name of one in config/tours");
  command_line.Argument("OUT", &arguments.out, "picture to write: .png or .jpg");
  command_line.Option("views", "N", &arguments.views, "how many, evenly along the tour");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  CheckInRange("--views", arguments.views, 1, 50);
  const std::string kind = std::filesystem::path(arguments.out).extension();
  if (kind != ".png" && kind != ".jpg") {
    throw ConfigError("OUT = " + arguments.out + ", expected a name that ends in .png or .jpg");
  }
  const LabelVocabulary vocabulary = LabelVocabulary::Load(ConfigFile("", "labels.yaml"));
  const cv::Mat figure = ComposeFigure(Panels(arguments, vocabulary), 3);
  if (!cv::imwrite(arguments.out, figure)) throw InputError("cannot write " + arguments.out);
  std::cout << arguments.out << ": " << arguments.views << " views\n";
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::DrawWorld);
}
