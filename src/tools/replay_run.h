#pragma once

#include <functional>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/localization/run_report.h"
#include "semantic_slam/localization/trajectory_recorder.h"
#include "semantic_slam/localization/visual_localization.h"
#include "tools/open_sequence.h"
#include "tools/replay_stages.h"

namespace semantic_slam {

// A sequence on its way through localization and the stages behind it, and what is found out about
// it.
struct ReplayRun {
  // Tracks one image and offers it to the stages. One that is malformed is told on stderr and
  // counted. `published` is called, with what became of the image, before the stages see it.
  void Track(
      const RgbdImage& image,
      const std::function<void(const TrackedImage&)>& published = [](const auto&) {});

  Sequence& sequence;
  const CameraModel& camera;
  VisualLocalization& localization;
  ReplayStages& stages;
  TrajectoryRecorder recorder;
  RunFacts facts;
};

// Plays the sequence to its end, each image as soon as the one before is done with.
void RunAsFastAsPossible(ReplayRun& run);

// Plays it by the images' stamps: the sensor does not wait, and an image that finds two others
// waiting pushes the older one out. Leaves in the run's facts how long after its delivery each
// image had its pose, and how much CPU time the process has taken when mapping has finished.
void RunAtSensorRate(ReplayRun& run);

}  // namespace semantic_slam
