#include "semantic_slam/common/heap.h"

#include <cstdlib>  // defines __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace semantic_slam {
namespace {

#ifdef __GLIBC__
constexpr int kLargeBytes = 256 * 1024;  // less than any image, more than what maps are made of
#endif

}  // namespace

void ReturnLargeBlocks() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, kLargeBytes);
#endif
}

}  // namespace semantic_slam
