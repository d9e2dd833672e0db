#include "semantic_slam/random_worlds/room_recipes.h"

#include <map>
#include <string>

#include "semantic_slam/random_worlds/choice.h"

namespace semantic_slam {
namespace {

using Make = std::function<Arrangement(PieceMaker&)>;

Make Standing(const std::string& kind) {
  return [kind](PieceMaker& maker) { return SinglePiece(maker, kind, Anchor::kFree); };
}

Make AtWall(const std::string& kind) {
  return [kind](PieceMaker& maker) { return SinglePiece(maker, kind, Anchor::kWall); };
}

Make Row(const std::string& kind, int most) {
  return [kind, most](PieceMaker& maker) { return RowAtWall(maker, kind, most); };
}

Make Hanging(const std::string& kind, double low_m, double high_m) {
  return [=](PieceMaker& maker) { return OnWall(maker, kind, low_m, high_m); };
}

// What walls and corners have in most rooms.
std::vector<Wish> With(std::vector<Wish> wishes, double pictures) {
  const std::vector<Wish> common{{Hanging("picture", 1.0, 1.6), pictures, 3},
                                 {Hanging("poster", 0.9, 1.5), 0.5 * pictures, 2},
                                 {Hanging("clock", 1.6, 1.95), 0.2},
                                 {Hanging("mirror", 0.7, 1.1), 0.15},
                                 {Hanging("wall_shelf", 1.1, 1.6), 0.25},
                                 {Standing("plant"), 0.3},
                                 {Standing("palm"), 0.2},
                                 {Standing("snake_plant"), 0.2},
                                 {Standing("floor_lamp"), 0.25}};
  wishes.insert(wishes.end(), common.begin(), common.end());
  return wishes;
}

std::map<RoomType, std::vector<Wish>> AllWishes() {
  return {
      {RoomType::kLiving, With({{SofaGroup},
                                {TvGroup, 0.8},
                                {RoundTableGroup, 0.2},
                                {Row("bookshelf", 3), 0.7},
                                {AtWall("sideboard"), 0.4},
                                {Standing("armchair"), 0.4},
                                {DeskAtWall, 0.2},
                                {AtWall("dresser"), 0.15}},
                               0.7)},
      {RoomType::kDining, With({{DiningGroup},
                                {AtWall("sideboard"), 0.7},
                                {AtWall("dresser"), 0.3},
                                {Row("bookshelf", 2), 0.5},
                                {ChairRow, 0.15}},
                               0.7)},
      {RoomType::kKitchen, With({{KitchenRow},
                                 {KitchenRow, 0.25},
                                 {DiningGroup, 0.35},
                                 {RoundTableGroup, 0.45},
                                 {AtWall("rack"), 0.4},
                                 {AtWall("fridge"), 0.3},
                                 {Hanging("towel", 0.9, 1.2), 0.5},
                                 {Hanging("wall_cabinet", 1.4, 1.6), 0.3, 2}},
                                0.3)},
      {RoomType::kBedroom, With({{BedGroup},
                                 {Row("wardrobe", 2), 0.8},
                                 {AtWall("dresser"), 0.65},
                                 {DeskAtWall, 0.4},
                                 {BedGroup, 0.15},
                                 {Standing("chair"), 0.4},
                                 {AtWall("bench"), 0.2},
                                 {Row("bookshelf", 2), 0.4},
                                 {Standing("clothes"), 0.15}},
                                0.6)},
      {RoomType::kStudy, With({{DeskAtWall, 0.7},
                               {DeskInRoom, 0.6},
                               {Row("bookshelf", 4), 0.9},
                               {Whiteboard, 0.5},
                               {SofaGroup, 0.45},
                               {Standing("armchair"), 0.3},
                               {Row("filing_cabinet", 2), 0.3},
                               {Hanging("pin_board", 0.9, 1.2), 0.3}},
                              0.4)},
      {RoomType::kOffice, With({{ConferenceGroup, 0.25},
                                {DeskBlock, 0.6},
                                {DeskAtWall, 0.7, 3},
                                {DeskInRoom, 0.5, 2},
                                {Whiteboard, 0.8, 2},
                                {Row("filing_cabinet", 4), 0.6},
                                {Row("bookshelf", 3), 0.6},
                                {AtWall("rack"), 0.25},
                                {SofaGroup, 0.15},
                                {Hanging("pin_board", 0.9, 1.2), 0.3},
                                {Hanging("coats", 0.85, 1.05), 0.2}},
                               0.4)},
      {RoomType::kMeeting, With({{ConferenceGroup},
                                 {Whiteboard, 0.9},
                                 {TvGroup, 0.4},
                                 {ChairRow, 0.3},
                                 {AtWall("sideboard"), 0.4},
                                 {Whiteboard, 0.3}},
                                0.4)},
      {RoomType::kCorridor, With({{AtWall("bench"), 0.5},
                                  {Hanging("coats", 0.85, 1.05), 0.5},
                                  {ChairRow, 0.35},
                                  {Whiteboard, 0.25},
                                  {AtWall("sideboard"), 0.3},
                                  {Row("filing_cabinet", 3), 0.25},
                                  {Hanging("pin_board", 0.9, 1.2), 0.4}},
                                 0.8)},
      {RoomType::kWaiting, With({{LoungeGroup},
                                 {ChairRow, 0.7},
                                 {SofaGroup, 0.6},
                                 {Whiteboard, 0.2},
                                 {RoundTableGroup, 0.2},
                                 {AtWall("bench"), 0.3}},
                                0.7)},
  };
}

struct WeightedType {
  RoomType type;
  double weight;
};

const std::vector<WeightedType>& HomeTypes() {
  static const std::vector<WeightedType> types{{RoomType::kLiving, 4},  {RoomType::kDining, 3},
                                               {RoomType::kKitchen, 4}, {RoomType::kBedroom, 4},
                                               {RoomType::kStudy, 2},   {RoomType::kCorridor, 0.3}};
  return types;
}

const std::vector<WeightedType>& OfficeTypes() {
  static const std::vector<WeightedType> types{{RoomType::kOffice, 3},     {RoomType::kMeeting, 6},
                                               {RoomType::kWaiting, 2},    {RoomType::kStudy, 2},
                                               {RoomType::kCorridor, 0.4}, {RoomType::kKitchen, 2}};
  return types;
}

}  // namespace

const std::vector<Wish>& WishesOf(RoomType type) {
  static const std::map<RoomType, std::vector<Wish>> wishes = AllWishes();
  return wishes.at(type);
}

const std::vector<Wish>& OddWishes() {
  static const std::vector<Wish> wishes{
      {Standing("chair"), 0.25, 2}, {Standing("office_chair"), 0.15},
      {Standing("stool"), 0.12},    {Standing("coffee_table"), 0.15},
      {Standing("armchair"), 0.12}, {Standing("desk"), 0.06},
      {Standing("sofa"), 0.14},     {Whiteboard, 0.12},
      {Standing("box"), 0.2, 2},    {Standing("bag"), 0.2},
      {Standing("crate"), 0.1},     {Standing("toy"), 0.1},
      {Standing("person"), 0.2, 2}, {AtWall("single_bed"), 0.03},
      {AtWall("fridge"), 0.04},     {AtWall("sideboard"), 0.08}};
  return wishes;
}

std::vector<RoomType> ChooseTypes(const std::vector<bool>& narrow, RandomStream& random) {
  const double use = random.Uniform();
  std::vector<RoomType> types;
  for (const bool is_narrow : narrow) {
    const bool is_home = use < 0.5 || (use > 0.84 && Chance(random, 0.5));
    const RoomType type = WeightedOneOf(random, is_home ? HomeTypes() : OfficeTypes()).type;
    types.push_back(is_narrow ? RoomType::kCorridor : type);
  }
  return types;
}

}  // namespace semantic_slam
