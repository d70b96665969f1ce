// Reports of the motion engine: activity, motion, phase, fallen.
#include "murosimf/locomotion/motion_report.h"

#include <cmath>

#include <gtest/gtest.h>

namespace murosimf::locomotion {
namespace {

const NamedMotions motions{{"dive_left", {}}, {"get_up_back", {}}, {"kick_left", {}}, {"protect_front", {}}};

MotionReport told(MotionMode mode, int motion, double amplitude = 0, double time = 0) {
  return motion_report(motions,
                       {.mode = static_cast<double>(mode),
                        .motion = static_cast<double>(motion),
                        .time = time,
                        .blend = 1,
                        .duration = 4},
                       {}, amplitude);
}

TEST(MotionReport, SaysWhatTheRobotDoes) {
  EXPECT_EQ(told(MotionMode::walk, -1).activity, Activity::stand);
  EXPECT_EQ(told(MotionMode::walk, -1, 0.1).activity, Activity::walk);
  EXPECT_EQ(told(MotionMode::play, 2).activity, Activity::play);
  EXPECT_EQ(told(MotionMode::play, 0).activity, Activity::dive);
  EXPECT_EQ(told(MotionMode::protect, -1).activity, Activity::fall);
  EXPECT_EQ(told(MotionMode::protect, 3).activity, Activity::protect);
  EXPECT_EQ(told(MotionMode::lie, -1).activity, Activity::lie);
  EXPECT_EQ(told(MotionMode::get_up, 1).activity, Activity::get_up);
}

TEST(MotionReport, CountsThePhaseFromWhereTheJointsHaveCome) {
  EXPECT_EQ(told(MotionMode::play, 2, 0, 0.5).phase, 0);
  EXPECT_EQ(told(MotionMode::play, 2, 0, 2).phase, 0.25);
  EXPECT_EQ(told(MotionMode::play, 2, 0, 5).phase, 1);
  EXPECT_EQ(told(MotionMode::play, 2, 0, 9).phase, 1);
  EXPECT_EQ(told(MotionMode::play, 2).motion, 2);
  EXPECT_EQ(told(MotionMode::walk, 2).motion, -1) << "it waits until the robot stands";
}

TEST(MotionReport, SaysThatItHasFallen) {
  EXPECT_TRUE(told(MotionMode::lie, -1).fallen);
  EXPECT_TRUE(told(MotionMode::get_up, 1).fallen);
  for (const double lean : {0.0, 0.9, 1.1, 3.0}) {
    GaitState gait;
    gait.attitude.up = {std::sin(lean), 0, std::cos(lean)};
    EXPECT_EQ(motion_report(motions, {}, gait, 0).fallen, lean > 1.05) << lean;
  }
}

}  // namespace
}  // namespace murosimf::locomotion
