#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/camera_twist.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/features/orb_extractor.h"

namespace semantic_slam {

struct Feature {
  Eigen::Vector2f raw;    // pixel as the sensor saw it
  Eigen::Vector2f exposed;  // undistorted
  Eigen::Vector2f pixel;  // undistorted, and where it were without a rolling shutter: see Rectified()
  float depth_m;          // along the optical axis; NaN if there is none
  float angle_rad;
  int octave;
  std::array<std::uint8_t, 3> rgb;  // of the image there, for people to look at

  bool has_depth() const { return depth_m > 0.0f; }  // NaN compares false
};

// The features of one RGB-D image, with their depth, and an index to find them by place. Immutable,
// so one image's features can be shared between tracking and the map.
class FrameFeatures {
 public:
  // Throws InputError if the image is malformed or not of the camera's size.
  FrameFeatures(const RgbdImage& image, const CameraModel& camera, const OrbExtractor& extractor);

  // Of an image that was seen before: as they were, from a file. Precondition: one descriptor per
  // feature, and pixels that are finite and not far outside the image.
  FrameFeatures(Stamp stamp, std::vector<Feature> features, std::vector<Descriptor> descriptors,
                const CameraModel& camera);

  // The same features as all rows would have shown them in the middle of the exposure, of a camera that
  // moves like this. Of features without depth only the turn is taken out.
  std::shared_ptr<const FrameFeatures> Rectified(const CameraTwist& twist, double readout_s,
                                                 const CameraModel& camera) const;

  Stamp stamp() const { return stamp_; }
  std::size_t size() const { return features_.size(); }
  const Feature& operator[](std::size_t i) const { return features_[i]; }
  const std::vector<Feature>& features() const { return features_; }
  const Descriptor& descriptor(std::size_t i) const { return descriptors_[i]; }
  const std::vector<Descriptor>& descriptors() const { return descriptors_; }

  // Calls visit(index) for every feature within the square of half side `radius_px` about `pixel`
  // (undistorted) whose octave is in [min_octave, max_octave].
  template <typename Visitor>
  void ForEachNear(const Eigen::Vector2f& pixel, float radius_px, int min_octave, int max_octave,
                   Visitor&& visit) const;

 private:
  static constexpr float kCellPx = 10.0f;

  void BuildGrid(const CameraModel& camera);
  int ColumnOf(float u) const;
  int RowOf(float v) const;

  Stamp stamp_;
  std::vector<Feature> features_;
  std::vector<Descriptor> descriptors_;
  // What a search needs of a feature: all that it looks at lies side by side.
  struct GridEntry {
    Eigen::Vector2f pixel;
    int octave;
    int index;
  };

  // Features by grid cell over the undistorted image, row-major: those of cell c are
  // entries_[cell_begin_[c]] .. entries_[cell_begin_[c + 1] - 1].
  float left_px_ = 0.0f, top_px_ = 0.0f;
  int columns_ = 0, rows_ = 0;
  std::vector<int> cell_begin_;
  std::vector<GridEntry> entries_;
};

template <typename Visitor>
void FrameFeatures::ForEachNear(const Eigen::Vector2f& pixel, float radius_px, int min_octave,
                                int max_octave, Visitor&& visit) const {
  const int column_end = ColumnOf(pixel.x() + radius_px), row_end = RowOf(pixel.y() + radius_px);
  const int column_begin = ColumnOf(pixel.x() - radius_px);
  for (int row = RowOf(pixel.y() - radius_px); row <= row_end; ++row) {
    const int first = row * columns_;
    const int end = cell_begin_[first + column_end + 1];
    for (int k = cell_begin_[first + column_begin]; k < end; ++k) {
      const GridEntry& entry = entries_[k];
      if (entry.octave < min_octave || entry.octave > max_octave) continue;
      if ((entry.pixel - pixel).cwiseAbs().maxCoeff() <= radius_px) visit(entry.index);
    }
  }
}

}  // namespace semantic_slam
