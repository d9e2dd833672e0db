#pragma once

namespace semantic_slam {

// Has large blocks, such as images, given back to the system when they are freed. By itself glibc
// stops doing so after the first of them, and images that come and go among small things that stay
// leave holes in the heap: replay needs 184 MB in place of 172 on freiburg1_desk. To be called
// once, at a program's start. Does nothing with other C libraries.
void ReturnLargeBlocks();

}  // namespace semantic_slam
