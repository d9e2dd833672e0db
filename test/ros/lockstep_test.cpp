#include "semantic_slam_ros/lockstep.h"

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

using semantic_slam::Stamp;

LockstepOptions Impatient() {
  LockstepOptions options;
  options.wait_limit_s = 0.01;
  options.start_limit_s = 60.0;
  return options;
}

TEST(LockstepTest, BeginsWhenTheFirstImageWasTracked) {
  Lockstep lockstep(Impatient(), false);
  lockstep.NoteTracked(Stamp{1}, false);
  lockstep.AwaitAnswers(Stamp{1});
  EXPECT_FALSE(lockstep.began()) << "tracking answered, but does not follow yet";
  lockstep.NoteTracked(Stamp{2}, true);
  lockstep.AwaitAnswers(Stamp{2});
  EXPECT_TRUE(lockstep.began());
  EXPECT_EQ(lockstep.late_tracking(), 0);
}

TEST(LockstepTest, WithControlTheFirstCommandMustComeToo) {
  Lockstep lockstep(Impatient(), true);
  lockstep.NoteTracked(Stamp{1}, true);
  lockstep.AwaitAnswers(Stamp{1});
  EXPECT_FALSE(lockstep.began());
  lockstep.NoteTracked(Stamp{2}, true);
  lockstep.NoteCommanded(Stamp{2});
  lockstep.AwaitAnswers(Stamp{2});
  EXPECT_TRUE(lockstep.began());
  EXPECT_EQ(lockstep.late_control(), 0);
}

TEST(LockstepTest, BeginsWithoutAnswersWhenTheLimitHasRunOut) {
  LockstepOptions options = Impatient();
  options.start_limit_s = 0.0;
  Lockstep lockstep(options, true);
  lockstep.AwaitAnswers(Stamp{1});
  EXPECT_TRUE(lockstep.began());
}

TEST(LockstepTest, CountsWaitsThatRanOutAndGoesOn) {
  Lockstep lockstep(Impatient(), true);
  lockstep.NoteTracked(Stamp{1}, true);
  lockstep.NoteCommanded(Stamp{1});
  lockstep.AwaitAnswers(Stamp{1});
  ASSERT_TRUE(lockstep.began());
  lockstep.AwaitAnswers(Stamp{2});
  EXPECT_EQ(lockstep.late_tracking(), 1);
  EXPECT_EQ(lockstep.late_control(), 0) << "without a pose there is no command to wait for";
  lockstep.NoteTracked(Stamp{3}, false);
  lockstep.AwaitAnswers(Stamp{3});
  EXPECT_EQ(lockstep.late_tracking(), 1);
  EXPECT_EQ(lockstep.late_control(), 1);
}

TEST(LockstepTest, WithoutLockstepNobodyWaits) {
  LockstepOptions options;
  options.lockstep = false;
  options.wait_limit_s = 600.0;
  Lockstep lockstep(options, true);
  EXPECT_TRUE(lockstep.began());
  lockstep.AwaitAnswers(Stamp{1});
  EXPECT_EQ(lockstep.late_tracking(), 0);
}

TEST(LockstepTest, RestartsAsItStarted) {
  Lockstep lockstep(Impatient(), false);
  lockstep.NoteTracked(Stamp{1}, true);
  lockstep.AwaitAnswers(Stamp{1});
  ASSERT_TRUE(lockstep.began());
  lockstep.Restart();
  EXPECT_FALSE(lockstep.began());
  lockstep.AwaitAnswers(Stamp{1});
  EXPECT_FALSE(lockstep.began()) << "that answer was to another image";
}

}  // namespace
}  // namespace semantic_slam_ros
