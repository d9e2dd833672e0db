#pragma once

#include <atomic>
#include <exception>
#include <optional>

#include "semantic_slam/common/worker.h"
#include "semantic_slam/simulation/rendered_sequence_writer.h"
#include "semantic_slam/simulation/simulated_camera.h"
#include "semantic_slam/simulation/visible_boxes.h"

namespace semantic_slam {

// Finds boxes, compresses and writes on a thread of its own. The first error is thrown by the next
// call. Not thread-safe; keeps references.
class BackgroundWriter {
 public:
  BackgroundWriter(RenderedSequenceWriter& writer, const VisibleBoxes& boxes,
                   const CameraModel& camera);

  // Waits while too many images are waiting.
  void Push(SimulatedImage image, const Rigid3d& T_world_camera, double time_s);

  // Waits for what is left.
  void Finish();

 private:
  struct Item {
    SimulatedImage image;
    Rigid3d T_world_camera;
    double time_s;
  };

  void Write(const Item& item);

  RenderedSequenceWriter& writer_;
  const VisibleBoxes& boxes_;
  const CameraModel& camera_;
  std::atomic<bool> has_failed_{false};
  std::exception_ptr error_;            // written by the worker; read after it has ended
  std::optional<Worker<Item>> worker_;  // last: joined before anything it uses goes
};

}  // namespace semantic_slam
