#include "semantic_slam/common/heap.h"

#include <cstdlib>

#include <gtest/gtest.h>

// Only glibc's own heap tells, and not that of a sanitizer.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#if __GLIBC_PREREQ(2, 33)
#include <malloc.h>

namespace semantic_slam {
namespace {

TEST(HeapTest, AnImageIsABlockOfItsOwnEvenAfterALargerOneWasFreed) {
  ReturnLargeBlocks();
  // Volatile, or the compiler leaves out what nobody uses.
  void* volatile larger = std::malloc(16 << 20);
  std::free(larger);  // after which glibc would keep what is smaller
  const auto before = mallinfo2().hblks;
  void* volatile image = std::malloc(1 << 20);
  EXPECT_EQ(mallinfo2().hblks, before + 1);
  std::free(image);
  EXPECT_EQ(mallinfo2().hblks, before);
}

}  // namespace
}  // namespace semantic_slam

#endif
#endif
