#include "semantic_slam_ros/param_reader.h"

#include <sstream>
#include <vector>

namespace semantic_slam_ros {

using semantic_slam::ConfigError;
using XmlRpc::XmlRpcValue;

namespace {

// Libraries that read private parameters of their own.
constexpr char kDiagnosticPeriod[] = "diagnostic_period";

std::string ToText(const XmlRpcValue& value) {
  std::ostringstream text;
  value.write(text);
  return text.str();
}

[[noreturn]] void ThrowWrongType(const std::string& full_name, const XmlRpcValue& value,
                                 const char* expected) {
  throw ConfigError(full_name + " = " + ToText(value) + ", but must be " + expected);
}

}  // namespace

void ParamReader::Finish() const {
  const std::string prefix = FullName("");
  std::vector<std::string> names;
  nh_.getParamNames(names);
  for (const std::string& name : names) {
    if (name.compare(0, prefix.size(), prefix) != 0 || known_.count(name) != 0) continue;
    if (name == FullName(kDiagnosticPeriod)) continue;
    throw ConfigError("unknown parameter " + name + "; docs/ros_api.md lists those there are");
  }
}

void ParamReader::ReadOne(const std::string& name, bool& value) {
  XmlRpcValue found;
  if (!Find(name, found)) return;
  if (found.getType() != XmlRpcValue::TypeBoolean) {
    ThrowWrongType(FullName(name), found, "true or false");
  }
  value = static_cast<bool&>(found);
}

void ParamReader::ReadOne(const std::string& name, int& value) {
  XmlRpcValue found;
  if (!Find(name, found)) return;
  if (found.getType() != XmlRpcValue::TypeInt) {
    ThrowWrongType(FullName(name), found, "a whole number");
  }
  value = static_cast<int&>(found);
}

void ParamReader::ReadOne(const std::string& name, double& value) {
  XmlRpcValue found;
  if (!Find(name, found)) return;
  if (found.getType() == XmlRpcValue::TypeInt) {
    value = static_cast<int&>(found);
  } else if (found.getType() == XmlRpcValue::TypeDouble) {
    value = static_cast<double&>(found);
  } else {
    ThrowWrongType(FullName(name), found, "a number");
  }
}

void ParamReader::ReadOne(const std::string& name, std::string& value) {
  XmlRpcValue found;
  if (!Find(name, found)) return;
  if (found.getType() != XmlRpcValue::TypeString) {
    ThrowWrongType(FullName(name), found, "a text");
  }
  value = static_cast<std::string&>(found);
}

bool ParamReader::Find(const std::string& name, XmlRpcValue& value) {
  known_.insert(FullName(name));
  return nh_.getParam(name, value);
}

}  // namespace semantic_slam_ros
