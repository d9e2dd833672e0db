#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "semantic_slam/common/lanes.h"
#include "semantic_slam/semantic_cloud/semantic_cloud.h"
#include "semantic_slam/semantic_fusion/label_distribution.h"
#include "semantic_slam/semantic_fusion/voxel_observation.h"

namespace semantic_slam {

// Adds up what the points of one image say of the voxels that they lie in. The result is the same
// in whatever order they come: every sum is of whole numbers. Each point counts as much as every
// other, so a label counts by the confidence that the points have in it. Reusable; not thread-safe.
class VoxelSums {
 public:
  // A point, or several that were combined before.
  struct Sample {
    Ints4 place{};  // in its voxel, from the lowest corner on, in 256ths of the edge; the fourth is
                    // idle
    Ints4 rgb{};    // the fourth is idle
    std::uint32_t labels = 0;  // three ids, the first one in the lowest eight bits
    Ints4 confidences{};  // of the labels, in units of CompactLabels, from the second number on
    std::int32_t points = 1;
  };

  // What the points of one voxel say together.
  struct Mean {
    std::array<float, 3> place{};  // in edges, inside of the voxel and not near its faces
    std::array<std::uint8_t, 3> rgb{};
    CompactLabels labels;
    std::uint16_t points = 0;  // stops at 65535
  };

  // Forgets everything. `labels` are those that count: all others belong to "others". `points` is
  // the sum over all samples that will come, or more.
  void Reset(const LabelMask& labels, std::uint64_t points);

  // Voxels are numbered from 0 on; makes room for one more.
  void AddVoxel();

  // Adds samples one after the other; those of one voxel in a row cost least. What was added counts
  // after Finish(). To be held in a function's own variable, so that it lives in registers.
  class Adder {
   public:
    explicit Adder(VoxelSums& sums) : sums_(sums), shift_(sums.shift_) {}

    // Precondition: there is room for the voxel.
    void Add(std::uint32_t voxel, const Sample& sample) {
      if (voxel != voxel_ || sample.labels != labels_) {
        if (points_ != 0) Finish();
        voxel_ = voxel;
        labels_ = sample.labels;
      }
      place_ += sample.place * sample.points;
      rgb_ += sample.rgb * sample.points;
      confidences_ += (sample.confidences * sample.points) >> shift_;  // products are below 2^30
      points_ += sample.points;
    }

    void Finish() {
      sums_.AddRun(voxel_, place_, rgb_, points_, labels_, confidences_);
      place_ = rgb_ = confidences_ = Ints4{};
      points_ = 0;
    }

   private:
    VoxelSums& sums_;
    const int shift_;
    // Of the samples that came last, all of one voxel and with the same labels.
    std::uint32_t voxel_ = 0;
    std::uint32_t labels_ = 0;
    Ints4 place_{}, rgb_{}, confidences_{};
    std::int32_t points_ = 0;
  };

  // Precondition: there is room.
  bool IsEmpty(std::uint32_t voxel) const { return sums_[voxel].points == 0; }

  // Precondition: !IsEmpty(voxel).
  Mean MeanOf(std::uint32_t voxel) const;

 private:
  struct Sums {
    Ints4 place{};
    Ints4 rgb{};
    std::uint32_t points = 0;
  };

  void AddRun(std::uint32_t voxel, Ints4 place, Ints4 rgb, std::int32_t points,
              std::uint32_t labels, Ints4 confidences);
  CompactLabels LabelsOf(std::uint32_t voxel) const;

  std::array<std::uint8_t, 256> column_of_{};  // of each label; 0: of those that do not count
  std::vector<LabelId> label_of_;              // of each column
  int shift_ = 0;           // confidences are kept divided by two so often, or a sum might not fit
  std::vector<Sums> sums_;  // by voxel
  std::vector<std::uint32_t> confidences_;  // by voxel and column
};

}  // namespace semantic_slam
