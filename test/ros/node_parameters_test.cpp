// What a node says and returns when its parameters are wrong.

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/tracking_node.h"

namespace semantic_slam_ros {
namespace {

struct Outcome {
  int status;
  std::string output;
};

Outcome RunTracking(const std::string& arguments) {
  const std::string command = std::string(SEMANTIC_SLAM_PROGRAM_DIR) + "/tracking_node " +
                              "__name:=tracking_under_test " + arguments + " 2>&1";
  FILE* pipe = ::popen(command.c_str(), "r");
  Outcome outcome;
  std::array<char, 256> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) outcome.output += buffer.data();
  outcome.status = WEXITSTATUS(::pclose(pipe));
  return outcome;
}

void ExpectFatal(const std::string& arguments, const std::string& why) {
  const Outcome outcome = RunTracking(arguments);
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_NE(outcome.output.find("FATAL"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find(why), std::string::npos) << outcome.output;
}

TEST(NodeParametersTest, RefusesAnUnknownOne) {
  ExpectFatal("_tracking/max_featurs:=10",
              "unknown parameter /tracking_under_test/tracking/max_featurs");
  ros::param::del("/tracking_under_test");
}

TEST(NodeParametersTest, RefusesOneOutOfRange) {
  ExpectFatal("_features/pyramid_levels:=0",
              "/tracking_under_test/features/pyramid_levels = 0, but must be in [1, 12]");
  ros::param::del("/tracking_under_test");
}

TEST(NodeParametersTest, RefusesAPeriodOfDiagnosticsOutOfRange) {
  ExpectFatal("_diagnostic_period:=0.0",
              "/tracking_under_test/diagnostic_period = 0, but must be in [0.1, 60]");
  ros::param::del("/tracking_under_test");
}

TEST(NodeParametersTest, RefusesAnotherType) {
  ExpectFatal("_queue_size:=many", "/tracking_under_test/queue_size = many, but must be");
  ros::param::del("/tracking_under_test");
}

TEST(NodeParametersTest, NamesAMissingCalibrationFile) {
  ExpectFatal("_camera_config:=/nowhere/camera.yaml", "/nowhere/camera.yaml");
  ros::param::del("/tracking_under_test");
}

// node_parameters.test loads config/tracking.yaml into ~documented.
TEST(NodeParametersTest, FileRepeatsTheDefaults) {
  const TrackingNodeParameters defaults;
  const TrackingNodeParameters read = ReadParameters<TrackingNodeParameters>(ros::NodeHandle("~documented"));
  const auto expect_equal = [](const auto& expected, const auto& actual) {
    using Options = std::decay_t<decltype(expected)>;
    std::vector<std::string> expected_values, actual_values;
    const auto into = [](std::vector<std::string>& values) {
      return [&values](const char* name, const auto& value, const auto&...) {
        std::ostringstream text;
        text << name << " = " << value;
        values.push_back(text.str());
      };
    };
    Options::Visit(expected, into(expected_values));
    Options::Visit(actual, into(actual_values));
    EXPECT_EQ(expected_values, actual_values);
  };
  expect_equal(defaults.publisher, read.publisher);
  expect_equal(defaults.pairer, read.pairer);
  expect_equal(defaults.node, read.node);
  expect_equal(defaults.localization.features, read.localization.features);
  expect_equal(defaults.localization.tracking, read.localization.tracking);
  expect_equal(defaults.localization.local_mapping, read.localization.local_mapping);
}

TEST(NodeParametersTest, DocumentationListsEachWithItsDefault) {
  std::ifstream file(SEMANTIC_SLAM_SOURCE_DIR "/docs/ros_api.md");
  const std::string documentation((std::istreambuf_iterator<char>(file)), {});
  const auto expect_listed = [&](const std::string& group, const auto& options) {
    using Options = std::decay_t<decltype(options)>;
    Options::Visit(options, [&](const char* name, const auto& value, const auto&...) {
      std::ostringstream row;
      row << std::boolalpha << "| `~" << group << name << "` | ";
      const std::size_t at = documentation.find(row.str());
      ASSERT_NE(at, std::string::npos) << row.str();
      std::ostringstream text;
      text << std::boolalpha << value;
      const std::string line = documentation.substr(at, documentation.find('\n', at) - at);
      const std::string expected = text.str().empty() ? "(empty)" : text.str();
      EXPECT_NE(line.find(" | " + expected), std::string::npos) << line << ": not " << expected;
    });
  };
  TrackingNodeParameters defaults;
  expect_listed("", defaults.node);
  expect_listed("", defaults.input);
  expect_listed("", defaults.publisher);
  expect_listed("pairer/", defaults.pairer);
  semantic_slam::LocalizationOptions::VisitGroups(
      defaults.localization,
      [&](const std::string& name, const auto& group) { expect_listed(name + "/", group); });
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "node_parameters_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
