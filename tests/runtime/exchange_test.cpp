// Exchanging levels in the scheduler: place, columns, refusals, statistics; calls at given times.
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/runtime/simulation.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;

constexpr Property<double> place{{"place", "m", "world", "where it is", Scope::base}};
constexpr Property<double> effort{{"effort", "J", "-", "what that took", Scope::base}};

/// A level that moves one number; what it can refuse, and what it writes, is up to the test.
class MovingEntity : public MotionLevel {
 public:
  MovingEntity(Setup& setup, double speed, std::string refused = {})
      : place_(setup.write(place)[0]), speed_(speed), refused_(std::move(refused)) {}
  [[nodiscard]] LevelTraits traits() const override { return {}; }
  void initialize() override { place_ = 0; }
  void step(const Instant& instant) noexcept override { place_ += speed_ * seconds(instant.period); }
  [[nodiscard]] std::string refusal() const override { return refused_; }
  [[nodiscard]] Momentum hand_over() noexcept override { return {{speed_, 0, 0}, {}}; }
  void take_over(const Momentum& momentum) override { given = momentum.linear.x; }
  double given = -1;

 private:
  double& place_;
  double speed_;
  std::string refused_;
};

class Worker final : public MovingEntity {
 public:
  Worker(Setup& setup, bool fails = false) : MovingEntity(setup, 5), effort_(setup.write(effort)[0]), fails_(fails) {}
  void take_over(const Momentum&) override {
    if (fails_) throw SetupError("no work today");
    effort_ = 7;
  }

 private:
  double& effort_;
  bool fails_;
};

class Watch final : public Algorithm {
 public:
  Watch(Setup& setup, const Property<double>& what, Phase phase = Phase::observe)
      : what_(setup.read(what)[0]), phase_(phase) {}
  [[nodiscard]] Phase phase() const noexcept override { return phase_; }
  void step(const Instant&) noexcept override { seen.push_back(what_); }
  std::vector<double> seen;

 private:
  const double& what_;
  Phase phase_;
};

struct World1 {
  World1() : robot(simulation.world().add("robot", std::make_shared<const Model>("dot", Chain{}.base("base")))) {}
  Simulation simulation;
  Entity& robot;
};

TEST(Exchange, TakesTheSamePlaceInTheOrder) {
  World1 w;
  auto& before = w.simulation.attach<Watch>("before", w.robot, 1000, place, Phase::control);
  w.simulation.attach<MovingEntity>("slow", w.robot, 1000, 1.0);
  auto& after = w.simulation.attach<Watch>("after", w.robot, 1000, place);
  w.simulation.run(2ms);
  auto& fast = w.simulation.exchange<MovingEntity>("fast", w.robot, 10.0);
  w.simulation.run(2ms);
  EXPECT_EQ(fast.given, 1.0) << "momentum of the level before";
  EXPECT_EQ(w.robot.level, "fast");
  const auto near = [](const std::vector<double>& seen, const std::vector<double>& expected) {
    ASSERT_EQ(seen.size(), expected.size());
    for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_NEAR(seen[i], expected[i], 1e-15);
  };
  near(before.seen, {0, 0.001, 0.002, 0.012});
  near(after.seen, {0.001, 0.002, 0.012, 0.022});
}

TEST(Exchange, BeforeTheFirstStepJustReplaces) {
  World1 w;
  w.simulation.attach<MovingEntity>("slow", w.robot, 1000, 1.0);
  auto& fast = w.simulation.exchange<MovingEntity>("fast", w.robot, 10.0);
  w.simulation.run(1ms);
  EXPECT_EQ(fast.given, -1) << "initialized, nothing to take over";
  EXPECT_NEAR(w.robot.base().get(place), 0.01, 1e-15);
}

TEST(Exchange, RemovesColumnsThatNobodyUses) {
  World1 w;
  w.simulation.attach<MovingEntity>("slow", w.robot, 1000, 1.0);
  w.simulation.run(1ms);
  w.simulation.exchange<Worker>("worker", w.robot);
  EXPECT_EQ(w.robot.base().get(effort), 7);
  w.simulation.exchange<MovingEntity>("slow", w.robot, 1.0);
  EXPECT_EQ(w.robot.find(effort), nullptr);
  EXPECT_TRUE(says(error_of([&] { w.robot.column(effort); }), {"frozen"})) << "as before";
}

/// Looks at what only some levels write.
class Observer final : public Algorithm {
 public:
  explicit Observer(Setup& setup) : effort_(setup.observe(effort)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void step(const Instant&) noexcept override { seen.push_back(effort_[0]); }
  std::vector<double> seen;

 private:
  std::span<const double> effort_;
};

TEST(Exchange, WhatNobodyWritesAnyMoreReturnsToItsStartValue) {
  World1 w;
  auto& observer = w.simulation.attach<Observer>("observer", w.robot, 1000);
  w.simulation.attach<MovingEntity>("slow", w.robot, 1000, 1.0);
  w.simulation.run(1ms);
  w.simulation.exchange<Worker>("worker", w.robot);
  w.simulation.run(1ms);
  w.simulation.exchange<MovingEntity>("slow", w.robot, 1.0);
  w.simulation.run(1ms);
  ASSERT_EQ(observer.seen.size(), 3u);
  EXPECT_TRUE(std::isnan(observer.seen[0]));
  EXPECT_EQ(observer.seen[1], 7);
  EXPECT_TRUE(std::isnan(observer.seen[2]));
}

TEST(Exchange, ARefusalChangesNothing) {
  World1 w;
  w.simulation.attach<MovingEntity>("slow", w.robot, 1000, 1.0);
  w.simulation.run(1ms);
  const std::uint64_t hash = w.simulation.state_hash();
  EXPECT_TRUE(says(error_of([&] { w.simulation.exchange<MovingEntity>("lazy", w.robot, 2.0, "it sleeps"); }),
                   {"'robot' stays at slow", "lazy", "it sleeps"}));
  EXPECT_TRUE(says(error_of([&] { w.simulation.exchange<Worker>("worker", w.robot, true); }), {"no work today"}));
  EXPECT_EQ(w.simulation.state_hash(), hash);
  EXPECT_EQ(w.robot.find(effort), nullptr);
  EXPECT_EQ(w.robot.level, "slow");
  w.simulation.run(1ms);
  EXPECT_NEAR(w.robot.base().get(place), 0.002, 1e-15);
}

TEST(Exchange, RefusesToLeaveAReaderWithoutItsWriter) {
  World1 w;
  w.simulation.attach<Worker>("worker", w.robot, 1000);
  w.simulation.attach<Watch>("watch", w.robot, 1000, effort);
  w.simulation.run(1ms);
  EXPECT_TRUE(says(error_of([&] { w.simulation.exchange<MovingEntity>("slow", w.robot, 1.0); }),
                   {"'robot' stays at worker", "watch", "'effort'"}));
  w.simulation.run(1ms);
}

TEST(Exchange, RefusesFrozenAndMotionlessEntitiesAndTwoLevels) {
  World1 w;
  EXPECT_TRUE(
      says(error_of([&] { w.simulation.exchange<MovingEntity>("slow", w.robot, 1.0); }), {"'robot' has no level"}));
  w.simulation.attach<MovingEntity>("slow", w.robot, 1000, 1.0);
  EXPECT_TRUE(
      says(error_of([&] { w.simulation.attach<MovingEntity>("fast", w.robot, 1000, 2.0); }), {"another level"}));
  w.simulation.run(1ms);
  w.robot.freeze("it broke");
  EXPECT_TRUE(
      says(error_of([&] { w.simulation.exchange<MovingEntity>("fast", w.robot, 1.0); }), {"frozen (it broke)"}));
}

TEST(Exchange, StatisticsAndEventsKeepWhatWas) {
  World1 w;
  w.simulation.attach<MovingEntity>("slow", w.robot, 1000, 1.0);
  w.simulation.run(3ms);
  w.simulation.exchange<MovingEntity>("fast", w.robot, 10.0);
  w.simulation.run(2ms);
  const auto rows = w.simulation.statistics();
  ASSERT_EQ(rows.size(), 2u);
  for (const auto& row : rows) EXPECT_EQ(row.calls, row.name == "slow" ? 3 : 2);
  ASSERT_EQ(w.simulation.events().size(), 1u);
  EXPECT_EQ(w.simulation.events()[0].time, Duration(3ms));
  EXPECT_EQ(w.simulation.events()[0].text, "robot: slow -> fast");
}

TEST(TimedCalls, ComeInTheOrderOfTimeBetweenSteps) {
  World1 w;
  w.simulation.attach<MovingEntity>("slow", w.robot, 1000, 1.0);
  std::vector<std::pair<char, Duration>> calls;
  const auto note = [&](char name) { return [&, name] { calls.emplace_back(name, w.simulation.now()); }; };
  w.simulation.at(2ms, note('b'));
  w.simulation.at(0ms, note('a'));
  w.simulation.at(2ms, note('c'));
  w.simulation.at(2500us, note('d'));
  w.simulation.at(1ms, [&] { throw SetupError("not now"); });
  w.simulation.run(4ms);
  w.simulation.at(1ms, note('e'));  // has passed
  w.simulation.run(1ms);
  EXPECT_EQ(calls,
            (std::vector<std::pair<char, Duration>>{{'a', 0ms}, {'b', 2ms}, {'c', 2ms}, {'d', 3ms}, {'e', 4ms}}));
  ASSERT_EQ(w.simulation.warnings().size(), 1u);
  EXPECT_EQ(w.simulation.warnings()[0], "at 0.001 s: not now");
}

}  // namespace
}  // namespace murosimf
