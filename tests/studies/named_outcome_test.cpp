// Outcomes that users name: what they are called, and when they are off, for made-up runs.
#include "murosimf/studies/named_outcome.h"

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/model/error.h"
#include "murosimf/studies/compare_verdict.h"

namespace murosimf::studies {
namespace {

const std::vector<OutcomeOwner> owners{{"robot", true, true}, {"ball", false, false}, {"red.1", false, true}};

NamedOutcome named(const std::string& text) { return named_outcome(text, owners); }

std::string error(const std::string& text) {
  try {
    static_cast<void>(named(text));
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(NamedOutcome, HasAnOwnerAQuantityAndATolerance) {
  const NamedOutcome end = named("ball.end");
  EXPECT_EQ(end.name(), "ball.end");
  EXPECT_FALSE(end.tolerance.has_value());
  EXPECT_FALSE(end.of_robot);
  EXPECT_EQ(named("red.1.falls=0.5").owner, "red.1");
  EXPECT_EQ(named("red.1.falls=0.5").tolerance, 0.5);
  EXPECT_TRUE(named("robot.pitch=3").of_robot);
}

TEST(NamedOutcome, SaysWhatIsKnown) {
  const std::string known =
      "known: robot.way, end, falls, path_length, path, center_mean, center_max, pitch, roll, rate, "
      "slip, clearance; ball.way, end, speed, touched; red.1.way, end, speed, touched, falls";
  EXPECT_EQ(error("bal.end"), "--outcome 'bal.end': nothing that moves is called 'bal'; " + known);
  EXPECT_EQ(error("ball.falls"), "--outcome 'ball.falls': unknown quantity 'falls'; " + known);
  EXPECT_EQ(error("robot.others_way"), "--outcome 'robot.others_way': unknown quantity 'others_way'; " + known);
  EXPECT_EQ(error("ball"), "--outcome 'ball': write NAME.QUANTITY; " + known);
  for (const char* text : {"ball.end=", "ball.end=x", "ball.end=-1", "ball.end=nan", "ball.end=1m"}) {
    EXPECT_NE(error(text).find("the tolerance must be a number from 0"), std::string::npos) << text;
  }
}

/// A robot that ends at `x` [m], and a ball that rolls for 2 s at `speed` [m/s].
CompareEntry run(double x, double speed) {
  CompareEntry e;
  e.measures.events = {{0, false}};
  e.measures.end = {x, 0, 0.3};
  e.measures.path_length = x;
  OtherRecord ball, red;
  ball.name = "ball";
  red.name = "red.1";
  red.can_fall = true;
  for (int i = 0; i <= 200; ++i) ball.samples.push_back({0.01 * i, {0.01 * i * speed, 0, 0.1}, speed, 1});
  for (int i = 0; i <= 200; ++i) red.samples.push_back({0.01 * i, {0, 1, 0.3}, 0, i < 100 ? 1.0 : 0.0});
  ball.touched = ball.touched_last = 0.5;
  e.outcome.others = {ball, red};
  return e;
}

OutcomeOff off(const std::string& text, const CompareEntry& entry, const CompareEntry& reference) {
  return outcome_off(named(text), entry, reference, {});
}

TEST(NamedOutcome, IsOffByMoreThanItsTolerance) {
  const CompareEntry reference = run(1, 1), far = run(1.3, 1.3);
  EXPECT_NEAR(off("ball.way", far, reference).value, 0.6, 1e-9);
  EXPECT_EQ(off("ball.way", far, reference).reason, "ball.way 0.60 m off, more than 0.40 m") << "20 % of 2 m";
  EXPECT_EQ(off("ball.way=0.7", far, reference).reason, "");
  EXPECT_EQ(off("ball.way=0.7", far, reference).closeness, "ball.way within 0.60 m");
  EXPECT_EQ(off("ball.end", far, reference).reason, "ball.end 0.60 m off, more than 0.40 m");
  EXPECT_EQ(off("ball.speed", far, reference).reason, "ball.speed 0.30 m/s off, more than 0.20 m/s");
  EXPECT_EQ(off("ball.speed", run(1, 1.1), reference).reason, "");
  EXPECT_EQ(off("robot.end", far, reference).reason, "robot.end 0.30 m off, more than 0.20 m");
  EXPECT_EQ(off("robot.way", far, reference).reason, "robot.way 0.30 m off, more than 0.20 m");
  EXPECT_EQ(off("robot.way=0.31", far, reference).reason, "");
  CompareEntry turned = reference;
  turned.deviations.pitch = 4 * pi / 180;
  EXPECT_EQ(off("robot.pitch", turned, reference).reason, "");
  EXPECT_EQ(off("robot.pitch=3", turned, reference).reason, "robot.pitch 4.0 deg off, more than 3.0 deg");
}

TEST(NamedOutcome, FallsAndTouchesAreTold) {
  const CompareEntry reference = run(1, 1);
  CompareEntry other = reference;
  EXPECT_EQ(off("robot.falls", other, reference).reason, "");
  EXPECT_EQ(off("red.1.falls", other, reference).reason, "");
  EXPECT_EQ(off("ball.touched=0", other, reference).reason, "");
  other.measures.events.push_back({1, true});
  EXPECT_EQ(off("robot.falls", other, reference).reason, "robot.falls: falls once, the reference does not");
  for (int i = 0; i <= 200; ++i)
    other.outcome.others[1].samples[static_cast<std::size_t>(i)].cos_lean = i < 150 ? 1 : 0;
  EXPECT_EQ(off("red.1.falls", other, reference).reason, "red.1.falls: falls 0.50 s later than the reference");
  EXPECT_EQ(off("red.1.falls=0.6", other, reference).reason, "");
  other.outcome.others[0].touched = 0.9;
  EXPECT_EQ(off("ball.touched", other, reference).reason, "") << "whenever";
  EXPECT_EQ(off("ball.touched=0.3", other, reference).reason, "ball.touched: touches it 0.40 s off");
  other.outcome.others[0].touched.reset();
  EXPECT_EQ(off("ball.touched", other, reference).reason, "ball.touched: does not touch it, the reference does");
}

TEST(NamedOutcome, DecidesAlone) {
  const CompareEntry reference = run(1, 1);
  CompareEntry entry = reference;
  entry.deviations.pitch = 1;
  entry.measures.events.push_back({1, true});
  EXPECT_FALSE(judge(entry, reference, {}).adequate);
  EXPECT_TRUE(judge(entry, reference, {}, {named("ball.end"), named("robot.end")}).adequate);
  EXPECT_FALSE(judge(entry, reference, {}, {named("ball.end"), named("robot.falls")}).adequate);
  entry.frozen = "too fast";
  EXPECT_FALSE(judge(entry, reference, {}, {named("ball.end")}).adequate) << "it has no outcome";
}

}  // namespace
}  // namespace murosimf::studies
