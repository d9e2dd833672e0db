#include "semantic_slam/plane_projection/plane_ransac.h"

#include <cmath>

#include <pcl/console/print.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_perpendicular_plane.h>

namespace semantic_slam {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Model = pcl::SampleConsensusModelPlane<pcl::PointXYZ>;
using LevelModel = pcl::SampleConsensusModelPerpendicularPlane<pcl::PointXYZ>;

// With probability 99 % one sample has inliers only; then RANSAC stops early.
constexpr double kSuccessProbability = 0.99;

// PCL prints a line for every sample of points on one line and whenever there is no plane, but neither
// is an error here. Its verbosity is one for the whole process.
void SilencePcl() {
  static const bool silenced = [] {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    return true;
  }();
  (void)silenced;
}

Cloud::Ptr ToPcl(const std::vector<Eigen::Vector3f>& points) {
  auto cloud = Cloud::Ptr(new Cloud);
  cloud->reserve(points.size());
  for (const Eigen::Vector3f& p : points) cloud->push_back({p.x(), p.y(), p.z()});
  return cloud;
}

// PCL's models draw from a generator with a fixed seed unless they are told not to.
Model::Ptr MakeModel(const Cloud::ConstPtr& cloud, const PlaneConstraint& constraint) {
  if (!constraint.axis) return Model::Ptr(new Model(cloud));
  auto level = LevelModel::Ptr(new LevelModel(cloud));
  level->setAxis(constraint.axis->cast<float>());
  level->setEpsAngle(constraint.max_tilt_rad);
  return level;
}

Plane ToPlane(const Eigen::VectorXf& coefficients, const PlaneConstraint& constraint) {
  Plane plane;
  plane.normal = coefficients.head<3>().cast<double>();
  plane.offset_m = coefficients[3];
  const double length = plane.normal.norm();
  const bool points_away = constraint.axis && plane.normal.dot(*constraint.axis) < 0.0;
  const double scale = (points_away ? -1.0 : 1.0) / length;
  plane.normal *= scale;
  plane.offset_m *= scale;
  return plane;
}

bool IsWithinTilt(const Plane& plane, const PlaneConstraint& constraint) {
  return plane.normal.allFinite() && (!constraint.axis || plane.normal.dot(*constraint.axis) >=
                                                              std::cos(constraint.max_tilt_rad));
}

std::vector<int> PointsOn(const Plane& plane, const std::vector<Eigen::Vector3f>& points,
                          double tolerance_m) {
  std::vector<int> on;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(plane.SignedDistance(points[i].cast<double>())) <= tolerance_m) {
      on.push_back(static_cast<int>(i));
    }
  }
  return on;
}

}  // namespace

std::optional<PlaneFit> FitPlane(const std::vector<Eigen::Vector3f>& points, int min_inliers,
                                 const PlaneConstraint& constraint) {
  if (points.size() < 3 || static_cast<int>(points.size()) < min_inliers) return std::nullopt;
  SilencePcl();
  const Model::Ptr model = MakeModel(ToPcl(points), constraint);
  pcl::RandomSampleConsensus<pcl::PointXYZ> ransac(model, constraint.tolerance_m);
  ransac.setProbability(kSuccessProbability);
  ransac.setMaxIterations(constraint.max_iterations);
  if (!ransac.computeModel()) return std::nullopt;
  std::vector<int> inliers;
  ransac.getInliers(inliers);
  if (static_cast<int>(inliers.size()) < min_inliers) return std::nullopt;
  Eigen::VectorXf coefficients, refined;
  ransac.getModelCoefficients(coefficients);
  model->optimizeModelCoefficients(inliers, coefficients, refined);
  PlaneFit fit;
  fit.plane = ToPlane(refined, constraint);
  if (!IsWithinTilt(fit.plane, constraint)) fit.plane = ToPlane(coefficients, constraint);
  fit.inliers = PointsOn(fit.plane, points, constraint.tolerance_m);
  if (static_cast<int>(fit.inliers.size()) < min_inliers) return std::nullopt;
  return fit;
}

}  // namespace semantic_slam
