#include "semantic_slam/map/point_store.h"

#include <vector>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

std::vector<PointId> Ids(const PointStore& store) {
  std::vector<PointId> ids;
  store.ForEach([&ids](const MapPoint& point) { ids.push_back(point.id); });
  return ids;
}

TEST(PointStoreTest, FindsWhatWasAdded) {
  PointStore store;
  const PointId a = store.Add().id, b = store.Add().id;
  store.Find(b)->visible = 7;
  EXPECT_EQ(store.Find(a)->id, a);
  EXPECT_EQ(store.Find(b)->visible, 7);
  EXPECT_EQ(store.size(), 2u);
  EXPECT_EQ(Ids(store), (std::vector<PointId>{a, b}));
}

TEST(PointStoreTest, KnowsNothingElse) {
  PointStore store;
  EXPECT_EQ(store.Find(0), nullptr);
  store.Add();
  for (const PointId id : {kNoPoint, PointId{1}, PointId{12345}, PointId{1} << 24}) {
    EXPECT_EQ(store.Find(id), nullptr) << id;
  }
}

TEST(PointStoreTest, AnErasedPointIsGoneAndItsIdToo) {
  PointStore store;
  const PointId a = store.Add().id, b = store.Add().id;
  store.Erase(a);
  EXPECT_EQ(store.Find(a), nullptr);
  const PointId c = store.Add().id;  // where a was
  EXPECT_GT(c, b);
  EXPECT_EQ(store.Find(a), nullptr);
  EXPECT_EQ(store.Find(c)->id, c);
  EXPECT_EQ(store.Find(c)->visible, MapPoint().visible) << "nothing is left of the one before";
  EXPECT_EQ(store.size(), 2u);
}

TEST(PointStoreTest, DoesNotGrowWithPointsThatComeAndGo) {
  PointStore store;
  PointId last = store.Add().id;
  for (int i = 0; i < 1000; ++i) {
    const PointId next = store.Add().id;
    ASSERT_GT(next, last);
    store.Erase(last);
    last = next;
  }
  EXPECT_EQ(store.size(), 1u);
  EXPECT_EQ(store.places(), 2u);
}

TEST(PointStoreTest, VisitingMayEraseWhatIsVisited) {
  PointStore store;
  for (int i = 0; i < 6; ++i) store.Add().visible = i;
  store.ForEach([&store](const MapPoint& point) {
    if (point.visible % 2 == 0) store.Erase(point.id);
  });
  EXPECT_EQ(store.size(), 3u);
}

TEST(PointStoreTest, IdsGoOnAfterClearing) {
  PointStore store;
  const PointId before = store.Add().id;
  store.Clear();
  EXPECT_EQ(store.size(), 0u);
  EXPECT_EQ(store.Find(before), nullptr);
  EXPECT_GT(store.Add().id, before);
}

}  // namespace
}  // namespace semantic_slam
