#pragma once

namespace semantic_slam {

// CPU time that the calling thread has taken since it began [s].
double ThreadCpuSeconds();

// The same of all threads of the process, also those that have ended.
double ProcessCpuSeconds();

}  // namespace semantic_slam
