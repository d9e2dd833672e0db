#include "semantic_slam/simulation/mesh_parts.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace semantic_slam {
namespace {

double Area(const Mesh& mesh) {
  double area = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.positions_m[t[0]];
    area += 0.5 * (mesh.positions_m[t[1]] - a).cross(mesh.positions_m[t[2]] - a).norm();
  }
  return area;
}

float LongestEdge(const Mesh& mesh) {
  float longest_m = 0.0f;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      longest_m =
          std::max(longest_m, (mesh.positions_m[t[i]] - mesh.positions_m[t[(i + 1) % 3]]).norm());
    }
  }
  return longest_m;
}

TEST(MeshPartsTest, FacesOfABoxAreFlatParts) {
  const std::vector<Mesh> parts = ConnectedParts(BoxMesh({1, 2, 3}, {1, 1, 2}));
  ASSERT_EQ(parts.size(), 6u);
  for (const Mesh& part : parts) {
    EXPECT_TRUE(IsFlat(part));
    EXPECT_EQ(part.triangles.size(), 2u);
    EXPECT_EQ(part.positions_m.size(), 4u);
  }
}

TEST(MeshPartsTest, ACylinderIsACurvedSideAndTwoFlatLids) {
  const std::vector<Mesh> parts = ConnectedParts(CylinderMesh({0, 0, 0}, 0.5f, 0.5f, 1.0f));
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(std::count_if(parts.begin(), parts.end(), IsFlat), 2);
}

TEST(MeshPartsTest, LeavesOutWhatCannotBeDrawn) {
  Mesh mesh = BoxMesh({0, 0, 0}, {1, 1, 1});
  mesh.triangles.emplace_back(0, 0, 1);    // no area
  mesh.triangles.emplace_back(0, 1, 999);  // no such corner
  mesh.triangles.emplace_back(-1, 1, 2);
  mesh.positions_m[0].x() = std::numeric_limits<float>::quiet_NaN();  // of two triangles
  std::size_t triangles = 0;
  for (const Mesh& part : ConnectedParts(mesh)) triangles += part.triangles.size();
  EXPECT_EQ(triangles, 10u);
  EXPECT_TRUE(ConnectedParts(Mesh()).empty());
}

TEST(MeshPartsTest, RefinementShortensEdgesOnTheSameSurface) {
  const Mesh coarse = CylinderMesh({0, 0, 0}, 0.1f, 0.1f, 1.0f);
  const Mesh fine = Refined(coarse, 0.12f);
  EXPECT_LE(LongestEdge(fine), 0.12f);
  EXPECT_GT(fine.triangles.size(), coarse.triangles.size());
  EXPECT_NEAR(Area(fine), Area(coarse), 1e-5);  // sums of floats
  for (const Eigen::Vector3f& normal : fine.normals) EXPECT_NEAR(normal.norm(), 1.0f, 1e-5f);
}

TEST(MeshPartsTest, RefinementLeavesNoGaps) {
  // An edge within the surface belongs to two triangles, one each way.
  const Mesh fine = Refined(QuadMesh({0, 0, 0}, {1.0f, 0, 0}, {0, 0.3f, 0}), 0.2f);
  int inner = 0, rim = 0;
  const auto has_edge = [&](int a, int b) {
    return std::any_of(fine.triangles.begin(), fine.triangles.end(), [&](const auto& t) {
      return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
    });
  };
  for (const Eigen::Vector3i& t : fine.triangles) {
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      if (has_edge(b, a)) {
        ++inner;
        continue;
      }
      ++rim;
      const Eigen::Vector3f middle = 0.5f * (fine.positions_m[a] + fine.positions_m[b]);
      const bool on_rim =
          middle.x() == 0.0f || middle.x() == 1.0f || middle.y() == 0.0f || middle.y() == 0.3f;
      EXPECT_TRUE(on_rim) << middle.transpose();
    }
  }
  EXPECT_GT(inner, rim);
}

}  // namespace
}  // namespace semantic_slam
