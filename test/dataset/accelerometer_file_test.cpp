#include "semantic_slam/dataset/accelerometer_file.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

TEST(AccelerometerFileTest, ReadsAndSorts) {
  const TemporaryFolder folder;
  const std::string path =
      folder.Write("accelerometer.txt", "# ax ay az\n2.0 0 0 9.81\n1.0 -0.5 7.25 -6.5e0\n");
  const auto readings = ReadAccelerometerFile(path);
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].stamp.ns, 1'000'000'000);
  EXPECT_EQ(readings[0].acceleration_imu, Eigen::Vector3d(-0.5, 7.25, -6.5));
}

TEST(AccelerometerFileTest, RefusesWhatIsNoNumber) {
  const TemporaryFolder folder;
  for (const char* bad : {"1.0 0 0 up", "1.0 nan 0 0", "1.0 0 inf 0", "1.0 0 0", "1.0 0 0 9.81x"}) {
    const std::string path = folder.Write("accelerometer.txt", bad);
    ExpectOneLineWith(MessageOf<InputError>([&] { ReadAccelerometerFile(path); }),
                      {"accelerometer.txt:1: expected 'stamp ax ay az'"});
  }
}

}  // namespace
}  // namespace semantic_slam
