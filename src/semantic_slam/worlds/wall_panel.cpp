#include "semantic_slam/worlds/wall_panel.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr float kSameM = 1e-4f;

// Sorted, from 0 to `end_m`, without what is nearly the same.
std::vector<float> Cuts(std::vector<float> cuts, float end_m) {
  cuts.push_back(0.0f);
  cuts.push_back(end_m);
  std::sort(cuts.begin(), cuts.end());
  const auto same = [](float a, float b) { return std::abs(a - b) < kSameM; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
  return cuts;
}

// The cells into which the edges of the holes cut a wall.
class WallGrid {
 public:
  WallGrid(float length_m, float height_m, const std::vector<WallRectangle>& holes)
      : holes_(holes) {
    std::vector<float> along;
    std::vector<float> up;
    for (const WallRectangle& hole : holes) {
      along.insert(along.end(), {hole.left_m, hole.right_m});
      up.insert(up.end(), {hole.bottom_m, hole.top_m});
    }
    along_m_ = Cuts(along, length_m);
    up_m_ = Cuts(up, height_m);
  }

  int columns() const { return static_cast<int>(along_m_.size()) - 1; }
  int rows() const { return static_cast<int>(up_m_.size()) - 1; }

  WallRectangle Cell(int column, int row) const {
    return {along_m_[column], along_m_[column + 1], up_m_[row], up_m_[row + 1]};
  }

  // False for what is cut out and for all around the wall.
  bool IsSolid(int column, int row) const {
    if (column < 0 || row < 0 || column >= columns() || row >= rows()) return false;
    const WallRectangle cell = Cell(column, row);
    const float y = 0.5f * (cell.left_m + cell.right_m);
    const float z = 0.5f * (cell.bottom_m + cell.top_m);
    return std::none_of(holes_.begin(), holes_.end(), [&](const WallRectangle& hole) {
      return y > hole.left_m && y < hole.right_m && z > hole.bottom_m && z < hole.top_m;
    });
  }

 private:
  const std::vector<WallRectangle>& holes_;
  std::vector<float> along_m_;
  std::vector<float> up_m_;
};

// A rectangle whose texture begins at `texture_m`.
void AddFace(Mesh& mesh, const Eigen::Vector3f& corner_m, const Eigen::Vector3f& right_m,
             const Eigen::Vector3f& down_m, const Eigen::Vector2f& texture_m) {
  Mesh face = QuadMesh(corner_m, right_m, down_m);
  for (Eigen::Vector2f& t : face.texture_m) t += texture_m;
  Append(mesh, face);
}

}  // namespace

Mesh WallPanelMesh(float length_m, float height_m, float thickness_m,
                   const std::vector<WallRectangle>& holes) {
  const WallGrid grid(length_m, height_m, holes);
  const Eigen::Vector3f back(-thickness_m, 0, 0);
  Mesh mesh;
  for (int column = 0; column < grid.columns(); ++column) {
    for (int row = 0; row < grid.rows(); ++row) {
      if (!grid.IsSolid(column, row)) continue;
      const WallRectangle cell = grid.Cell(column, row);
      const Eigen::Vector3f along(0, cell.right_m - cell.left_m, 0);
      const Eigen::Vector3f down(0, 0, cell.bottom_m - cell.top_m);
      const Eigen::Vector3f top_left(0, cell.left_m, cell.top_m);
      const Eigen::Vector2f texture_m(cell.left_m, height_m - cell.top_m);
      AddFace(mesh, top_left, along, down, texture_m);
      AddFace(mesh, top_left + along + back, -along, down, texture_m);
      if (!grid.IsSolid(column - 1, row)) {
        AddFace(mesh, top_left + back, -back, down, texture_m);
      }
      if (!grid.IsSolid(column + 1, row)) {
        AddFace(mesh, top_left + along, back, down, texture_m);
      }
      if (!grid.IsSolid(column, row + 1)) {
        AddFace(mesh, top_left + back, along, -back, texture_m);
      }
      if (!grid.IsSolid(column, row - 1)) {
        AddFace(mesh, top_left + down, along, back, texture_m);
      }
    }
  }
  return mesh;
}

}  // namespace semantic_slam
