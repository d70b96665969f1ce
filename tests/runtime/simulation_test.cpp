// The scheduler with small algorithms: rates, order, checks at the first step, statistics.
#include "murosimf/runtime/simulation.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/runtime/path_recorder.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

constexpr Property<double> counter{{"counter", "1", "-", "calls so far", Scope::base}};

class Count final : public Algorithm {
 public:
  explicit Count(Setup& setup) : counter_(setup.write(counter)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { counter_ = 0; }
  void step(const Instant& instant) noexcept override {
    counter_ += 1;
    last = instant;
  }
  Instant last;

 private:
  double& counter_;
};

class Look final : public Algorithm {
 public:
  explicit Look(Setup& setup) : counter_(setup.read(counter)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void step(const Instant&) noexcept override { seen.push_back(counter_); }
  std::vector<double> seen;

 private:
  const double& counter_;
};

ModelPtr dot() { return std::make_shared<const Model>("dot", Chain{}.base("base")); }

TEST(Simulation, ExecutesEveryAlgorithmAtItsRate) {
  Simulation simulation;
  Entity& a = simulation.world().add("a", dot());
  Entity& b = simulation.world().add("b", dot());
  auto& fast = simulation.attach<Count>("count", a, 1000);
  auto& slow = simulation.attach<Count>("count", b, 40);
  simulation.run(100ms);
  EXPECT_EQ(a.base().get(counter), 100);
  EXPECT_EQ(b.base().get(counter), 4);
  EXPECT_EQ(simulation.now(), Duration(100ms));
  EXPECT_EQ(fast.last.now, Duration(99ms));
  EXPECT_EQ(fast.last.period, Duration(1ms));
  EXPECT_EQ(slow.last.now, Duration(75ms));
  EXPECT_EQ(slow.last.period, Duration(25ms));
}

/// Writes its mark behind those of the others.
class Mark final : public Algorithm {
 public:
  Mark(Setup& setup, Phase phase, int mark) : phase_(phase), mark_(mark), counter_(setup.write(counter)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return phase_; }
  void initialize() override { counter_ = 0; }
  void step(const Instant&) noexcept override { counter_ = 10 * counter_ + mark_; }

 private:
  Phase phase_;
  int mark_;
  double& counter_;
};

TEST(Simulation, ConflictsRunByPhaseThenInTheOrderOfAttaching) {
  Simulation simulation;
  Entity& a = simulation.world().add("a", dot());
  const auto attach = [&](Phase phase, int mark) {
    simulation.attach<Mark>(fmt::format("mark{}", mark), a, 1000, phase, mark);
  };
  attach(Phase::observe, 9);
  attach(Phase::interaction, 7);
  attach(Phase::contact, 5);
  attach(Phase::sense, 2);
  attach(Phase::motion, 8);
  attach(Phase::control, 4);
  attach(Phase::survey, 1);
  attach(Phase::sense, 3);
  attach(Phase::contact, 6);
  simulation.step();
  EXPECT_EQ(a.base().get(counter), 123456789);
  const auto order = simulation.order_of_tick();
  ASSERT_EQ(order.size(), 9U);
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(order[i].wave, i) << "all write one number";
    EXPECT_EQ(order[i].name, fmt::format("mark{}", i + 1));
  }
  EXPECT_EQ(order[5].phase, Phase::contact);
  EXPECT_EQ(order[5].entity, "a");
  EXPECT_EQ(order[5].rate_hz, 1000);
}

TEST(Simulation, ConflictsRunInTheOrderOfAttaching) {
  for (const int threads : {1, 2}) {
    Simulation simulation(threads);
    Entity& a = simulation.world().add("a", dot());
    auto& before = simulation.attach<Look>("before", a, 1000);
    simulation.attach<Count>("count", a, 1000);
    auto& after = simulation.attach<Look>("after", a, 1000);
    simulation.run(3ms);
    EXPECT_EQ(before.seen, (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(after.seen, (std::vector<double>{1, 2, 3}));
  }
}

TEST(Simulation, RefusesToStartIfAReadIsNeverWritten) {
  Simulation simulation;
  Entity& a = simulation.world().add("a", dot());
  simulation.attach<Look>("look", a, 10);
  try {
    simulation.run(1s);
    FAIL();
  } catch (const SetupError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("look"), std::string::npos) << what;
    EXPECT_NE(what.find("'counter' of 'a'"), std::string::npos) << what;
  }
}

TEST(Simulation, RefusesImpossibleRatesAndDurations) {
  Simulation simulation;
  Entity& a = simulation.world().add("a", dot());
  EXPECT_THROW(simulation.attach<Count>("count", a, 0), SetupError);
  EXPECT_THROW(simulation.attach<Count>("count", a, -5), SetupError);
  EXPECT_THROW(simulation.attach<Count>("count", a, std::nan("")), SetupError);
  EXPECT_THROW(simulation.run(-1ms), SetupError);
}

TEST(Simulation, StatisticsCountCallsByNameAndRate) {
  Simulation simulation;
  simulation.attach<Count>("count", simulation.world().add("a", dot()), 100);
  simulation.attach<Count>("count", simulation.world().add("b", dot()), 100);
  simulation.attach<Count>("count", simulation.world().add("c", dot()), 50);
  simulation.run(1s);
  const auto rows = simulation.statistics();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].calls, 200);
  EXPECT_DOUBLE_EQ(rows[0].rate_hz, 100);
  EXPECT_GT(rows[0].us_per_call, 0);
  EXPECT_EQ(rows[1].calls, 50);
}

/// Takes a while when it is called first.
class SlowAtFirst final : public Algorithm {
 public:
  explicit SlowAtFirst(Setup& setup) : counter_(setup.write(counter)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { counter_ = 0; }
  void step(const Instant&) noexcept override {
    const auto start = std::chrono::steady_clock::now();
    while (counter_ == 0 && std::chrono::steady_clock::now() - start < 32ms) {
    }
    counter_ += 1;
  }

 private:
  double& counter_;
};

// The first call is one of 32, not one of 4 that were timed: no algorithm takes more time than there was.
TEST(Simulation, StatisticsOfAShortRunCountEveryCallOnce) {
  Simulation simulation;
  simulation.attach<SlowAtFirst>("slow", simulation.world().add("a", dot()), 1000);
  const auto start = std::chrono::steady_clock::now();
  simulation.run(32ms);
  const std::chrono::duration<double, std::micro> wall = std::chrono::steady_clock::now() - start;
  EXPECT_GE(simulation.statistics()[0].us_per_call, 1000);
  EXPECT_LE(simulation.statistics()[0].us_per_call * 32, wall.count());
  simulation.run(1000ms);
  EXPECT_GE(simulation.statistics()[0].us_per_call, 32e3 / 1032);
  EXPECT_EQ(simulation.statistics()[0].calls, 1032);
}

TEST(Simulation, RunsEndEarlyWhenAsked) {
  Simulation simulation;
  simulation.attach<Count>("count", simulation.world().add("a", dot()), 1000);
  simulation.stop_if([&] { return simulation.now() >= 30ms; });
  simulation.run(100ms);
  EXPECT_EQ(simulation.now(), Duration(30ms));
  EXPECT_TRUE(simulation.stopped());
  simulation.stop_if({});
  simulation.run(100ms);
  EXPECT_EQ(simulation.now(), Duration(130ms)) << "it can go on";
}

// Position of a body in one dimension: the time [s].
class Tell final : public Algorithm {
 public:
  explicit Tell(Setup& setup) : position_(setup.write(properties::position)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { position_[0] = {}; }
  void step(const Instant& instant) noexcept override { position_[0].x = seconds(instant.now + instant.period); }

 private:
  std::span<Vec3d> position_;
};

TEST(PathRecorder, KeepsNoMoreThanItsShareHoweverLongARunIs) {
  Simulation simulation;
  Entity& a = simulation.world().add("a", dot());
  simulation.attach<Tell>("tell", a, PathRecorder::rate_hz);
  const auto& recorder = simulation.attach<PathRecorder>("recorder", PathRecorder::rate_hz, std::vector<Entity*>{&a});
  simulation.run(200s);
  const auto& points = recorder.paths()[0].points;
  EXPECT_EQ(points.size(), 4001U) << "all of them";
  simulation.run(800s);
  EXPECT_LE(points.size(), PathRecorder::most_points);
  EXPECT_GT(points.size(), PathRecorder::most_points / 2);
  EXPECT_EQ(points[0].x, 0);
  EXPECT_GT(points.back().x, 999);
  for (std::size_t i = 2; i < points.size(); ++i) {
    ASSERT_NEAR(points[i].x - points[i - 1].x, points[2].x - points[1].x, 1e-9) << "equal periods";
  }
}

TEST(Simulation, FrozenEntitiesAreSkippedAndReportedOnce) {
  Simulation simulation;
  Entity& a = simulation.world().add("a", dot());
  simulation.attach<Count>("count", a, 1000);
  simulation.run(5ms);
  a.freeze("a test wants it");
  simulation.run(5ms);
  EXPECT_EQ(a.base().get(counter), 5);
  EXPECT_EQ(simulation.warnings(), (std::vector<std::string>{"'a' was frozen at 0.005 s: a test wants it"}));
}

TEST(Simulation, PropertiesCanBeChangedByNameWhileItRuns) {
  Simulation simulation;
  Entity& a = simulation.world().add("a", dot());
  simulation.attach<Count>("count", a, 1000);
  simulation.run(5ms);
  const std::vector<double> value{100};
  simulation.world().entity("a").object("base").set("counter", value);
  simulation.run(5ms);
  EXPECT_EQ(simulation.world().entity("a").object("base").get("counter").numbers, (std::vector<double>{105}));
}

}  // namespace
}  // namespace murosimf
