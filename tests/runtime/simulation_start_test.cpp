// The first start and every later one: the same calls in the same order, from the same values.
#include <gtest/gtest.h>

#include "murosimf/model/chain.h"
#include "murosimf/runtime/simulation.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

constexpr Property<double> sum{{"sum", "1", "-", "of requests", Scope::base}};
constexpr Property<double> request{{"request", "1", "-", "an input", Scope::base}};

/// Adds the request and a random number in every step; remembers in a member how often.
class Add final : public Algorithm {
 public:
  explicit Add(Setup& setup) : sum_(setup.write(sum)[0]), wish_(setup.input(request, 2)[0]), random_(1, "add") {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { sum_ = 10 + wish_; }
  void step(const Instant&) noexcept override { sum_ += wish_ + random_.uniform(steps++); }
  void state(StateArchive& archive) override { archive(steps); }
  void reseed(std::uint64_t seed) override { random_.reseed(seed); }
  std::uint64_t steps = 0;

 private:
  double& sum_;
  const double& wish_;
  RandomStream random_;
};

struct Started : testing::Test {
  Started() : dot(simulation.world().add("dot", std::make_shared<const Model>("dot", Chain{}.base("base")))) {
    add = &simulation.attach<Add>("add", dot, 1000);
  }
  [[nodiscard]] double value() { return dot.base().get(sum); }
  Simulation simulation;
  Entity& dot;
  Add* add = nullptr;
};

TEST_F(Started, AResetIsTheFirstStartAgain) {
  simulation.run(5ms);
  const double after_five = value();
  simulation.reset();
  EXPECT_EQ(simulation.now(), Duration{});
  EXPECT_EQ(add->steps, 0u);
  EXPECT_EQ(value(), 12);
  EXPECT_EQ(simulation.statistics()[0].calls, 0);
  simulation.run(5ms);
  EXPECT_EQ(value(), after_five);
}

TEST_F(Started, WhatWasSetInARunIsGone) {
  simulation.run(5ms);
  dot.base().set(request, 7);
  simulation.record("a note");
  simulation.reset();
  EXPECT_EQ(dot.base().get(request), 2);
  EXPECT_TRUE(simulation.events().empty());
}

TEST_F(Started, WhatWasSetBeforeTheFirstStartIsThereAgain) {
  dot.base().set(request, 3);
  simulation.record("built");
  simulation.run(5ms);
  dot.base().set(request, 7);
  simulation.reset();
  EXPECT_EQ(dot.base().get(request), 3);
  EXPECT_EQ(value(), 13);
  ASSERT_EQ(simulation.events().size(), 1u);
}

TEST_F(Started, CallsOfTheStartComeBeforeAndAfterFirstValues) {
  std::string calls;
  simulation.before_start([&] {
    dot.base().set(request, 4);
    calls += "b";
  });
  simulation.after_start([&] {
    EXPECT_EQ(value(), 14);
    dot.base().set(sum, 100);
    calls += "a";
  });
  simulation.initialize();
  EXPECT_EQ(calls, "ba");
  EXPECT_EQ(value(), 100);
  simulation.run(3ms);
  simulation.reset();
  EXPECT_EQ(calls, "baba");
  EXPECT_EQ(value(), 100);
}

TEST_F(Started, TheScheduleBeginsAnewAndLaterCallsAreGone) {
  int scheduled = 0, later = 0;
  simulation.at(2ms, [&] { ++scheduled; });
  simulation.run(1ms);
  simulation.at(4ms, [&] { ++later; });
  simulation.run(2ms);
  EXPECT_EQ(scheduled, 1);
  simulation.reset();
  simulation.run(10ms);
  EXPECT_EQ(scheduled, 2);
  EXPECT_EQ(later, 0);
}

TEST_F(Started, ResettingWhatNeverStartedStartsIt) {
  simulation.reset();
  EXPECT_EQ(value(), 12);
}

TEST_F(Started, AnotherSeedDrawsOtherNumbers) {
  simulation.run(5ms);
  const double before = value();
  simulation.reseed(2);
  simulation.reset();
  simulation.run(5ms);
  EXPECT_NE(value(), before);
  EXPECT_NEAR(value(), before, 5) << "the same but for the random numbers";
  simulation.reseed(1);
  simulation.reset();
  simulation.run(5ms);
  EXPECT_EQ(value(), before);
}

TEST_F(Started, WhoWasFrozenMovesAgain) {
  simulation.run(1ms);
  dot.freeze("a test");
  simulation.run(2ms);
  EXPECT_EQ(simulation.warnings().size(), 1u);
  simulation.reset();
  EXPECT_TRUE(simulation.warnings().empty());
  simulation.run(2ms);
  EXPECT_EQ(add->steps, 2u);
  dot.freeze("another time");
  simulation.run(1ms);
  EXPECT_EQ(simulation.warnings().size(), 1u) << "and is reported anew";
}

}  // namespace
}  // namespace murosimf
