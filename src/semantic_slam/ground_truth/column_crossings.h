#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/transform.h"
#include "semantic_slam/semantic_grid/presence_patch.h"
#include "semantic_slam/worlds/mesh.h"

namespace semantic_slam {

// Where the vertical line through a cell's centre passes through a triangle.
struct Crossing {
  cv::Point cell;  // of the lattice
  double z_m = 0.0;
  bool faces_up = false;
};

// All crossings of a mesh, cell by cell (row by row), in each upwards. A line through an edge that
// two triangles share crosses one of them. Triangles that stand upright are crossed by none.
std::vector<Crossing> CrossColumns(const Mesh& mesh, const Rigid3d& T_world_mesh,
                                   const CellLattice& lattice);

// A part of a column that is inside of a solid.
struct SolidPart {
  cv::Point cell;
  double low_m = 0.0;
  double high_m = 0.0;
};

// From where a line enters the solid, through a face that looks down, to where it has left it
// again. Faces without their counterpart, as those of a sheet, enclose nothing. `crossings` are as
// CrossColumns() orders them.
std::vector<SolidPart> SolidParts(const std::vector<Crossing>& crossings);

}  // namespace semantic_slam
