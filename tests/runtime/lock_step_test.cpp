// Another thread says how far a simulation may go.
#include "murosimf/runtime/lock_step.h"

#include <thread>

#include <gtest/gtest.h>

#include "murosimf/runtime/simulation.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

constexpr Property<double> counter{{"counter", "1", "-", "calls so far", Scope::base}};

class Count final : public Algorithm {
 public:
  explicit Count(Setup& setup) : counter_(setup.write(counter)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { counter_ = 0; }
  void step(const Instant&) noexcept override { counter_ += 1; }

 private:
  double& counter_;
};

struct Stepped {
  explicit Stepped(Duration duration, double rate_hz = 1000)
      : dot(simulation.world().add("dot", std::make_shared<const Model>("dot", Chain{}.base("base")))) {
    simulation.attach<Count>("count", dot, rate_hz);
    thread = std::thread([this, duration] {
      simulation.run(duration, pacer);
      pacer.finish();
    });
  }
  ~Stepped() {
    pacer.finish();
    thread.join();
  }
  Simulation simulation;
  Entity& dot;
  LockStep pacer;
  std::thread thread;
};

TEST(LockStep, GoesExactlyAsFarAsAllowed) {
  Stepped stepped(1s);
  for (int i = 1; i <= 20; ++i) {
    ASSERT_TRUE(stepped.pacer.advance(7ms));
    EXPECT_EQ(stepped.simulation.now(), Duration(i * 7ms));
    EXPECT_EQ(stepped.dot.base().get(counter), 7 * i);
  }
}

TEST(LockStep, StandsStillBetweenTwoCalls) {
  Stepped stepped(1s);
  ASSERT_TRUE(stepped.pacer.advance(3ms));
  std::this_thread::sleep_for(30ms);  // nothing may happen, however long it is
  EXPECT_EQ(stepped.simulation.now(), Duration(3ms));
}

TEST(LockStep, EndsWithTheFirstStepThatIsThere) {
  Stepped stepped(1s, 250);
  ASSERT_TRUE(stepped.pacer.advance(5ms));
  EXPECT_EQ(stepped.simulation.now(), Duration(8ms));
  ASSERT_TRUE(stepped.pacer.advance(5ms));
  EXPECT_EQ(stepped.simulation.now(), Duration(16ms));
}

TEST(LockStep, SaysThatTheRunHasEnded) {
  Stepped stepped(10ms);
  EXPECT_TRUE(stepped.pacer.advance(10ms));
  EXPECT_FALSE(stepped.pacer.advance(1ms));
  EXPECT_EQ(stepped.simulation.now(), Duration(10ms));
}

TEST(LockStep, FinishLetsTheRunGoOnAlone) {
  Stepped stepped(50ms);
  EXPECT_TRUE(stepped.pacer.advance(2ms));
  stepped.pacer.finish();
  stepped.thread.join();
  stepped.thread = std::thread([] {});
  EXPECT_EQ(stepped.simulation.now(), Duration(50ms));
}

TEST(LockStep, ARequestToStopEndsTheWaiting) {
  LockStep pacer;
  Simulation simulation;
  Entity& dot = simulation.world().add("dot", std::make_shared<const Model>("dot", Chain{}.base("base")));
  simulation.attach<Count>("count", dot, 1000);
  int asked = 0;
  simulation.stop_if([&] { return ++asked > 3; });
  simulation.run(1s, pacer);  // without permission
  EXPECT_EQ(simulation.now(), Duration{});
}

}  // namespace
}  // namespace murosimf
