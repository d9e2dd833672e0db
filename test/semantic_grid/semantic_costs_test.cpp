#include "semantic_slam/semantic_grid/semantic_costs.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/semantic_grid/semantic_cells.h"
#include "testing/small_vocabulary.h"

namespace semantic_slam {
namespace {

// Free up to 0.25, in full from 0.75, half way at 0.5; the robot flies from 0 to 1 m.
SemanticCostOptions Options() {
  SemanticCostOptions options;
  options.free_probability = 0.25;
  options.lethal_probability = 0.75;
  options.flight_min_height_m = 0.0;
  options.flight_max_height_m = 1.0;
  options.height_margin_m = 0.1;
  return options;
}

MapObject Object(std::vector<LabelProbability> labels, double min_height_m, double max_height_m) {
  MapObject object;
  object.labels = std::move(labels);
  object.min_height_m = min_height_m;
  object.max_height_m = max_height_m;
  return object;
}

TEST(SemanticCostsTest, TurnsOccupancyIntoCost) {
  const SemanticCosts costs(Options());
  EXPECT_EQ(costs.OfOccupancy(-1), SemanticCells::kUnknown);
  EXPECT_EQ(costs.OfOccupancy(0), SemanticCells::kFree);
  EXPECT_EQ(costs.OfOccupancy(25), SemanticCells::kFree);
  EXPECT_EQ(costs.OfOccupancy(50), 127);
  EXPECT_EQ(costs.OfOccupancy(74), 249);
  EXPECT_EQ(costs.OfOccupancy(75), SemanticCells::kLethal);
  EXPECT_EQ(costs.OfOccupancy(100), SemanticCells::kLethal);
}

TEST(SemanticCostsTest, NeverSaysInscribedOfAProbability) {
  const SemanticCosts costs(Options());
  // A share of 0.9975 of 254 is 253.4.
  EXPECT_EQ(costs.Of(0.74875, 254.0), SemanticCells::kInscribed - 1);
}

TEST(SemanticCostsTest, ScalesTheClassesCost) {
  const SemanticCosts costs(Options());
  EXPECT_EQ(costs.Of(0.9, 100.0), 100);
  EXPECT_EQ(costs.Of(0.5, 100.0), 50);
  EXPECT_EQ(costs.Of(0.1, 100.0), 0);
  EXPECT_EQ(costs.Of(1.0, 0.0), 0);
}

TEST(SemanticCostsTest, OptionsMayDrawOneLineBetweenFreeAndLethal) {
  SemanticCostOptions options = Options();
  options.free_probability = options.lethal_probability = 0.5;
  const SemanticCosts costs(options);
  EXPECT_EQ(costs.Of(0.49, 254.0), SemanticCells::kFree);
  EXPECT_EQ(costs.Of(0.5, 254.0), SemanticCells::kLethal);
}

TEST(SemanticCostsTest, AnObjectCostsTheMeanOfItsClasses) {
  const SemanticCosts costs(Options());
  const LabelVocabulary vocabulary = SmallVocabulary();  // chair 100, table 254, lamp 50, floor 0
  EXPECT_DOUBLE_EQ(costs.OfObject(Object({{3, 1.0f}}, 0.0, 1.0), vocabulary), 100.0);
  EXPECT_DOUBLE_EQ(costs.OfObject(Object({{3, 0.5f}, {9, 0.5f}}, 0.0, 1.0), vocabulary), 75.0);
  EXPECT_DOUBLE_EQ(costs.OfObject(Object({{4, 0.5f}}, 0.0, 1.0), vocabulary), 254.0)
      << "whatever else it may be is taken to cost the same";
  EXPECT_DOUBLE_EQ(costs.OfObject(Object({{2, 0.5f}}, 0.0, 1.0), vocabulary), 0.0);
  EXPECT_DOUBLE_EQ(costs.OfObject(Object({}, 0.0, 1.0), vocabulary), 254.0) << "unknown's";
}

TEST(SemanticCostsTest, AnObjectAboveOrBelowTheRobotCostsNothing) {
  const SemanticCosts costs(Options());
  const LabelVocabulary vocabulary = SmallVocabulary();
  const auto cost = [&](double low, double high) {
    return costs.OfObject(Object({{4, 1.0f}}, low, high), vocabulary);
  };
  EXPECT_EQ(cost(-1.0, -0.2), 0.0) << "0.1 m of air remain";
  EXPECT_EQ(cost(-1.0, -0.05), 254.0) << "within the margin";
  EXPECT_EQ(cost(1.2, 2.0), 0.0);
  EXPECT_EQ(cost(1.05, 2.0), 254.0);
  EXPECT_EQ(cost(-5.0, 5.0), 254.0);
}

TEST(SemanticCostsTest, CombinesByMaximum) {
  const SemanticCosts costs(Options());
  EXPECT_EQ(costs.Combined(0, 1.0, 100.0), 100);
  EXPECT_EQ(costs.Combined(120, 1.0, 100.0), 120);
  EXPECT_EQ(costs.Combined(254, 1.0, 0.0), 254);
}

TEST(SemanticCostsTest, OnlyASureObjectMakesAnUnknownCellKnown) {
  const SemanticCosts costs(Options());
  constexpr std::uint8_t kUnknown = SemanticCells::kUnknown;
  EXPECT_EQ(costs.Combined(kUnknown, 0.8, 100.0), 100);
  EXPECT_EQ(costs.Combined(kUnknown, 0.7, 254.0), kUnknown);
  EXPECT_EQ(costs.Combined(kUnknown, 1.0, 0.0), kUnknown) << "a mat does not make a cell free";
}

TEST(SemanticCostsTest, PublishesCostsAsCostmap2dDoes) {
  EXPECT_EQ(ToOccupancyPercent(0), 0);
  EXPECT_EQ(ToOccupancyPercent(1), 1);
  EXPECT_EQ(ToOccupancyPercent(252), 98);
  EXPECT_EQ(ToOccupancyPercent(253), 99);
  EXPECT_EQ(ToOccupancyPercent(254), 100);
  EXPECT_EQ(ToOccupancyPercent(255), -1);
  for (int cost = 1; cost < 255; ++cost) {
    EXPECT_GE(ToOccupancyPercent(static_cast<std::uint8_t>(cost)),
              ToOccupancyPercent(static_cast<std::uint8_t>(cost - 1)));
  }
}

TEST(SemanticCostsTest, RefusesOptionsThatContradictEachOther) {
  SemanticCostOptions options = Options();
  options.free_probability = 0.8;
  EXPECT_THROW(SemanticCosts{options}, ConfigError);
  options = Options();
  options.flight_min_height_m = 1.5;
  EXPECT_THROW(SemanticCosts{options}, ConfigError);
}

}  // namespace
}  // namespace semantic_slam
