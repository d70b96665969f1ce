// What a run has done to others, for made-up records and for a kick.
#include "murosimf/studies/compare_outcome.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "murosimf/scene/scene.h"
#include "murosimf/studies/compare_verdict.h"
#include "tests/written_scene.h"

namespace murosimf::studies {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Something that moves along x with `speed` [m/s] for 5 s, and may fall at `fall` [s].
OtherRecord mover(const std::string& name, double speed, double fall = 100, bool can_fall = true) {
  OtherRecord record;
  record.name = name;
  record.can_fall = can_fall;
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.01 * i;
    record.samples.push_back({t, {speed * t, 0, 0.1}, speed, t >= fall ? 0.0 : 1.0});
  }
  return record;
}

OutcomeRecord outcome(std::vector<OtherRecord> others) { return {std::move(others), std::vector<bool>(501, false)}; }

TEST(CompareOutcome, ARunDoesNotDeviateFromItself) {
  const OutcomeRecord run = outcome({mover("ball", 0.7), mover("red", 0.2, 3)});
  Deviations d;
  compare_outcome(run, run, never, d);
  EXPECT_EQ(d.others_way.value, 0);
  EXPECT_EQ(d.others_end.value, 0);
  EXPECT_EQ(d.others_speed.value, 0);
  EXPECT_EQ(d.others_way.name, "");
  EXPECT_TRUE(different_touches(run, run).empty());
  EXPECT_TRUE(different_falls_of_others(run, run, 0.25).empty());
}

// Way, end and peak speed are shares of the reference's, of a quarter and half a meter per second at least; the worst counts.
TEST(CompareOutcome, SharesAreOfTheReference) {
  Deviations d;
  compare_outcome(outcome({mover("ball", 0.9), mover("red", 0.05)}), outcome({mover("ball", 0.6), mover("red", 0.06)}),
                  never, d);
  EXPECT_NEAR(d.others_way.value, 0.5, 1e-9);
  EXPECT_NEAR(d.others_end.value, 0.5, 1e-9);
  EXPECT_NEAR(d.others_speed.value, 0.5, 1e-9);
  EXPECT_EQ(d.others_way.name, "ball");
  Deviations slow;
  compare_outcome(outcome({mover("red", 0.03)}), outcome({mover("red", 0.04)}), never, slow);
  EXPECT_NEAR(slow.others_way.value, 0.2, 1e-9) << "5 cm of a quarter of a meter";
  EXPECT_NEAR(slow.others_speed.value, 0.02, 1e-9) << "of half a meter per second";
}

TEST(CompareOutcome, SomethingElsewhereIsOffThoughItsWayIsAsLong) {
  OtherRecord there = mover("ball", 0.6);
  for (OtherSample& sample : there.samples) sample.place = {0, sample.place.x, 0.1};
  Deviations d;
  compare_outcome(outcome({there}), outcome({mover("ball", 0.6)}), never, d);
  EXPECT_NEAR(d.others_way.value, 0, 1e-9);
  EXPECT_NEAR(d.others_end.value, std::sqrt(2.0), 1e-9);
}

/// It rolls with `speed` from 1 s on, twice as fast from 4 s on; touched at 1 s, and for the last time at `last` [s].
OutcomeRecord kicked(double speed, double last) {
  OtherRecord ball = mover("ball", 0);
  double x = 0;
  for (OtherSample& s : ball.samples) {
    s.speed = s.time < 1 ? 0 : s.time < 4 ? speed : 2 * speed;
    s.place = {x, 0, 0.1};
    x += 0.01 * s.speed;
  }
  ball.touched = 1;
  ball.touched_last = last;
  return outcome({ball});
}

// One of the robots begins to fall at 3 s.
TEST(CompareOutcome, OfAFallCountsWhatWasTouchedBefore) {
  const auto deviation = [](const OutcomeRecord& mine, const OutcomeRecord& reference) {
    Deviations d;
    compare_outcome(mine, reference, 3, d);
    return d;
  };
  const Deviations rolls = deviation(kicked(1.5, 1.1), kicked(1, 1.1));
  EXPECT_NEAR(rolls.others_way.value, 0.5, 1e-9);
  EXPECT_NEAR(rolls.others_speed.value, 0.5, 1e-9);
  OutcomeRecord stopped = kicked(1, 1.1);
  for (OtherSample& s : stopped.others[0].samples) s.place.x = std::min(s.place.x, 2.0);  // after the fall
  EXPECT_NEAR(deviation(stopped, kicked(1, 1.1)).others_way.value, 0.6, 1e-9) << "2 m of 5: to its end";
  stopped.others[0].touched_last = 3.5;
  EXPECT_NEAR(deviation(stopped, kicked(1, 1.1)).others_way.value, 0, 1e-9) << "the robot fell on it";
  stopped.others[0].touched = 3.5;
  EXPECT_NEAR(deviation(stopped, kicked(1, 1.1)).others_way.value, 0, 1e-9);
  EXPECT_NEAR(deviation(kicked(1.5, 3.5), kicked(1, 1.1)).others_way.value, 0.5, 1e-9) << "but what came before counts";
}

TEST(CompareOutcome, TouchesOfOneRunOnlyAreNamed) {
  OutcomeRecord mine = outcome({mover("ball", 0), mover("red", 0), mover("crate", 0)}), reference = mine;
  mine.others[0].touched = 1;
  reference.others[1].touched = 2;
  mine.others[2].touched = 1;
  reference.others[2].touched = 4;
  EXPECT_EQ(different_touches(mine, reference), (std::vector<std::string>{"touches ball, the reference does not",
                                                                          "does not touch red, the reference does"}));
  EXPECT_EQ(touched(mine), (std::vector<std::string>{"ball", "crate"}));
}

TEST(CompareOutcome, FallsOfOthersCount) {
  const auto differences = [](const OtherRecord& mine, const OtherRecord& reference) {
    return different_falls_of_others(outcome({mine}), outcome({reference}), 0.25);
  };
  EXPECT_EQ(differences(mover("red", 0, 2), mover("red", 0)),
            (std::vector<std::string>{"red: falls once, the reference does not"}));
  EXPECT_EQ(differences(mover("red", 0), mover("red", 0, 2)),
            (std::vector<std::string>{"red: does not fall, the reference does"}));
  EXPECT_EQ(differences(mover("red", 0, 2.5), mover("red", 0, 2)),
            (std::vector<std::string>{"red: falls 0.50 s later than the reference"}));
  EXPECT_TRUE(differences(mover("red", 0, 2.2), mover("red", 0, 2)).empty());
  EXPECT_TRUE(differences(mover("ball", 0, 2, false), mover("ball", 0, 100, false)).empty()) << "a ball only rolls";
}

// Of the samples within 50 ms of a touch (11 of one touch), those in which a servo asked for all.
TEST(CompareOutcome, DutyCountsAroundTouchesOnly) {
  dynamics::MotionRecord robot;
  robot.samples.resize(501);
  OutcomeRecord run = outcome({mover("ball", 0)});
  for (int i = 300; i < 400; ++i) robot.samples[i].full_duty = true;
  EXPECT_EQ(duty_while_touching(robot, run), 0) << "no touch";
  run.touching[100] = true;
  EXPECT_EQ(duty_while_touching(robot, run), 0);
  run.touching[100] = false;
  run.touching[300] = true;
  EXPECT_NEAR(duty_while_touching(robot, run), 6.0 / 11, 1e-12);
  run.touching[0] = true;
  EXPECT_NEAR(duty_while_touching(robot, run), 6.0 / 17, 1e-12) << "nothing is before the start";
}

CompareEntry entry(const std::string& level, bool servos, const OutcomeRecord& run) {
  CompareEntry e;
  e.level = level;
  e.traits.servos = servos;
  e.measures.events = {{0, false}};
  e.record.samples.resize(501);
  e.outcome = run;
  return e;
}

TEST(CompareOutcome, EntersTheVerdict) {
  OutcomeRecord run = outcome({mover("ball", 0.6)});
  run.others[0].touched = 1;
  run.touching[100] = true;
  CompareEntry reference = entry("articulated_dynamics", true, run), simple = entry("full_dynamics", false, run);
  EXPECT_TRUE(judge(simple, reference, {}).adequate);
  simple.outcome.others[0].touched.reset();
  EXPECT_EQ(judge(simple, reference, {}).reasons.at(0), "does not touch ball, the reference does");
  simple.outcome = run;
  for (int i = 95; i < 98; ++i) reference.record.samples[i].full_duty = true;
  reference.record.full_duty = 0.25;
  EXPECT_TRUE(judge(simple, reference, {}).adequate) << "the ball does not feel it";
  EXPECT_EQ(judge(simple, reference, {}).diagnostics.at(0),
            "has no servos; the reference's give all they have in 27 % of the time around its touches of ball (25 % of "
            "all time)");
  Thresholds patient;
  patient.set("contact_duty=30");
  EXPECT_TRUE(judge(simple, reference, patient).diagnostics.empty());
  simple.traits.servos = true;
  EXPECT_TRUE(judge(simple, reference, {}).diagnostics.empty()) << "it has servos itself";
  reference.measures.falls = 1;
  reference.measures.events.push_back({2, true});
  simple.measures = reference.measures;
  EXPECT_TRUE(judge(simple, reference, {}).adequate);
  simple.outcome.others[0].touched.reset();
  EXPECT_FALSE(judge(simple, reference, {}).adequate) << "touches count after a fall, too";
}

// The observer sees what the entity itself tells, and changes nothing.
TEST(OutcomeRecorder, SeesTheBallAndWhatTouchesIt) {
  const std::string file = fixtures::write_scene(R"(
air.density = 0
[ball]
position = [0.6, 0, 0.3]
velocity = [-2, 0, 0]
[defaults]
model = "kid21"
level = "simplified_dynamics"
controller = "none"
[[robots]]
name = "robot"
[[robots]]
name = "far"
position = [2, 1]
)");
  scene::Scene scene(file), unobserved(file);
  Simulation& simulation = scene.simulation();
  const Entity& robot = simulation.world().entity("robot");
  Entity& ball = simulation.world().entity("ball");
  const auto& recorder =
      simulation.attach<OutcomeRecorder>("outcome", 1000, robot,
                                         std::vector<Entity*>{&ball, &simulation.world().entity("far")}, 2.0);
  simulation.run(from_seconds(1));
  unobserved.simulation().run(from_seconds(1));
  EXPECT_EQ(simulation.state_hash(), unobserved.simulation().state_hash());
  const OutcomeRecord& record = recorder.record();
  ASSERT_EQ(record.others.size(), 2u);
  const OtherRecord &seen = record.others[0], &other = record.others[1];
  ASSERT_EQ(seen.samples.size(), 101u);
  EXPECT_NEAR(seen.samples[1].time, 0.01, 1e-12);
  EXPECT_NEAR(seen.samples[1].place.x, 0.58, 1e-9);
  EXPECT_NEAR(seen.samples[1].speed, std::hypot(2.0, 9.81 * 0.01), 1e-3);
  EXPECT_EQ(norm(seen.samples.back().place - ball.base().get(properties::position)), 0);
  ASSERT_TRUE(seen.touched.has_value());
  EXPECT_GT(*seen.touched, 0.1);
  EXPECT_LT(*seen.touched, 0.4);
  EXPECT_FALSE(other.touched.has_value());
  EXPECT_TRUE(other.can_fall);
  EXPECT_FALSE(seen.can_fall);
  const auto first = std::find(record.touching.begin(), record.touching.end(), true) - record.touching.begin();
  EXPECT_NEAR(0.01 * static_cast<double>(first), *seen.touched, 0.0101);
}

}  // namespace
}  // namespace murosimf::studies
