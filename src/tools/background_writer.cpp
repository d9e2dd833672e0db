#include "tools/background_writer.h"

#include <cstddef>
#include <utility>

namespace semantic_slam {
namespace {

constexpr std::size_t kWaiting = 4;  // images between rendering and writing

}  // namespace

BackgroundWriter::BackgroundWriter(RenderedSequenceWriter& writer, const VisibleBoxes& boxes,
                                   const CameraModel& camera)
    : writer_(writer), boxes_(boxes), camera_(camera) {
  worker_.emplace(kWaiting, WhenFull::kBlock, [this](const Item& item) { Write(item); });
}

void BackgroundWriter::Push(SimulatedImage image, const Rigid3d& T_world_camera, double time_s) {
  if (has_failed_) Finish();
  worker_->Push({std::move(image), T_world_camera, time_s});
}

void BackgroundWriter::Finish() {
  worker_.reset();
  if (error_) std::rethrow_exception(error_);
}

void BackgroundWriter::Write(const Item& item) {
  if (has_failed_) return;
  try {
    const Stamp stamp = item.image.measured.stamp;
    const VisibleObjects objects =
        boxes_.Find(item.image.truth, item.T_world_camera, camera_, item.time_s, stamp);
    writer_.Add(item.image, objects);
  } catch (const std::exception&) {
    error_ = std::current_exception();
    has_failed_ = true;
  }
}

}  // namespace semantic_slam
