#pragma once

#include "semantic_slam/worlds/furniture.h"

namespace semantic_slam {

inline Mesh WholeMesh(const Furniture& furniture) {
  Mesh whole;
  for (const FurniturePart& part : furniture.parts) Append(whole, part.mesh);
  return whole;
}

inline FurnitureRequest RequestOf(const FurnitureKind& kind, int design) {
  FurnitureRequest request;
  if (DesignCount(kind) > 1) request.numbers["design"] = design;
  return request;
}

}  // namespace semantic_slam
