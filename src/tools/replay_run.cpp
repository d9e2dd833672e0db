#include "tools/replay_run.h"

#include <chrono>
#include <iostream>
#include <optional>
#include <string>
#include <thread>

#include "semantic_slam/common/cpu_time.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/common/worker.h"
#include "semantic_slam/localization/gravity_alignment.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

using Clock = std::chrono::steady_clock;

// An image, and when the sensor handed it over.
struct Delivery {
  RgbdImage image;
  Clock::time_point time;
};

// Sets the map's z axis up. Returns where "up" came from.
std::string AlignWithGravity(const Sequence& sequence, const RgbdImage& first,
                             const CameraModel& camera, VisualLocalization& localization) {
  // The camera is the robot: z forward, x right, y down is what x forward, y left, z up sees.
  Rigid3d T_base_camera = Rigid3d::Identity();
  T_base_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  std::optional<Eigen::Vector3d> up_camera;
  if (const auto mean = MeanAcceleration(sequence.source->accelerometer(), first.stamp)) {
    up_camera = sequence.R_camera_imu * *mean;
  }
  const MapStart start = FindMapStart(up_camera, first, camera, T_base_camera);
  localization.SetStart(start.T_map_camera);
  return start.source;
}

void TrackDelivery(const Delivery& delivery, ReplayRun& run, std::vector<PoseDelay>& delays) {
  run.Track(delivery.image, [&](const TrackedImage& tracked) {
    if (tracked.status != TrackingStatus::kTracking) return;
    const std::chrono::duration<double, std::milli> delay = Clock::now() - delivery.time;
    delays.push_back({tracked.stamp, delay.count()});
  });
}

}  // namespace

void ReplayRun::Track(const RgbdImage& image,
                      const std::function<void(const TrackedImage&)>& published) try {
  if (facts.gravity.empty()) {
    facts.gravity = AlignWithGravity(sequence, image, camera, localization);
  }
  const TrackedImage tracked = localization.Track(image);
  published(tracked);
  recorder.Add(tracked);
  stages.Offer(image, tracked, localization);
} catch (const InputError& e) {
  ++facts.dropped["malformed"];
  std::cerr << "dropped image at " << ToString(image.stamp) << " s: " << e.what() << '\n';
}

void RunAsFastAsPossible(ReplayRun& run) {
  ProgressBar progress("replay", run.sequence.source->size());
  std::size_t done = 0;
  while (const auto image = run.sequence.source->Next()) {
    run.Track(*image);
    const std::size_t lost = run.recorder.lost();
    progress.Update(++done, lost == 0 ? "" : std::to_string(lost) + " lost");
  }
}

void RunAtSensorRate(ReplayRun& run) {
  ProgressBar progress("replay", run.sequence.source->size());
  LiveFacts live;
  std::optional<Worker<Delivery>> worker;
  worker.emplace(2, WhenFull::kDropOldest,
                 [&](const Delivery& delivery) { TrackDelivery(delivery, run, live.delays); });
  const auto start = Clock::now();
  std::optional<Stamp> first;
  std::size_t done = 0;
  while (const auto image = run.sequence.source->Next()) {
    if (!first) first = image->stamp;
    // Waiting for the sensor's clock is what this mode is for.
    std::this_thread::sleep_until(start + std::chrono::nanoseconds(image->stamp.ns - first->ns));
    worker->Push({*image, Clock::now()});
    progress.Update(++done);
  }
  run.facts.dropped["late"] = worker->dropped();
  worker.reset();  // works off what is left
  run.localization.Finish();
  live.cpu_s = ProcessCpuSeconds();
  live.decoding_cpu_s = run.sequence.source->cpu_s();
  run.facts.live = std::move(live);
}

}  // namespace semantic_slam
