#pragma once

#include <set>
#include <string>

#include <ros/node_handle.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/options.h"

namespace semantic_slam_ros {

// Reads a node's private parameters into options structs (see semantic_slam/common/options.h), whose
// initialisers are the defaults, and refuses what nobody asked for, so that a misspelt parameter
// stops the node. Every ConfigError carries the parameter's full name.
//
//   ParamReader params(private_nh);
//   params.Read(node_options);              // ~map_frame, ~publish_tf, ...
//   params.ReadGroup("features", features);  // ~features/max_features, ...
//   params.Finish();
class ParamReader {
 public:
  explicit ParamReader(const ros::NodeHandle& private_nh) : nh_(private_nh) {}

  // Leaves an option alone if its parameter is not set. Throws ConfigError if one has another type
  // (a whole number will do for a fraction, nothing else is converted) or is out of range.
  template <typename Options>
  void Read(Options& options) {
    ReadGroup("", options);
  }
  template <typename Options>
  void ReadGroup(const std::string& group, Options& options) {
    const std::string prefix = group.empty() ? "" : group + "/";
    Options::Visit(options, OptionReader{*this, prefix});
    try {
      semantic_slam::Validate(options);
    } catch (const semantic_slam::ConfigError& e) {
      throw semantic_slam::ConfigError(FullName(prefix) + e.what());
    }
  }

  // Throws ConfigError if there is a private parameter that no call asked for.
  void Finish() const;

 private:
  struct OptionReader {
    ParamReader& reader;
    const std::string& prefix;
    template <typename T, typename... Range>
    void operator()(const char* name, T& value, const Range&...) const {
      reader.ReadOne(prefix + name, value);
    }
  };

  void ReadOne(const std::string& name, bool& value);
  void ReadOne(const std::string& name, int& value);
  void ReadOne(const std::string& name, double& value);
  void ReadOne(const std::string& name, std::string& value);

  // The parameter's value, or nothing if it is not set; either way it is known from now on.
  bool Find(const std::string& name, XmlRpc::XmlRpcValue& value);
  std::string FullName(const std::string& name) const { return nh_.getNamespace() + "/" + name; }

  const ros::NodeHandle nh_;
  std::set<std::string> known_;  // full names
};

// All parameters of a node. `Parameters` is a struct of options structs that lists them, with their
// groups ("" for none), for a visitor that is called once per struct:
//
//   template <typename Self, typename Visitor>
//   static void VisitGroups(Self& self, Visitor&& visit) {
//     visit("", self.node);
//     visit("features", self.features);
//   }
//
// Throws ConfigError naming a parameter that is unknown, out of range or of another type.
template <typename Parameters>
Parameters ReadParameters(const ros::NodeHandle& private_nh) {
  Parameters parameters;
  ParamReader reader(private_nh);
  Parameters::VisitGroups(parameters, [&reader](const std::string& group, auto& options) {
    reader.ReadGroup(group, options);
  });
  reader.Finish();
  return parameters;
}

}  // namespace semantic_slam_ros
