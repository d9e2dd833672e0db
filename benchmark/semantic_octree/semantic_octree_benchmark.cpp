// Times mappers on one synthetic sequence and judges the maps that they make of it.

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "semantic_octree/map_quality.h"
#include "semantic_octree/mapping_method.h"
#include "semantic_octree/octomap_method.h"
#include "semantic_slam/common/check.h"
#include "semantic_slam/common/cpu_time.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/common/heap.h"
#include "tools/command_line.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

using synthetic_room::Frame;
using synthetic_room::kFrames;

constexpr char kPurpose[] =
    "Times mappers on one synthetic sequence (a furnished room, 640 x 480 px, 303,400 points an\n"
    "image, three labels each) and judges what they make of it. Prints a line RESULT for each "
    "and,\n"
    "with --quality, a line QUALITY; with --agreement a line AGREEMENT that compares the "
    "occupancy\n"
    "of every voxel with insertPointCloud(lazy, discretize) of OctoMap's. Without --method all "
    "run,\n"
    "each in a process of its own.";

constexpr double kMillisecond = 1e3;  // a second's
constexpr double kMegabyte = 1048576.0;
constexpr std::size_t kEdgeFrames = 10;

struct Settings {
  std::string method;
  MappingSettings mapping;
  int frames = kFrames;
  bool quality = false;
  bool agreement = false;
};

struct Timing {
  std::vector<double> cpu_ms;
  std::vector<double> wall_ms;
  std::size_t points = 0;
};

struct Memory {
  double at_start_mb = 0.0;
  double peak_mb = 0.0;
  double at_end_mb = 0.0;
};

// A line of /proc/self/status, as VmRSS or VmHWM [MB].
double ProcessMemoryMb(const std::string& name) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    double kilobytes = 0.0;
    if (word == name + ":" && status >> kilobytes) return kilobytes / 1024.0;
  }
  return 0.0;
}

double Quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(q * static_cast<double>(values.size())))];
}

double Median(const std::vector<double>& values) {
  return Quantile(values, 0.5);
}

template <typename Function>
void Measure(Function&& function, Timing& timing) {
  const double cpu = ProcessCpuSeconds();
  const auto wall = std::chrono::steady_clock::now();
  function();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - wall;
  timing.wall_ms.push_back(taken.count() * kMillisecond);
  timing.cpu_ms.push_back((ProcessCpuSeconds() - cpu) * kMillisecond);
}

Timing InsertAll(const Settings& settings, MappingMethod& method, Memory& memory) {
  Timing timing;
  Frame frame;
  synthetic_room::Render(0, frame);
  method.Prepare(frame);
  memory.at_start_mb = ProcessMemoryMb("VmRSS");
  method.Release();
  ProgressBar progress(settings.method, static_cast<std::size_t>(settings.frames));
  for (int i = 0; i < settings.frames; ++i) {
    synthetic_room::Render(i % kFrames, frame);
    timing.points += frame.points.size();
    method.Prepare(frame);
    Measure([&] { method.Insert(frame); }, timing);
    method.Release();
    progress.Update(static_cast<std::size_t>(i + 1));
  }
  memory.peak_mb = ProcessMemoryMb("VmHWM");
  memory.at_end_mb = ProcessMemoryMb("VmRSS");
  return timing;
}

void PrintResult(const Settings& settings, const MappingMethod& method, const Timing& timing,
                 const Memory& memory) {
  const std::vector<double>& cpu = timing.cpu_ms;
  const auto edge = static_cast<std::ptrdiff_t>(std::min(kEdgeFrames, cpu.size()));
  const double sum_ms = std::accumulate(cpu.begin(), cpu.end(), 0.0);
  const double start_s = ProcessCpuSeconds();
  const std::size_t bytes = method.Serialise();
  const double publish_ms = (ProcessCpuSeconds() - start_s) * kMillisecond;
  std::size_t occupied = 0;
  method.ForEachOccupied([&](const octomap::OcTreeKey&, LabelId) { ++occupied; });
  std::printf(
      "RESULT method=%s res=%.3f frames=%d med_cpu_ms=%.1f med_wall_ms=%.1f mean_cpu_ms=%.1f "
      "p95_cpu_ms=%.1f first10=%.1f last10=%.1f Mpts_per_s=%.2f rss0_MB=%.0f peak_MB=%.0f "
      "end_MB=%.0f map_MB=%.1f nodes=%zu leaves=%zu occ=%zu publish_ms=%.1f file_MB=%.2f\n",
      settings.method.c_str(), settings.mapping.resolution_m, settings.frames, Median(cpu),
      Median(timing.wall_ms), sum_ms / static_cast<double>(cpu.size()), Quantile(cpu, 0.95),
      Median({cpu.begin(), cpu.begin() + edge}), Median({cpu.end() - edge, cpu.end()}),
      static_cast<double>(timing.points) / sum_ms / kMillisecond, memory.at_start_mb,
      memory.peak_mb, memory.at_end_mb, static_cast<double>(method.MapBytes()) / kMegabyte,
      method.Nodes(), method.Leaves(), occupied, publish_ms,
      static_cast<double>(bytes) / kMegabyte);
}

void PrintQuality(const Settings& settings, const MappingMethod& method) {
  const MapQuality quality = JudgeMap(method, settings.mapping, std::min(settings.frames, kFrames));
  std::printf(
      "QUALITY method=%s res=%.3f gt_voxels=%zu occ_voxels=%zu recall=%.4f precision_1vox=%.4f "
      "label_acc=%.4f unlabelled=%.4f alien_colour=%.4f\n",
      settings.method.c_str(), settings.mapping.resolution_m, quality.true_voxels,
      quality.occupied_voxels, quality.recall, quality.precision, quality.label_accuracy,
      quality.unlabelled, quality.alien);
}

// Voxel by voxel against OctoMap's own tree of the same images.
void PrintAgreement(const Settings& settings, const MappingMethod& method) {
  const auto reference = MakeSamePointsMethod(settings.mapping);
  Frame frame;
  for (int i = 0; i < settings.frames; ++i) {
    synthetic_room::Render(i % kFrames, frame);
    reference->Prepare(frame);
    reference->Insert(frame);
  }
  std::size_t known = 0, missing = 0, other_value = 0, other_state = 0, extra = 0;
  reference->ForEachKnown([&](const octomap::OcTreeKey& key, LabelId) {
    const float theirs = reference->LogOdds(key), ours = method.LogOdds(key);
    ++known;
    missing += std::isnan(ours);
    other_value += ours != theirs;
    other_state += std::isnan(ours) || (ours >= 0.0f) != (theirs >= 0.0f);
  });
  method.ForEachKnown([&](const octomap::OcTreeKey& key, LabelId) {
    extra += std::isnan(reference->LogOdds(key));
  });
  std::printf(
      "AGREEMENT method=%s res=%.3f frames=%d known=%zu missing=%zu extra=%zu other_value=%zu "
      "other_state=%zu other_state_share=%.5f\n",
      settings.method.c_str(), settings.mapping.resolution_m, settings.frames, known, missing,
      extra, other_value, other_state + extra,
      static_cast<double>(other_state + extra) / static_cast<double>(known));
}

void RunOne(const Settings& settings) {
  const auto method = MakeMappingMethod(settings.method, settings.mapping);
  Memory memory;
  const Timing timing = InsertAll(settings, *method, memory);
  PrintResult(settings, *method, timing, memory);
  if (settings.quality) PrintQuality(settings, *method);
  if (settings.agreement) PrintAgreement(settings, *method);
  std::fflush(stdout);
}

// One method after the other, each in a child: peak memory is a process'.
int RunAll(Settings settings) {
  int failed = 0;
  for (const std::string& name : MappingMethodNames()) {
    settings.method = name;
    const pid_t child = fork();
    if (child < 0) throw InputError("cannot start a process for " + name);
    if (child == 0) {
      RunOne(settings);
      std::_Exit(EXIT_SUCCESS);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (status == 0) continue;
    std::cerr << name << ": ended with status " << status << '\n';
    ++failed;
  }
  return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int SemanticOctreeBenchmark(CommandLine& command_line) {
  Settings settings;
  bool list = false;
  command_line.Option("method", "M", &settings.method, "one method; all if not given");
  command_line.Option("res", "R", &settings.mapping.resolution_m, "edge of a voxel [m]");
  command_line.Option("range", "R", &settings.mapping.range_m, "longest ray [m]");
  command_line.Option("frames", "N", &settings.frames, "images; from 101 on the loop begins again");
  command_line.Flag("quality", &settings.quality, "compare the map with the room");
  command_line.Flag("agreement", &settings.agreement, "compare its occupancy with OctoMap's");
  command_line.Flag("list", &list, "print the methods' names");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  if (list) {
    for (const std::string& name : MappingMethodNames()) std::cout << name << '\n';
    return EXIT_SUCCESS;
  }
  CheckInRange("--res", settings.mapping.resolution_m, 0.01, 1.0);
  CheckInRange("--range", settings.mapping.range_m, 0.1, 30.0);
  CheckInRange("--frames", settings.frames, 1, 1000000);
  if (settings.method.empty()) return RunAll(settings);
  RunOne(settings);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  semantic_slam::ReturnLargeBlocks();
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose,
                                   semantic_slam::SemanticOctreeBenchmark);
}
