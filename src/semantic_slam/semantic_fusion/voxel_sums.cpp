#include "semantic_slam/semantic_fusion/voxel_sums.h"

#include <algorithm>
#include <limits>

#include "semantic_slam/semantic_fusion/top_labels.h"

namespace semantic_slam {
namespace {

constexpr int kSumBits = 32;
constexpr int kConfidenceBits = 14;  // of CompactLabels' probability of one

// A mean is kept so far from its voxel's faces that no rounding brings it into the next one.
constexpr float kNearestToFace = 1.0f / 16.0f;

}  // namespace

void VoxelSums::Reset(const LabelMask& labels, std::uint64_t points) {
  label_of_.assign(1, kUnknownLabel);
  column_of_.fill(0);
  for (int label = 1; label < kReservedLabel; ++label) {
    if (!labels[label]) continue;
    column_of_[label] = static_cast<std::uint8_t>(label_of_.size());
    label_of_.push_back(static_cast<LabelId>(label));
  }
  shift_ = 0;
  while (points >> shift_ >> (kSumBits - kConfidenceBits) != 0) ++shift_;
  sums_.clear();
  confidences_.clear();
}

void VoxelSums::AddVoxel() {
  sums_.emplace_back();
  confidences_.resize(confidences_.size() + label_of_.size());
}

void VoxelSums::AddRun(std::uint32_t voxel, Ints4 place, Ints4 rgb, std::int32_t points,
                       std::uint32_t labels, Ints4 confidences) {
  if (points == 0) return;
  Sums& sums = sums_[voxel];
  sums.place += place;
  sums.rgb += rgb;
  sums.points += static_cast<std::uint32_t>(points);
  std::uint32_t* const row = &confidences_[voxel * label_of_.size()];
  for (int i = 0; i < kTopLabels; ++i)
    row[column_of_[labels >> (8 * i) & 0xff]] += static_cast<std::uint32_t>(confidences[i + 1]);
}

VoxelSums::Mean VoxelSums::MeanOf(std::uint32_t voxel) const {
  const Sums& sums = sums_[voxel];
  Mean mean;
  const float scale = 1.0f / (256.0f * static_cast<float>(sums.points));
  for (int i = 0; i < 3; ++i) {
    mean.place[i] =
        std::clamp(static_cast<float>(static_cast<std::uint32_t>(sums.place[i])) * scale,
                   kNearestToFace, 1.0f - kNearestToFace);
    mean.rgb[i] = static_cast<std::uint8_t>(
        (static_cast<std::uint32_t>(sums.rgb[i]) + sums.points / 2) / sums.points);
  }
  mean.labels = LabelsOf(voxel);
  mean.points = static_cast<std::uint16_t>(
      std::min<std::uint32_t>(sums.points, std::numeric_limits<std::uint16_t>::max()));
  return mean;
}

CompactLabels VoxelSums::LabelsOf(std::uint32_t voxel) const {
  const std::uint32_t* const row = &confidences_[voxel * label_of_.size()];
  TopLabels<std::uint32_t> top;
  for (std::size_t column = 1; column < label_of_.size(); ++column)
    top.Offer(label_of_[column], row[column]);
  const std::uint64_t points = sums_[voxel].points;
  std::array<int, kTopLabels> scaled{};
  for (int i = 0; i < kTopLabels; ++i) {
    scaled[i] =
        static_cast<int>(((std::uint64_t{top.weights()[i]} << shift_) + points / 2) / points);
  }
  return CompactLabels(top.labels(), scaled, 0);
}

}  // namespace semantic_slam
