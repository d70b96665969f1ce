// Waves: deterministic, conflict-free, no later than needed; rates that fit each other.
#include "murosimf/runtime/plan.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/setup.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

class PlanTest : public testing::Test {
 protected:
  Entity& entity(const std::string& name) {
    return world_.add(name, std::make_shared<const Model>("dot", Chain{}.base("base")));
  }
  murosimf::Setup setup(Entity& entity, AccessSet& access) { return {world_, entity, access}; }

  World world_;
};

std::vector<Wave> waves_of(const std::vector<const AccessSet*>& access) {
  std::vector<std::size_t> due(access.size());
  for (std::size_t i = 0; i < due.size(); ++i) due[i] = i;
  return make_waves(due, access);
}

TEST_F(PlanTest, DifferentEntitiesShareAWave) {
  Entity& a = entity("a");
  Entity& b = entity("b");
  AccessSet writes_a, writes_b, reads_both;
  (void)setup(a, writes_a).write(properties::position);
  (void)setup(b, writes_b).write(properties::position);
  (void)setup(a, reads_both).read(properties::position);
  (void)setup(b, reads_both).read(properties::position);
  EXPECT_EQ(waves_of({&writes_a, &writes_b, &reads_both}), (std::vector<Wave>{{0, 1}, {2}}));
}

// An island solver has levels of its entities work, and so waits for everything that they may read.
TEST_F(PlanTest, AClaimedEntityIsTouchedByNobodyElse) {
  Entity& a = entity("a");
  Entity& b = entity("b");
  AccessSet controller, engine, claims, level, other;
  (void)setup(a, controller).write(properties::walk_command);
  (void)setup(a, engine).read(properties::walk_command);
  (void)setup(a, engine).write(properties::joint_target);
  setup(a, claims).claim();
  (void)setup(a, level).read(properties::joint_target);
  (void)setup(b, other).write(properties::joint_target);
  EXPECT_EQ(waves_of({&controller, &engine, &claims, &level, &other}), (std::vector<Wave>{{0, 4}, {1}, {2}, {3}}));
}

TEST_F(PlanTest, ReadersOfTheSameColumnShareAWave) {
  Entity& a = entity("a");
  AccessSet first, second;
  (void)setup(a, first).read(properties::position);
  (void)setup(a, second).read(properties::position);
  EXPECT_EQ(waves_of({&first, &second}), (std::vector<Wave>{{0, 1}}));
}

TEST_F(PlanTest, OrderOfAttachingDecidesBetweenWriters) {
  Entity& a = entity("a");
  AccessSet writer, reader, second_writer, unrelated;
  (void)setup(a, writer).write(properties::joint_target);
  (void)setup(a, reader).read(properties::joint_target);
  (void)setup(a, second_writer).write(properties::joint_target);
  (void)setup(a, unrelated).write(properties::falls);
  EXPECT_EQ(waves_of({&writer, &reader, &second_writer, &unrelated}), (std::vector<Wave>{{0, 3}, {1}, {2}}));
  EXPECT_EQ(waves_of({&reader, &writer, &second_writer, &unrelated}), (std::vector<Wave>{{0, 3}, {1}, {2}}));
}

TEST_F(PlanTest, InputsAreOrderedLikeReads) {
  Entity& a = entity("a");
  AccessSet engine, chaser;
  (void)setup(a, chaser).write(properties::walk_command);
  (void)setup(a, engine).input(properties::walk_command, {});
  EXPECT_EQ(waves_of({&chaser, &engine}), (std::vector<Wave>{{0}, {1}}));
}

// Rule: an algorithm stands in the first wave behind every earlier one that it conflicts with. Brute force over many
// random access patterns.
TEST_F(PlanTest, EveryWaveIsFreeOfConflictsAndAsEarlyAsPossible) {
  std::vector<Entity*> entities{&entity("a"), &entity("b"), &entity("c")};
  std::uint32_t state = 1;
  const auto roll = [&](std::uint32_t n) {
    state = state * 1664525u + 1013904223u;
    return (state >> 16) % n;
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<AccessSet> access(8);
    std::vector<const AccessSet*> pointers;
    for (AccessSet& set : access) {
      for (int k = 0; k < 2; ++k) {
        murosimf::Setup s = setup(*entities[roll(3)], set);
        switch (roll(4)) {
          case 0: (void)s.write(properties::position); break;
          case 1: (void)s.read(properties::position); break;
          case 2: (void)s.write(properties::joint_target); break;
          default: (void)s.read(properties::joint_target); break;
        }
      }
      pointers.push_back(&set);
    }
    const auto waves = waves_of(pointers);
    std::vector<std::size_t> wave_of(access.size());
    for (std::size_t w = 0; w < waves.size(); ++w) {
      for (const std::size_t i : waves[w]) wave_of[i] = w;
    }
    for (std::size_t i = 0; i < access.size(); ++i) {
      std::size_t earliest = 0;
      for (std::size_t j = 0; j < i; ++j) {
        if (conflict(access[i], access[j])) earliest = std::max(earliest, wave_of[j] + 1);
      }
      EXPECT_EQ(wave_of[i], earliest);
    }
  }
}

const AccessSet nothing;

TEST_F(PlanTest, DueFollowsThePeriods) {
  const std::vector<PlannedTask> tasks{{"motion", &nothing, 1000, true},
                                       {"walk", &nothing, 100},
                                       {"sensor", &nothing, 250}};
  Plan plan(tasks);
  EXPECT_EQ(plan.tick(), 1ms);
  EXPECT_EQ(plan.due(0), (std::vector<Wave>{{0, 1, 2}}));
  EXPECT_EQ(plan.due(1), (std::vector<Wave>{{0}}));
  EXPECT_EQ(plan.due(4), (std::vector<Wave>{{0, 2}}));
  EXPECT_EQ(plan.due(10), (std::vector<Wave>{{0, 1}}));
  EXPECT_EQ(plan.due(20), (std::vector<Wave>{{0, 1, 2}}));
  EXPECT_EQ(plan.all(), plan.due(0));
}

/// Ticks in which the last one of two tasks is due.
std::vector<std::int64_t> ticks_of_last(Plan& plan, std::int64_t ticks) {
  std::vector<std::int64_t> due;
  for (std::int64_t n = 0; n < ticks; ++n) {
    for (const Wave& wave : plan.due(n)) {
      if (std::find(wave.begin(), wave.end(), 1U) != wave.end()) due.push_back(n);
    }
  }
  return due;
}

// Instant n of 30 Hz is 33.33 n ms: by hand.
TEST_F(PlanTest, WhatDoesNotDivideIsDoneInTheNearestTick) {
  const std::vector<PlannedTask> tasks{{"motion", &nothing, 1000, true}, {"camera", &nothing, 30}};
  Plan plan(tasks);
  EXPECT_EQ(plan.tick(), 1ms);
  EXPECT_EQ(ticks_of_last(plan, 201), (std::vector<std::int64_t>{0, 33, 67, 100, 133, 167, 200}));
}

TEST_F(PlanTest, ThePhaseMovesTheInstants) {
  const std::vector<PlannedTask> tasks{{"motion", &nothing, 1000, true}, {"camera", &nothing, Rate(100, 0.5)}};
  Plan plan(tasks);
  EXPECT_EQ(ticks_of_last(plan, 30), (std::vector<std::int64_t>{5, 15, 25}));
}

TEST_F(PlanTest, OnlyWhatStepsMakesTheTick) {
  const std::vector<PlannedTask> tasks{{"control", &nothing, 400}, {"motion", &nothing, 1000, true}};
  EXPECT_EQ(Plan(tasks).tick(), 1ms);
  const std::vector<PlannedTask> faster{{"control", &nothing, 2000}, {"motion", &nothing, 1000, true}};
  EXPECT_EQ(Plan(faster).tick(), 500us) << "nothing is done more than once in a tick";
  const std::vector<PlannedTask> alone{{"control", &nothing, 400}, {"sensor", &nothing, 1000}};
  EXPECT_EQ(Plan(alone).tick(), 500us);
}

TEST_F(PlanTest, RatesThatDoNotFitAreRefusedWithTheNearestThatDoes) {
  const std::vector<PlannedTask> tasks{{"motion", &nothing, 1000, true}, {"other motion", &nothing, 30, true}};
  try {
    Plan plan(tasks);
    FAIL() << "30 Hz does not fit 1 ms";
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("'other motion'"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("30.003 Hz"), std::string::npos) << error.what();
  }
}

// A faster rate than the tick so far is refused with a fast one, not with the tick.
TEST_F(PlanTest, TheNearestRateMayBeFasterThanTheTick) {
  const std::vector<PlannedTask> tasks{{"walk", &nothing, 100}, {"motion", &nothing, 333}};
  try {
    Plan plan(tasks);
    FAIL() << "333 Hz does not fit 10 ms";
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("333.333 Hz"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace murosimf
