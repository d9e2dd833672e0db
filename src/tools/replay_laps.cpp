// Plays recordings again and again, to see what grows with time.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <unistd.h>

#include "semantic_slam/common/check.h"
#include "semantic_slam/common/heap.h"
#include "semantic_slam/localization/visual_localization.h"
#include "tools/command_line.h"
#include "tools/open_sequence.h"
#include "tools/progress_bar.h"
#include "tools/replay_stages.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Plays sequences one after the other, again and again, through tracking, mapping and loop "
    "closing, as fast\n"
    "as it can, and prints a line per lap: what the map holds, what memory the program has, and "
    "how long an\n"
    "image took, mapping in it. Where the place is known nothing should grow any more. The camera "
    "should be\n"
    "at the end of a sequence where the next begins; else it must be found again.";

constexpr std::int64_t kGapNs = 33'000'000;  // between the last image of a sequence and the next

struct Arguments {
  std::string config;
  int laps = 10;
  std::vector<std::string> sequences;
};

// What one lap was like.
struct Lap {
  std::vector<double> ms;  // per image
  std::size_t lost = 0;

  // The time that a share `q` of the images did not exceed; 0 without images.
  double QuantileMs(double q) {
    if (ms.empty()) return 0.0;
    const auto place =
        ms.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(ms.size() - 1));
    std::nth_element(ms.begin(), place, ms.end());
    return *place;
  }
};

double ResidentMb() {
  std::ifstream file("/proc/self/statm");
  double all_pages = 0.0, resident_pages = 0.0;
  file >> all_pages >> resident_pages;
  return 1e-6 * resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

class Laps {
 public:
  explicit Laps(const Arguments& arguments) : arguments_(arguments) {
    const Sequence first = Open(arguments.sequences.front());
    localization_ = std::make_unique<VisualLocalization>(
        options_.localization, std::make_shared<const CameraModel>(first.camera),
        MappingMode::kInline);
  }

  void PlayAll() {
    std::printf(
        "| lap | images | lost | keyframes | culled | points | loops | memory [MB] | per image, "
        "median "
        "[ms] | 95 %% [ms] |\n|---|---|---|---|---|---|---|---|---|---|\n");
    for (int i = 1; i <= arguments_.laps; ++i) {
      Lap lap;
      for (const std::string& sequence : arguments_.sequences) Play(sequence, lap);
      Print(i, lap);
    }
  }

 private:
  Sequence Open(const std::string& path) {
    options_ = ReplayOptions();
    return OpenSequence(path, arguments_.config,
                        [this](YamlReader& file) { ReadReplayOptions(file, options_); });
  }

  void Play(const std::string& path, Lap& lap) {
    Sequence sequence = Open(path);
    ProgressBar progress("replay_laps", sequence.source->size());
    std::size_t done = 0;
    std::optional<Stamp> first;
    const std::int64_t begin_ns = next_ns_;
    while (auto image = sequence.source->Next()) {
      if (!first) first = image->stamp;
      const std::int64_t shift_ns = begin_ns - first->ns;
      image->stamp.ns += shift_ns;
      image->depth_stamp.ns += shift_ns;
      Track(*image, lap);
      next_ns_ = image->stamp.ns + kGapNs;
      progress.Update(++done);
    }
  }

  void Track(const RgbdImage& image, Lap& lap) {
    const auto start = std::chrono::steady_clock::now();
    const TrackedImage tracked = localization_->Track(image);
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    lap.ms.push_back(elapsed.count());
    lap.lost += tracked.status != TrackingStatus::kTracking;
  }

  void Print(int number, Lap& lap) const {
    const KeyframeGraph graph = localization_->keyframe_graph();
    const auto culled = std::count_if(graph.keyframes.begin(), graph.keyframes.end(),
                                      [](const KeyframeNode& node) { return node.culled; });
    const std::size_t loops = localization_->closed_loops();
    std::printf("| %d | %zu | %zu | %zu | %zu | %zu | %zu | %.0f | %.1f | %.1f |\n", number,
                lap.ms.size(), lap.lost, graph.keyframes.size() - static_cast<std::size_t>(culled),
                static_cast<std::size_t>(culled), localization_->map_points().size(), loops,
                ResidentMb(), lap.QuantileMs(0.5), lap.QuantileMs(0.95));
    std::fflush(stdout);
  }

  const Arguments& arguments_;
  ReplayOptions options_;
  std::unique_ptr<VisualLocalization> localization_;
  std::int64_t next_ns_ = 1'000'000'000;  // stamp of the next sequence's first image
};

int ReplayLaps(CommandLine& command_line) {
  Arguments arguments;
  command_line.RequiredOption("config", "CAMERA.yaml", &arguments.config,
                              "camera and options: config/tum_freiburg1.yaml, ...");
  command_line.Option("laps", "N", &arguments.laps, "how often all of them are played");
  command_line.Arguments("SEQUENCE", &arguments.sequences,
                         "folders in TUM's format or bags, of one camera");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  CheckInRange("--laps", arguments.laps, 1, 1000000);
  Laps(arguments).PlayAll();
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  semantic_slam::ReturnLargeBlocks();
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::ReplayLaps);
}
