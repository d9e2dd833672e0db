#include "semantic_octree/mapping_method.h"

#include <algorithm>
#include <utility>

#include "semantic_octree/octomap_method.h"
#include "semantic_octree/semantic_method.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

using Maker = std::function<std::unique_ptr<MappingMethod>(const MappingSettings&)>;

const std::vector<std::pair<std::string, Maker>>& Makers() {
  static const std::vector<std::pair<std::string, Maker>> makers{
      {"octree_eager_disc",
       [](const MappingSettings& s) { return MakeOctomapMethod(s, InnerNodes::kEager); }},
      {"octree_lazy_disc",
       [](const MappingSettings& s) { return MakeOctomapMethod(s, InnerNodes::kLazy); }},
      {"color_eager_disc", [](const MappingSettings& s) { return MakeColourOctomapMethod(s); }},
      {"semantic", [](const MappingSettings& s) { return MakeSemanticMethod(s); }},
  };
  return makers;
}

}  // namespace

std::vector<std::string> MappingMethodNames() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : Makers()) names.push_back(name);
  return names;
}

std::unique_ptr<MappingMethod> MakeMappingMethod(const std::string& name,
                                                 const MappingSettings& settings) {
  std::string known;
  for (const auto& [key, maker] : Makers()) {
    if (key == name) return maker(settings);
    known += (known.empty() ? "" : ", ") + key;
  }
  throw ConfigError("--method = " + name + ", but must be one of: " + known);
}

}  // namespace semantic_slam
