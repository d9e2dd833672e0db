// Renders images of random rooms, with their truth, to train networks on or to judge them by.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/check.h"
#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/random_worlds/choice.h"
#include "semantic_slam/random_worlds/random_cameras.h"
#include "semantic_slam/random_worlds/random_world.h"
#include "semantic_slam/simulation/colour_noise.h"
#include "semantic_slam/simulation/exposure.h"
#include "semantic_slam/simulation/rendered_sequence_writer.h"
#include "semantic_slam/simulation/scene_renderer.h"
#include "semantic_slam/simulation/visible_boxes.h"
#include "tools/background_writer.h"
#include "tools/command_line.h"
#include "tools/config_folder.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

constexpr char kPurpose[] =
    "Renders images of random furnished rooms, with labels, instances and boxes, below the folder "
    "OUT:\n"
    "a sequence for each world. Worlds for validation have furniture, patterns and textures that "
    "those\n"
    "for training never have. What is there already is kept, so that the same command goes on "
    "where it\n"
    "stopped. The same seed gives the same bytes.";

constexpr std::int64_t kBetweenNs = 1'000'000'000;  // images of a sequence, which begins with that
constexpr int kPreview = 10;  // times smaller: to see whether an image is worth while
constexpr int kTriesPerImage = 20;

struct Arguments {
  std::string out;
  std::string split = "training";
  std::string size = "480x360";
  std::string labels;
  int worlds = 150;
  int images = 40;
  int seed = 1;
  bool depth = false;
};

// nullopt after printing the help.
std::optional<Arguments> ParseArguments(CommandLine& command_line) {
  Arguments arguments;
  command_line.Argument("OUT", &arguments.out, "folder");
  command_line.Option("split", "SPLIT", &arguments.split, "training or validation");
  command_line.Option("worlds", "N", &arguments.worlds, "buildings, with a folder each");
  command_line.Option("images", "N", &arguments.images, "per world");
  command_line.Option("size", "WxH", &arguments.size, "of the images [px]");
  command_line.Option("seed", "N", &arguments.seed, "of everything");
  command_line.Flag("depth", &arguments.depth, "write exact depth, too");
  command_line.Option("labels", "LABELS.yaml", &arguments.labels,
                      "the vocabulary; default: config/labels.yaml");
  if (!command_line.Parse()) return std::nullopt;
  CheckInRange("--worlds", arguments.worlds, 1, 100000);
  CheckInRange("--images", arguments.images, 1, 10000);
  CheckInRange("--seed", arguments.seed, 0, 1000000);
  return arguments;
}

cv::Size ParseSize(const std::string& text) {
  cv::Size size;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) != 2) {
    throw ConfigError("--size = '" + text + "', expected WxH such as 480x360");
  }
  CheckInRange("--size's width", size.width, 64, 4096);
  CheckInRange("--size's height", size.height, 64, 4096);
  return size;
}

// A pinhole camera that sees more or less of the world.
CameraIntrinsics RandomIntrinsics(const cv::Size& size, RandomStream& random) {
  const double f_px = size.width * Between(random, 0.6, 1.0);
  return {size.width, size.height, f_px, f_px, 0.5 * (size.width - 1), 0.5 * (size.height - 1), {}};
}

CameraIntrinsics PreviewOf(const CameraIntrinsics& intrinsics) {
  const int width = std::max(16, intrinsics.width_px / kPreview);
  const int height = std::max(12, intrinsics.height_px / kPreview);
  const double f_px = intrinsics.fx_px * width / intrinsics.width_px;
  return {width, height, f_px, f_px, 0.5 * (width - 1), 0.5 * (height - 1), {}};
}

// Of everything that a view shows, how much is building, and how much of it is close by.
struct ViewContent {
  double building = 0.0;
  double near_building = 0.0;
};

ViewContent ContentOf(const RenderedView& view, const World& world) {
  constexpr float kNearM = 0.6f;
  ViewContent content;
  for (int v = 0; v < view.instances.rows; ++v) {
    for (int u = 0; u < view.instances.cols; ++u) {
      const InstanceId instance = view.instances.at<InstanceId>(v, u);
      if (instance != kNoInstance && !world.objects[instance - 1].is_structure) continue;
      content.building += 1.0;
      if (view.depth_m.at<float>(v, u) < kNearM) content.near_building += 1.0;
    }
  }
  const auto pixels = static_cast<double>(view.instances.total());
  return {content.building / pixels, content.near_building / pixels};
}

// Renders the images of one world.
class WorldPhotographer {
 public:
  WorldPhotographer(std::shared_ptr<const World> world, const LabelVocabulary& vocabulary,
                    const CameraIntrinsics& intrinsics, bool with_depth, std::uint64_t seed)
      : world_(world),
        renderer_(world),
        camera_(intrinsics),
        preview_camera_(PreviewOf(intrinsics)),
        cameras_(*world, vocabulary, HashOf({seed, 1})),
        random_(HashOf({seed, 2})),
        with_depth_(with_depth) {}

  const CameraModel& camera() const { return camera_; }

  // T_world_camera of the next image; nullopt if there is no place for it.
  std::optional<Rigid3d> NextPose() {
    std::optional<Rigid3d> pose;
    for (int i = 0; i < kTriesPerImage; ++i) {
      pose = cameras_.Next();
      if (!pose || IsWorthwhile(*pose)) break;
    }
    return pose;
  }

  SimulatedImage Photograph(const Rigid3d& T_world_camera, Stamp stamp) {
    SimulatedImage image;
    image.truth = renderer_.Render(T_world_camera, camera_, 0.0);
    image.measured.stamp = image.measured.depth_stamp = stamp;
    const cv::Mat exposed = Expose(image.truth.colour, RandomGains(image.truth.colour));
    image.measured.colour = ColourNoise(RandomNoise()).Apply(exposed, stamp);
    if (with_depth_) image.measured.depth_m = image.truth.depth_m;
    return image;
  }

 private:
  // Few images are of one wall close by, or of hardly anything but the building.
  bool IsWorthwhile(const Rigid3d& T_world_camera) {
    const RenderedView view = renderer_.Render(T_world_camera, preview_camera_, 0.0);
    const ViewContent content = ContentOf(view, *world_);
    if (content.near_building > 0.5) return Chance(random_, 0.05);
    return content.building < 0.8 || Chance(random_, 0.15);
  }

  // The camera sets its exposure, more or less, and its white balance.
  Eigen::Vector3f RandomGains(const cv::Mat& colour) {
    const auto mean_pixel = static_cast<float>(Between(random_, 70.0, 165.0));
    const auto gain = static_cast<float>(std::pow(ExposureFor(colour, mean_pixel), 0.8));
    const double warmth = 0.08 * random_.Gaussian();
    const double green = 0.03 * random_.Gaussian();
    return gain *
           Eigen::Vector3d(std::exp(-warmth), std::exp(green), std::exp(warmth)).cast<float>();
  }

  ColourNoiseOptions RandomNoise() {
    ColourNoiseOptions noise;
    noise.read_sigma = Between(random_, 0.2, 3.0);
    noise.shot_sigma = Between(random_, 0.5, 5.0);
    noise.vignetting = Between(random_, 0.0, 0.25);
    noise.seed = WholeBetween(random_, 0, 1000000);
    return noise;
  }

  const std::shared_ptr<const World> world_;
  const SceneRenderer renderer_;
  const CameraModel camera_;
  const CameraModel preview_camera_;
  RandomCameras cameras_;
  RandomStream random_;
  const bool with_depth_;
};

// Everything that the worlds of a set have in common.
struct SetPlan {
  LabelVocabulary vocabulary;
  WorldSplit split = WorldSplit::kTraining;
  cv::Size size;
  VisibleBoxesOptions boxes;
};

void RenderWorld(const Arguments& arguments, const SetPlan& plan, int index,
                 const std::string& folder, ProgressBar& progress) {
  const std::uint64_t seed =
      HashOf({static_cast<std::uint64_t>(arguments.seed), static_cast<std::uint64_t>(index),
              static_cast<std::uint64_t>(plan.split)});
  RandomStream random(seed);
  CameraConfig config;
  config.intrinsics = RandomIntrinsics(plan.size, random);
  const auto world =
      std::make_shared<const World>(MakeRandomWorld(plan.split, seed, plan.vocabulary));
  WorldPhotographer photographer(world, plan.vocabulary, config.intrinsics, arguments.depth, seed);
  const VisibleBoxes boxes(plan.boxes, world, plan.vocabulary);
  RenderedSequenceWriter writer(folder, config, plan.vocabulary, *world);
  BackgroundWriter background(writer, boxes, photographer.camera());
  CameraPath path;
  for (int i = 0; i < arguments.images; ++i) {
    const std::optional<Rigid3d> pose = photographer.NextPose();
    if (!pose) break;
    const Stamp stamp{(i + 1) * kBetweenNs};
    background.Push(photographer.Photograph(*pose, stamp), *pose, 0.0);
    path.T_world_camera.push_back({stamp, *pose});
    progress.Update(static_cast<std::size_t>(index) * arguments.images + i + 1);
  }
  background.Finish();
  writer.Finish(path);
}

std::string NameOf(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "world_%05d", index);
  return name;
}

void MakeFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw ConfigError("cannot make the folder " + folder + ": " + error.message());
}

// Folders of one set were made alike, or its worlds would not belong together.
void NoteOptions(const Arguments& arguments) {
  std::ostringstream text;
  text << "split: " << arguments.split << "\nimages: " << arguments.images
       << "\nsize: " << arguments.size << "\nseed: " << arguments.seed
       << "\ndepth: " << (arguments.depth ? "true" : "false") << '\n';
  const std::string path = fs::path(arguments.out) / "set.yaml";
  std::ifstream file(path);
  if (!file) {
    WriteFileAtomically(path, [&](std::ostream& out) { out << text.str(); });
    return;
  }
  const std::string found{std::istreambuf_iterator<char>(file), {}};
  if (found == text.str()) return;
  throw ConfigError(
      path + " is of a set that was rendered with other options: take those, or another folder");
}

// A world's folder has its name once it is complete.
int RenderTrainingSet(CommandLine& command_line) {
  const std::optional<Arguments> arguments = ParseArguments(command_line);
  if (!arguments) return EXIT_SUCCESS;
  SetPlan plan{LabelVocabulary::Load(ConfigFile(arguments->labels, "labels.yaml")),
               SplitNamed(arguments->split),
               ParseSize(arguments->size),
               {}};
  plan.boxes.min_pixels = 150;
  MakeFolder(arguments->out);
  NoteOptions(*arguments);
  ProgressBar progress("rendering",
                       static_cast<std::size_t>(arguments->worlds) * arguments->images);
  int rendered = 0;
  for (int index = 0; index < arguments->worlds; ++index) {
    const fs::path folder = fs::path(arguments->out) / NameOf(index);
    if (fs::exists(folder)) continue;
    const fs::path unfinished = fs::path(arguments->out) / ("unfinished_" + NameOf(index));
    fs::remove_all(unfinished);
    RenderWorld(*arguments, plan, index, unfinished, progress);
    fs::rename(unfinished, folder);
    ++rendered;
  }
  std::cout << arguments->out << ": " << rendered << " worlds rendered, "
            << arguments->worlds - rendered << " were there\n";
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose,
                                   semantic_slam::RenderTrainingSet);
}
