#include "semantic_slam_ros/transform_tree.h"

#include <algorithm>
#include <iterator>

#include "semantic_slam/common/interpolation.h"

namespace semantic_slam_ros {

using semantic_slam::Interpolated;
using semantic_slam::Rigid3d;
using semantic_slam::Stamp;
using semantic_slam::Trajectory;

namespace {

// Well below what a sensor mount holds, well above the rounding of a repeated broadcast.
constexpr double kSameTransform = 1e-7;

// A tree has no longer chains; a ring of links, which is malformed, would have no end.
constexpr std::size_t kMaxLinks = 100;

}  // namespace

void TransformTree::Add(const std::string& parent, const std::string& child, Stamp stamp,
                        const Rigid3d& T_parent_child) {
  if (parent.empty() || child.empty() || parent == child) return;
  Link& link = links_[child];
  if (link.samples.empty()) link.parent = parent;
  if (link.parent != parent) return;
  if (!link.samples.empty()) {
    const Rigid3d& first = link.samples.begin()->second;
    link.moves = link.moves || !((first.matrix() - T_parent_child.matrix()).cwiseAbs().maxCoeff() <
                                 kSameTransform);
  }
  link.samples.emplace(stamp, T_parent_child);
}

std::vector<const TransformTree::Link*> TransformTree::LinksAbove(const std::string& frame) const {
  std::vector<const Link*> links;
  for (auto it = links_.find(frame); it != links_.end() && links.size() < kMaxLinks;
       it = links_.find(it->second.parent)) {
    links.push_back(&it->second);
  }
  return links;
}

std::optional<Rigid3d> TransformTree::Fixed(const std::string& target,
                                            const std::string& source) const {
  // Poses of all frames that the target is fixed to, seen from the target.
  std::map<std::string, Rigid3d> T_target_frame{{target, Rigid3d::Identity()}};
  Rigid3d T = Rigid3d::Identity();
  for (const Link* link : LinksAbove(target)) {
    if (link->moves) break;
    T = T * link->samples.begin()->second.inverse();
    T_target_frame[link->parent] = T;
  }
  Rigid3d T_frame_source = Rigid3d::Identity();
  std::string frame = source;
  const std::vector<const Link*> links = LinksAbove(source);
  for (auto link = links.begin();; ++link) {
    const auto found = T_target_frame.find(frame);
    if (found != T_target_frame.end()) return found->second * T_frame_source;
    if (link == links.end() || (*link)->moves) return std::nullopt;
    T_frame_source = (*link)->samples.begin()->second * T_frame_source;
    frame = (*link)->parent;
  }
}

std::optional<Rigid3d> TransformTree::At(const Link& link, Stamp stamp) {
  if (!link.moves) return link.samples.begin()->second;
  const auto after = link.samples.lower_bound(stamp);
  if (after == link.samples.end()) return std::nullopt;
  if (after->first == stamp) return after->second;
  if (after == link.samples.begin()) return std::nullopt;
  const auto before = std::prev(after);
  return Interpolated(
      before->second, after->second,
      SecondsBetween(before->first, stamp) / SecondsBetween(before->first, after->first));
}

std::optional<Rigid3d> TransformTree::Product(const std::vector<const Link*>& links, Stamp stamp) {
  Rigid3d T_top_frame = Rigid3d::Identity();
  for (const Link* link : links) {
    const auto T_parent_child = At(*link, stamp);
    if (!T_parent_child) return std::nullopt;
    T_top_frame = *T_parent_child * T_top_frame;
  }
  return T_top_frame;
}

Trajectory TransformTree::Path(const std::string& root, const std::string& frame) const {
  std::vector<const Link*> links = LinksAbove(frame);
  const auto top = std::find_if(links.begin(), links.end(),
                                [&](const Link* link) { return link->parent == root; });
  if (top == links.end()) return {};
  links.erase(top + 1, links.end());
  const Link* clock = nullptr;
  for (const Link* link : links) {
    if (!link->moves) continue;
    if (clock == nullptr || link->samples.size() > clock->samples.size()) clock = link;
  }
  if (clock == nullptr) return {};
  Trajectory path;
  for (const auto& [stamp, unused] : clock->samples) {
    if (const auto T_root_frame = Product(links, stamp)) path.push_back({stamp, *T_root_frame});
  }
  return path;
}

}  // namespace semantic_slam_ros
