#include "semantic_slam_ros/map_saver.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {
namespace {

// A saver that only notes the folders, and its service as a caller sees it.
class Saver {
 public:
  explicit Saver(const std::string& output_directory)
      : saver_(ros::NodeHandle("~"), "save_map", output_directory,
               [this](const std::string& folder) { return Save(folder); }) {}

  semantic_slam::SaveMap::Response Call(const std::string& path) {
    semantic_slam::SaveMap save;
    save.request.path = path;
    ros::AsyncSpinner spinner(1);
    spinner.start();
    EXPECT_TRUE(ros::service::call(ros::NodeHandle("~").resolveName("save_map"), save));
    return save.response;
  }

  void SaveOnShutdown() const { saver_.SaveOnShutdown(); }
  void Fail() { fails_ = true; }
  const std::vector<std::string>& folders() const { return folders_; }

 private:
  std::string Save(const std::string& folder) {
    if (fails_) throw semantic_slam::InputError("the disk is full");
    folders_.push_back(folder);
    return "the map is in " + folder;
  }

  bool fails_ = false;
  std::vector<std::string> folders_;
  const MapSaver saver_;
};

TEST(MapSaverTest, SavesWhereTheCallerWants) {
  Saver saver("/default");
  const auto response = saver.Call("/asked/for");
  EXPECT_TRUE(response.success);
  EXPECT_EQ(response.message, "the map is in /asked/for");
}

TEST(MapSaverTest, AnEmptyPathMeansTheOutputDirectory) {
  Saver saver("/default");
  EXPECT_EQ(saver.Call("").message, "the map is in /default");
}

TEST(MapSaverTest, FailsWithoutAnyFolder) {
  Saver saver("");
  const auto response = saver.Call("");
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message, "path is empty, and the node has no ~output_directory");
  EXPECT_TRUE(saver.folders().empty());
}

TEST(MapSaverTest, SaysWhyItFailed) {
  Saver saver("/default");
  saver.Fail();
  const auto response = saver.Call("");
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message, "the disk is full");
  saver.SaveOnShutdown();  // says so on the console and no more
}

TEST(MapSaverTest, SavesOnShutdownIfItHasAFolder) {
  Saver with("/default");
  with.SaveOnShutdown();
  EXPECT_EQ(with.folders(), std::vector<std::string>{"/default"});
}

TEST(MapSaverTest, SavesNothingOnShutdownOtherwise) {
  Saver without("");
  without.SaveOnShutdown();
  EXPECT_TRUE(without.folders().empty());
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "map_saver_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
