// Measures and deviations of made-up runs whose numbers are known in closed form.
#include "murosimf/studies/compare_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace murosimf::studies {
namespace {

using dynamics::MotionRecord;
using dynamics::MotionSample;

/// `seconds` long, a hundred samples a second and one more.
MotionRecord run(double seconds, const std::function<void(MotionSample&)>& shape) {
  MotionRecord record;
  record.soles = 2;
  for (int i = 0; i <= std::lround(100 * seconds); ++i) {
    MotionSample sample;
    sample.time = 0.01 * i;
    shape(sample);
    record.samples.push_back(sample);
  }
  return record;
}

MotionRecord straight(double speed, double seconds, const Vec3d& offset = {}) {
  return run(seconds, [&](MotionSample& s) { s.base = s.center = offset + Vec3d{speed * s.time, 0, 0}; });
}

TEST(CompareMetrics, APathIsAsLongAsItIs) {
  EXPECT_NEAR(measures_of(straight(0.2, 10)).path_length, 2, 1e-12);
  EXPECT_NEAR(measures_of(straight(0.2, 10.37)).path_length, 2.074, 1e-12)
      << "the rest after the last tenth of a meter";
  EXPECT_EQ(measures_of(MotionRecord{}).path_length, 0);
}

TEST(CompareMetrics, ARunDoesNotDeviateFromItself) {
  const MotionRecord record = straight(0.2, 3);
  const Deviations d = deviations_of(record, record);
  for (const double value :
       {d.path_length, d.path, d.center_mean, d.center_max, d.pitch, d.rate, d.slip, d.clearance}) {
    EXPECT_EQ(value, 0);
  }
  EXPECT_TRUE(std::isnan(d.torque)) << "no level has torques";
}

TEST(CompareMetrics, AParallelPathIsOffByItsDistance) {
  const Deviations d = deviations_of(straight(0.2, 10, {0, 0.3, 0}), straight(0.2, 10));
  EXPECT_NEAR(d.path, 0.3, 1e-12);
  EXPECT_NEAR(d.center_mean, 0.3, 1e-12);
  EXPECT_NEAR(d.center_max, 0.3, 1e-12);
  EXPECT_NEAR(d.path_length, 0, 1e-12);
}

TEST(CompareMetrics, ASlowerRunStaysOnThePath) {
  const Deviations d = deviations_of(straight(0.15, 10), straight(0.2, 10));
  EXPECT_NEAR(d.path_length, 0.25, 1e-12);
  EXPECT_NEAR(d.path, 0, 1e-12);
  EXPECT_NEAR(d.center_max, 0.5, 1e-12);
  EXPECT_NEAR(d.center_mean, 0.25, 1e-12);
}

TEST(CompareMetrics, SharesOfShortPathsCountAgainstAQuarterOfAMeter) {
  EXPECT_NEAR(deviations_of(straight(0.02, 10), straight(0.01, 10)).path_length, 0.4, 1e-12);
  EXPECT_NEAR(deviations_of(straight(0.02, 10), straight(0.04, 10)).path_length, 0.5, 1e-12);
}

// Whatever its frequency: the way of a walker is known, a robot that sways on the spot has none.
TEST(CompareMetrics, SwayingIsNoWay) {
  for (const double frequency : {0.3, 0.9, 1.7, 2.0, 3.1}) {
    const auto sway = [&](double speed) {
      return run(10, [&](MotionSample& s) {
        s.base = {speed * s.time, 0.02 * std::sin(2 * pi * frequency * s.time), 0};
      });
    };
    EXPECT_LT(measures_of(sway(0)).path_length, 0.02 + 1e-12) << frequency;
    EXPECT_NEAR(measures_of(sway(0.2)).path_length, 2, 0.12) << frequency;
    EXPECT_LT(deviations_of(sway(0), straight(0, 10)).path_length, 0.08 + 1e-12) << frequency;
  }
}

TEST(CompareMetrics, EveryPlaceCountsOfAWayWithoutSwaying) {
  EXPECT_NEAR(length_of_way({{0, 0, 0}, {0.01, 0, 0.3}, {0, 0, 0.1}}, 0), 0.02, 1e-12);
  EXPECT_NEAR(length_of_way({{0, 0, 0}, {0.01, 0, 0.3}, {0, 0, 0.1}}, 0.1), 0, 1e-12);
  EXPECT_EQ(length_of_way({}, 0), 0);
}

// It tips by 20 degrees per second squared from 1 s on, nods by 20 degrees at 0.5 s: 15 degrees at 1 + sqrt(1.5) s, 60 at 1 + sqrt(6) s.
TEST(CompareMetrics, AFallBeginsWhereTheRobotLeansForGood) {
  const double degree = pi / 180;
  const auto tips = run(4, [&](MotionSample& s) {
    s.pitch = s.time < 1 ? 20 * degree * std::exp(-std::pow((s.time - 0.5) / 0.1, 2))
                         : 10 * degree * (s.time - 1) * (s.time - 1);
  });
  EXPECT_NEAR(fall_begins(tips), 1 + std::sqrt(1.5), 0.0101);
  EXPECT_NEAR(measures_of(tips).events.at(1).time, 1 + std::sqrt(6.0), 0.0101);
  EXPECT_TRUE(std::isinf(fall_begins(straight(0.2, 3)))) << "it does not fall";
  EXPECT_TRUE(std::isinf(fall_begins(MotionRecord{})));
  const auto lies = run(2, [&](MotionSample& s) { s.pitch = s.time < 1 ? pi / 2 : 0; });
  EXPECT_TRUE(std::isinf(fall_begins(lies))) << "it only gets up";
}

TEST(CompareMetrics, APartEndsWhereItIsCut) {
  MotionRecord record = straight(0.1, 2);
  record.joints = {"knee", "ankle"};
  record.torques.resize(402, 1.0);
  const MotionRecord part = part_until(record, 0.5 + 1e-9);
  EXPECT_EQ(part.samples.size(), 51U);
  EXPECT_EQ(part.torques.size(), 102U);
  EXPECT_EQ(part_until(record, std::numeric_limits<double>::infinity()).samples.size(), 201U);
}

// 40 mm in 2 s, whenever the run began.
TEST(CompareMetrics, SlipIsThatOfTheTimeThatRan) {
  MotionRecord late = run(2, [](MotionSample& s) { s.slip = 0.02 * s.time; });
  for (MotionSample& sample : late.samples) sample.time += 100;
  EXPECT_NEAR(deviations_of(late, run(2, [](MotionSample&) {})).slip, 0.02, 1e-12);
}

TEST(CompareMetrics, OnlyWhatBothHaveIsComparedInTime) {
  const Deviations d = deviations_of(straight(0.1, 2), straight(0.2, 10));
  EXPECT_NEAR(d.center_max, 0.2, 1e-12);
}

TEST(CompareMetrics, AnglesAreComparedByTheRootOfTheMeanSquare) {
  const auto still = run(2, [](MotionSample&) {});
  const auto nods = run(2, [](MotionSample& s) {
    s.pitch = 0.1 * std::sin(2 * pi * s.time);
    s.roll = 0.3;
    s.rate = {0, 3, 4};
  });
  const Deviations d = deviations_of(nods, still);
  EXPECT_NEAR(d.pitch, 0.1 / std::sqrt(2), 2e-4) << "201 samples, of which 200 are two periods";
  EXPECT_NEAR(d.roll, 0.3, 1e-12);
  EXPECT_NEAR(d.rate, 5, 1e-12);
  EXPECT_NEAR(measures_of(nods).rate, 5, 1e-12);
}

TEST(CompareMetrics, AnglesGoRoundTheCircle) {
  const auto a = run(1, [](MotionSample& s) { s.pitch = pi - 0.01; });
  const auto b = run(1, [](MotionSample& s) { s.pitch = -pi + 0.01; });
  EXPECT_NEAR(deviations_of(a, b).pitch, 0.02, 1e-12);
}

TEST(CompareMetrics, FallsNeedSixtyDegreesAndEndAtThirty) {
  const double degree = pi / 180;
  const auto tumbles =
      run(8, [&](MotionSample& s) { s.pitch = 70 * degree * std::sin(pi * s.time / 2); });  // both ways
  const Measures m = measures_of(tumbles);
  EXPECT_EQ(m.falls, 4) << "on its face and on its back, twice each";
  ASSERT_GE(m.events.size(), 3U);
  EXPECT_FALSE(m.events[0].down);
  EXPECT_NEAR(m.events[1].time, 2 / pi * std::asin(60.0 / 70), 0.0101);
  EXPECT_NEAR(m.events[2].time, 2 - 2 / pi * std::asin(30.0 / 70), 0.0101);
  const auto leans = run(4, [&](MotionSample& s) { s.roll = 55 * degree * std::sin(pi * s.time / 2); });
  EXPECT_EQ(measures_of(leans).falls, 0);
}

TEST(CompareMetrics, WhoBeginsLyingHasNotFallen) {
  const auto rises = run(2, [](MotionSample& s) { s.pitch = s.time < 1 ? -pi / 2 : 0; });
  const Measures m = measures_of(rises);
  EXPECT_EQ(m.falls, 0);
  ASSERT_EQ(m.events.size(), 2U);
  EXPECT_TRUE(m.events[0].down);
  EXPECT_FALSE(m.events[1].down);
  EXPECT_NEAR(m.events[1].time, 1, 1e-12);
}

TEST(CompareMetrics, SlipIsARateAndClearanceTheHighest) {
  const auto slides = run(4, [](MotionSample& s) {
    s.slip = 0.05 * s.time;
    s.clearance = {0.03, 0.01 * s.time};
  });
  const Deviations d = deviations_of(slides, run(4, [](MotionSample&) {}));
  EXPECT_NEAR(d.slip, 0.05, 1e-12);
  EXPECT_NEAR(d.clearance, 0.04, 1e-12);
  EXPECT_NEAR(measures_of(slides).slip, 0.2, 1e-12);
}

TEST(CompareMetrics, ThePeakTorqueHasAJoint) {
  MotionRecord weak = run(0.02, [](MotionSample&) {}), strong = weak;
  weak.joints = strong.joints = {"knee", "ankle"};
  weak.torques = {0, 0, 1, -2, 1, 1};
  strong.torques = {0, 0, 3, 0, -4, 1};
  EXPECT_EQ(measures_of(strong).peak_joint, "knee");
  EXPECT_EQ(measures_of(strong).peak_torque, 4);
  EXPECT_EQ(measures_of(weak).peak_joint, "ankle");
  EXPECT_NEAR(deviations_of(weak, strong).torque, 0.5, 1e-12);
}

}  // namespace
}  // namespace murosimf::studies
