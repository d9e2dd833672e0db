#include "semantic_slam/evaluation/trajectory_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

namespace semantic_slam {
namespace {

constexpr double kDegPerRad = 180.0 / M_PI;
constexpr double kIntervalTolerance = 0.1;  // [s]
constexpr double kRounding = 1e-9;          // [m], ten steps of 0.1 m are a metre

// Length of the reference's path from the first match to each.
std::vector<double> PathAtMatches(const std::vector<MatchedPose>& matches) {
  std::vector<double> path_m(matches.size(), 0.0);
  for (std::size_t i = 1; i < matches.size(); ++i) {
    path_m[i] = path_m[i - 1] + (matches[i].T_reference_sensor.translation() -
                                 matches[i - 1].T_reference_sensor.translation())
                                    .norm();
  }
  return path_m;
}

// thesis eq. (4.5), corrected as the header says.
void AddPair(const MatchedPose& start, const MatchedPose& end, double path_m,
             RelativeErrors& errors) {
  const Rigid3d motion = start.T_reference_sensor.inverse() * end.T_reference_sensor;
  const Rigid3d estimated_motion = start.T_estimate_sensor.inverse() * end.T_estimate_sensor;
  const Rigid3d error = motion.inverse() * estimated_motion;
  errors.translation_m.push_back(error.translation().norm());
  errors.rotation_deg.push_back(kDegPerRad * RotationAngle(error.linear()));
  errors.path_m.push_back(path_m);
}

// The later pose whose stamp is nearest to `start` + interval_s; of two equally near the earlier.
std::optional<std::size_t> MatchAfterInterval(const std::vector<double>& stamps_s,
                                              std::size_t start, double interval_s) {
  const auto next = static_cast<std::size_t>(
      std::lower_bound(stamps_s.begin(), stamps_s.end(), stamps_s[start] + interval_s) -
      stamps_s.begin());
  const auto off_s = [&](std::size_t i) {
    return std::abs(stamps_s[i] - stamps_s[start] - interval_s);
  };
  std::optional<std::size_t> best;
  for (const std::size_t i : {next - 1, next}) {
    if (i <= start || i >= stamps_s.size()) continue;
    if (!best || off_s(i) < off_s(*best)) best = i;
  }
  if (best && off_s(*best) > kIntervalTolerance) return std::nullopt;
  return best;
}

double MeanPerMetre(const std::vector<double>& errors, const std::vector<double>& path_m) {
  if (errors.empty()) return 0.0;
  const double sum = std::inner_product(errors.begin(), errors.end(), path_m.begin(), 0.0,
                                        std::plus<>(), std::divides<>());
  return sum / static_cast<double>(errors.size());
}

}  // namespace

ErrorStatistics Summarise(std::vector<double> errors) {
  if (errors.empty()) return {};
  std::sort(errors.begin(), errors.end());
  const auto n = static_cast<double>(errors.size());
  const std::size_t middle = errors.size() / 2;
  ErrorStatistics statistics;
  statistics.rmse =
      std::sqrt(std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0) / n);
  statistics.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / n;
  statistics.median =
      errors.size() % 2 == 1 ? errors[middle] : 0.5 * (errors[middle - 1] + errors[middle]);
  statistics.max = errors.back();
  return statistics;
}

AbsoluteErrors ComputeAbsoluteErrors(const std::vector<MatchedPose>& matches,
                                     const Rigid3d& T_reference_estimate) {
  AbsoluteErrors errors;
  for (const MatchedPose& match : matches) {
    const Rigid3d aligned = T_reference_estimate * match.T_estimate_sensor;
    const Eigen::Vector3d dp = match.T_reference_sensor.translation() - aligned.translation();
    const Eigen::Matrix3d dR = match.T_reference_sensor.linear() * aligned.linear().transpose();
    errors.position_m.push_back(dp.norm());
    errors.rotation_deg.push_back(kDegPerRad * RotationAngle(dR));
    errors.deviation_xy_m.push_back(std::hypot(dp.x(), dp.y()));
    errors.deviation_xz_m.push_back(std::hypot(dp.x(), dp.z()));
  }
  return errors;
}

RelativeErrors RelativeErrorsOverTime(const std::vector<MatchedPose>& matches, double interval_s) {
  assert(interval_s > 0.0);
  std::vector<double> stamps_s;
  stamps_s.reserve(matches.size());
  for (const MatchedPose& match : matches) stamps_s.push_back(RoundedSeconds(match.stamp));
  const std::vector<double> path_m = PathAtMatches(matches);
  RelativeErrors errors;
  for (std::size_t start = 0; start < matches.size(); ++start) {
    const auto end = MatchAfterInterval(stamps_s, start, interval_s);
    if (end) AddPair(matches[start], matches[*end], path_m[*end] - path_m[start], errors);
  }
  return errors;
}

RelativeErrors RelativeErrorsOverPath(const std::vector<MatchedPose>& matches, double segment_m) {
  assert(segment_m > 0.0);
  const std::vector<double> path_m = PathAtMatches(matches);
  RelativeErrors errors;
  std::size_t end = 0;
  for (std::size_t start = 0; start < matches.size(); ++start) {
    while (end < matches.size() && path_m[end] - path_m[start] < segment_m - kRounding) ++end;
    if (end == matches.size()) break;
    AddPair(matches[start], matches[end], path_m[end] - path_m[start], errors);
  }
  return errors;
}

double MeanTranslationPercent(const RelativeErrors& errors) {
  return 100.0 * MeanPerMetre(errors.translation_m, errors.path_m);
}

double MeanRotationDegPerMetre(const RelativeErrors& errors) {
  return MeanPerMetre(errors.rotation_deg, errors.path_m);
}

double ReferencePathLength(const std::vector<MatchedPose>& matches) {
  return matches.empty() ? 0.0 : PathAtMatches(matches).back();
}

}  // namespace semantic_slam
