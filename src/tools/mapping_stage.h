#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>

#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/throttle.h"
#include "semantic_slam/common/worker.h"

namespace semantic_slam {

// One of the branches behind tracking, as replay runs it. For one thread.
class MappingStage {
 public:
  using Counts = std::map<std::string, std::size_t>;

  virtual ~MappingStage() = default;

  // As in --stages.
  virtual const char* name() const = 0;

  // Takes in what a tracked image shows. Throws InputError if it cannot be used.
  virtual void Process(const RgbdImage& image, const TrackedImage& tracked) = 0;

  // Moves what was taken in to where the keyframes are now.
  virtual void FollowGraph(const KeyframeGraph& graph) = 0;

  // Leaves the results in `folder`. Throws InputError naming a file that cannot be written.
  virtual void Write(const std::string& folder) = 0;

  // What the summary tells of the stage.
  virtual Counts counts() const = 0;
};

// Runs a stage on a thread of its own, on tracked images that are at least period_s apart. With kBlock
// nothing is left out, and the stage sees the same images and graphs in the same order on every run;
// with kDropOldest the newest image pushes a waiting one out, and that is counted.
class StageRunner {
 public:
  StageRunner(std::unique_ptr<MappingStage> stage, double period_s, WhenFull when_full);

  // `graph` is the keyframe graph after this image.
  void Offer(const RgbdImage& image, const TrackedImage& tracked,
             std::shared_ptr<const KeyframeGraph> graph);

  // Works off what is left and moves the map to the final graph. No Offer() after that.
  void Finish(const KeyframeGraph& graph);

  const char* name() const { return stage_->name(); }

  // Both after Finish().
  MappingStage& stage() { return *stage_; }
  MappingStage::Counts counts() const;

 private:
  struct Item {
    RgbdImage image;
    TrackedImage tracked;
    std::shared_ptr<const KeyframeGraph> graph;
  };

  void Process(const Item& item);

  const std::unique_ptr<MappingStage> stage_;
  Throttle throttle_;
  std::shared_ptr<const KeyframeGraph> followed_;  // used by the worker only
  std::size_t images_ = 0;                         // the same
  std::size_t malformed_ = 0;                      // the same
  std::size_t late_ = 0;
  std::unique_ptr<Worker<Item>> worker_;  // last: joined before anything it uses goes
};

}  // namespace semantic_slam
