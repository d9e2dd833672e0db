#include "semantic_slam/semantic_grid/cell_classes.h"

#include <gtest/gtest.h>

#include "testing/small_vocabulary.h"

namespace semantic_slam {
namespace {

SemanticCells ThreeCells(int classes) {
  SemanticCells cells;
  cells.width = 3;
  cells.height = 1;
  cells.classes_per_cell = classes;
  cells.labels.assign(3 * classes, kUnknownLabel);
  cells.probabilities.assign(3 * classes, 0);
  return cells;
}

MapObject Object(std::vector<LabelProbability> labels) {
  MapObject object;
  object.labels = std::move(labels);
  return object;
}

// Covers cells from `x` on with these probabilities.
PlacedObject Placed(const MapObject& object, int x, std::vector<float> presence) {
  const cv::Mat row(1, static_cast<int>(presence.size()), CV_32FC1, presence.data());
  return {&object, {cv::Rect(x, 0, row.cols, 1), row.clone()}};
}

using Bytes = std::vector<std::uint8_t>;

TEST(CellClassesTest, ACellHasTheObjectsClassesByTheirProbability) {
  SemanticCells cells = ThreeCells(2);
  const MapObject object = Object({{4, 0.75f}, {3, 0.25f}});
  FillClasses({Placed(object, 1, {1.0f, 0.5f})}, SmallVocabulary(), 0.0, cells);
  EXPECT_EQ(cells.labels, (Bytes{0, 0, 4, 3, 4, 3}));
  // floor(255 p) of 0.75, 0.25 and half of them
  EXPECT_EQ(cells.probabilities, (Bytes{0, 0, 191, 63, 95, 31}));
}

TEST(CellClassesTest, TwoViewsAsOneClassStrengthenEachOther) {
  SemanticCells cells = ThreeCells(1);
  const MapObject object = Object({{4, 0.5f}});
  FillClasses({Placed(object, 0, {1.0f}), Placed(object, 0, {1.0f, 0.5f})}, SmallVocabulary(), 0.0,
              cells);
  EXPECT_EQ(cells.probabilities, (Bytes{191, 63, 0})) << "1 - 0.5 * 0.5, and 0.25";
}

TEST(CellClassesTest, AThingOnATableLeavesTheTableAsProbable) {
  SemanticCells cells = ThreeCells(2);
  const MapObject table = Object({{4, 0.75f}}), lamp = Object({{9, 1.0f}});
  FillClasses({Placed(table, 0, {1.0f, 1.0f}), Placed(lamp, 1, {1.0f})}, SmallVocabulary(), 0.0,
              cells);
  EXPECT_EQ(cells.labels, (Bytes{4, 0, 9, 4, 0, 0}));
  EXPECT_EQ(cells.probabilities, (Bytes{191, 0, 255, 191, 0, 0}));
}

TEST(CellClassesTest, KeepsTheMostProbableOnes) {
  SemanticCells cells = ThreeCells(2);
  const MapObject object = Object({{9, 0.5f}, {1, 0.25f}, {3, 0.125f}, {4, 0.125f}});
  FillClasses({Placed(object, 0, {1.0f})}, SmallVocabulary(), 0.0, cells);
  EXPECT_EQ(cells.labels, (Bytes{9, 1, 0, 0, 0, 0}));
}

TEST(CellClassesTest, OfEqualOnesTheSmallerIdIsFirst) {
  SemanticCells cells = ThreeCells(2);
  const MapObject object = Object({{9, 0.25f}, {4, 0.25f}, {3, 0.25f}});
  FillClasses({Placed(object, 0, {1.0f})}, SmallVocabulary(), 0.0, cells);
  EXPECT_EQ(cells.labels, (Bytes{3, 4, 0, 0, 0, 0}));
}

TEST(CellClassesTest, LeavesOutWhatIsImprobableOrUnknown) {
  SemanticCells cells = ThreeCells(3);
  const MapObject object = Object({{0, 0.5f}, {4, 0.25f}, {3, 0.0625f}});
  FillClasses({Placed(object, 0, {1.0f})}, SmallVocabulary(), 0.125, cells);
  EXPECT_EQ(cells.labels, (Bytes{4, 0, 0, 0, 0, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace semantic_slam
