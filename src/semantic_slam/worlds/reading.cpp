#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"

namespace semantic_slam {
namespace {

// Books that lie on one another, not quite straight.
void BuildBookStack(FurnitureBuilder& b) {
  const int books = std::max(1, static_cast<int>(std::lround(b.height() / 0.032f)));
  const float each_m = b.height() / books;
  for (int i = 0; i < books; ++i) {
    const float shrink = i == 0 ? 1.0f : b.Random(0.72f, 0.98f);
    const Eigen::Vector2f half = 0.47f * shrink * Eigen::Vector2f(b.depth(), b.width());
    const Rigid3d T(Eigen::AngleAxisd(b.Random(-0.14f, 0.14f), Eigen::Vector3d::UnitZ()));
    const std::string cover = i % 3 == 0 ? "cover_a" : i % 3 == 1 ? "cover_b" : "cover_c";
    const Eigen::Vector3f low(-half.x(), -half.y(), i * each_m);
    const Eigen::Vector3f high(half.x(), half.y(), (i + 1) * each_m);
    if (i + 1 == books) {
      b.BoxWithPictureOnTop(cover, "title", low, high, T);
    } else {
      b.BoxWithPicture(cover, "spine", low, high, T);
    }
  }
  b.FitToSize();
}

// Books side by side, their backs to the front.
void BuildBookRow(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float front = 0.5f * b.depth();
  const float side = 0.5f * b.width();
  const float split = b.Random(-0.3f, 0.3f) * side;
  b.BoxWithPicture("cover_a", "spine", {rear, split, 0}, {front, side, b.height()});
  b.BoxWithPicture("cover_b", "spine", {rear, -side, 0},
                   {front - 0.02f, split, 0.88f * b.height()});
}

void BuildSheets(FurnitureBuilder& b) {
  b.BoxWithPictureOnTop("paper", "print", {-0.5f * b.depth(), -0.5f * b.width(), 0},
                        {0.5f * b.depth(), 0.5f * b.width(), b.height()});
}

FurnitureKind SheetsOf(const std::string& name, const Eigen::Vector3f& size_m,
                       const std::string& pattern) {
  return {name,
          "paper",
          Mount::kFloor,
          size_m,
          {{"paper", MakeMaterial("paper", {238, 236, 228})},
           {"print", MakeMaterial(pattern, {232, 228, 216})}},
          {},
          BuildSheets};
}

}  // namespace

std::vector<FurnitureKind> ReadingKinds() {
  const std::map<std::string, Material> row{{"cover_a", MakeMaterial("paper", {150, 50, 44})},
                                            {"cover_b", MakeMaterial("paper", {40, 82, 120})},
                                            {"spine", MakeMaterial("books", {130, 90, 60})}};
  std::map<std::string, Material> stack = row;
  stack.emplace("cover_c", MakeMaterial("paper", {206, 170, 80}));
  stack.emplace("title", MakeMaterial("magazine", {200, 180, 150}));
  return {{"book_stack", "books", Mount::kFloor, {0.22f, 0.28f, 0.13f}, stack, {}, BuildBookStack},
          {"book_row", "books", Mount::kFloor, {0.18f, 0.4f, 0.26f}, row, {}, BuildBookRow},
          SheetsOf("magazine", {0.29f, 0.21f, 0.006f}, "magazine"),
          SheetsOf("newspaper", {0.4f, 0.3f, 0.008f}, "newspaper"),
          SheetsOf("paper", {0.297f, 0.21f, 0.004f}, "newspaper")};
}

}  // namespace semantic_slam
