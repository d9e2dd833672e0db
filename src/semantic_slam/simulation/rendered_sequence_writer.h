#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/dataset/tum_folder_writer.h"
#include "semantic_slam/simulation/camera_path.h"
#include "semantic_slam/simulation/simulated_camera.h"
#include "semantic_slam/simulation/visible_boxes.h"

namespace semantic_slam {

// Writes what a simulated camera sees as a TUM folder with the truth of each image beside it:
//
//   labels/*.png     label ids, 8 bits; listed in labels.txt
//   instances/*.png  instances, 16 bits; listed in instances.txt
//   looks.txt        "instance look" of each object of the world, see LooksOf(): twins share a look
//   boxes/*.txt      YOLO's format, "class x y width height" of each object in shares of the image,
//                    class being the label id, and behind that the visible share of the object;
//                    names by line in classes.txt
//   groundtruth.txt  T_world_camera of the optical frame at every image
//   imu.txt          "stamp wx wy wz ax ay az" in the imu's axes; also accelerometer.txt
//
// Not thread-safe.
class RenderedSequenceWriter {
 public:
  // The truth of every `truth_period`th image is written. Throws InputError naming what cannot be
  // written, as all methods do.
  RenderedSequenceWriter(const std::string& folder, const CameraConfig& camera,
                         const LabelVocabulary& vocabulary, const World& world,
                         int truth_period = 1);

  // `objects`: those in view.
  void Add(const SimulatedImage& image, const VisibleObjects& objects);

  // The rest; after that the folder is a sequence.
  void Finish(const CameraPath& path) const;

 private:
  void WriteBoxes(const VisibleObjects& objects) const;
  void WriteImu(const std::vector<ImuReading>& readings) const;

  const std::string folder_;
  const Eigen::Matrix3d R_imu_camera_;
  const int truth_period_;
  TumFolderWriter writer_;
  std::size_t images_ = 0;
};

}  // namespace semantic_slam
