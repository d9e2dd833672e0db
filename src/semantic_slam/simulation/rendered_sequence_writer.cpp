#include "semantic_slam/simulation/rendered_sequence_writer.h"

#include <filesystem>
#include <iomanip>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/worlds/looks.h"

namespace semantic_slam {

namespace fs = std::filesystem;

namespace {

// The names by line, so that line numbers, from 0, are ids.
void WriteClasses(const fs::path& path, const LabelVocabulary& vocabulary) {
  WriteFileAtomically(path, [&](std::ostream& out) {
    for (int id = 0; id <= vocabulary.classes().back().id; ++id) {
      const auto label = static_cast<LabelId>(id);
      out << (vocabulary.Contains(label) ? vocabulary[label].name : "-") << '\n';
    }
  });
}

void WriteLooks(const fs::path& path, const World& world) {
  const std::vector<int> looks = LooksOf(world);
  WriteFileAtomically(path, [&](std::ostream& out) {
    out << "# instance look\n";
    for (std::size_t i = 0; i < looks.size(); ++i) {
      out << world.objects[i].instance << ' ' << looks[i] << '\n';
    }
  });
}

}  // namespace

RenderedSequenceWriter::RenderedSequenceWriter(const std::string& folder,
                                               const CameraConfig& camera,
                                               const LabelVocabulary& vocabulary,
                                               const World& world, int truth_period)
    : folder_(folder),
      R_imu_camera_(camera.R_camera_imu.transpose()),
      truth_period_(truth_period),
      writer_(folder, camera) {
  WriteClasses(fs::path(folder_) / "classes.txt", vocabulary);
  WriteLooks(fs::path(folder_) / "looks.txt", world);
}

void RenderedSequenceWriter::Add(const SimulatedImage& image, const VisibleObjects& objects) {
  writer_.Add(image.measured);
  if (images_++ % static_cast<std::size_t>(truth_period_) != 0) return;
  writer_.Add("labels", image.measured.stamp, image.truth.labels);
  writer_.Add("instances", image.measured.stamp, image.truth.instances);
  WriteBoxes(objects);
}

// Pixel (0, 0) is the middle of the first one, so the image begins at -0.5.
void RenderedSequenceWriter::WriteBoxes(const VisibleObjects& objects) const {
  const Detections& boxes = objects.detections;
  const fs::path path = fs::path(folder_) / "boxes" / (ToString(boxes.stamp) + ".txt");
  WriteFileAtomically(path, [&](std::ostream& out) {
    out << std::fixed << std::setprecision(6);
    for (std::size_t i = 0; i < boxes.boxes.size(); ++i) {
      const cv::Rect2f& box = boxes.boxes[i].box;
      out << static_cast<int>(boxes.boxes[i].label) << ' '
          << (box.x + 0.5f * box.width + 0.5f) / boxes.image_size.width << ' '
          << (box.y + 0.5f * box.height + 0.5f) / boxes.image_size.height << ' '
          << box.width / boxes.image_size.width << ' ' << box.height / boxes.image_size.height
          << ' ' << objects.visible_shares[i] << '\n';
    }
  });
}

void RenderedSequenceWriter::WriteImu(const std::vector<ImuReading>& readings) const {
  WriteFileAtomically(fs::path(folder_) / "imu.txt", [&](std::ostream& out) {
    out << "# timestamp wx wy wz ax ay az\n" << std::fixed << std::setprecision(6);
    for (const ImuReading& reading : readings) {
      const Eigen::Vector3d w = R_imu_camera_ * reading.angular_velocity_radps;
      const Eigen::Vector3d a = R_imu_camera_ * reading.specific_force_mps2;
      out << ToString(reading.stamp) << ' ' << w.x() << ' ' << w.y() << ' ' << w.z() << ' ' << a.x()
          << ' ' << a.y() << ' ' << a.z() << '\n';
    }
  });
}

void RenderedSequenceWriter::Finish(const CameraPath& path) const {
  std::vector<AccelerometerReading> acceleration;
  for (const ImuReading& reading : path.readings) {
    acceleration.push_back({reading.stamp, R_imu_camera_ * reading.specific_force_mps2});
  }
  WriteImu(path.readings);
  writer_.WriteAccelerometer(acceleration);
  WriteTumTrajectory(path.T_world_camera, fs::path(folder_) / "groundtruth.txt");
  writer_.Finish();
}

}  // namespace semantic_slam
