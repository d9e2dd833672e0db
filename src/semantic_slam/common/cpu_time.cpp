#include "semantic_slam/common/cpu_time.h"

#include <ctime>

namespace semantic_slam {
namespace {

double Seconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

double ThreadCpuSeconds() {
  return Seconds(CLOCK_THREAD_CPUTIME_ID);
}
double ProcessCpuSeconds() {
  return Seconds(CLOCK_PROCESS_CPUTIME_ID);
}

}  // namespace semantic_slam
