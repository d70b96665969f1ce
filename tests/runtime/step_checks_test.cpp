// Debug builds: algorithms that touch what they have not declared, or leave numbers that are none, end the program.
#include "murosimf/runtime/step_checks.h"

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/runtime/simulation.h"

#ifndef NDEBUG

namespace murosimf {
namespace {

using namespace std::chrono_literals;

constexpr Property<double> counter{{"counter", "1", "-", "calls so far", Scope::base}};
constexpr Property<double> other{{"other", "1", "-", "what another algorithm writes", Scope::base}};

/// Declares `counter`, and in its first step does what `act` says.
class Suspect final : public Algorithm {
 public:
  using Act = std::function<void(Entity&, double& counter)>;

  Suspect(Setup& setup, Act act) : entity_(setup.entity()), counter_(setup.write(counter)[0]), act_(std::move(act)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { counter_ = 0; }
  void step(const Instant&) noexcept override {
    counter_ += 1;
    if (counter_ == 1) act_(entity_, counter_);
  }

 private:
  Entity& entity_;
  double& counter_;
  Act act_;
};

class Bystander final : public Algorithm {
 public:
  explicit Bystander(Setup& setup) : other_(setup.write(other)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { other_ = 0; }
  void step(const Instant&) noexcept override {}

 private:
  double& other_;
};

void run(const Suspect::Act& act) {
  Simulation simulation;
  Entity& entity = simulation.world().add("a", std::make_shared<const Model>("dot", Chain{}.base("base")));
  simulation.attach<Suspect>("suspect", entity, 1000, act);
  simulation.attach<Bystander>("bystander", entity, 1000);
  simulation.run(2ms);
}

// Rule: in a step, a column is looked up only if it is declared; its own is.
TEST(StepChecksDeathTest, LookingUpWhatIsNotDeclared) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  run([](Entity& entity, double&) { EXPECT_NE(entity.find(counter), nullptr); });
  run([](Entity& entity, double&) { EXPECT_EQ(entity.base().get(counter), 1); });
  EXPECT_DEATH(run([](Entity& entity, double&) { (void)entity.find(other); }), "has not declared");
  EXPECT_DEATH(run([](Entity& entity, double&) { (void)entity.base().get(other); }), "has not declared");
  EXPECT_DEATH(run([](Entity& entity, double&) { entity.base().set("other", std::vector<double>{1}); }),
               "has not declared");
}

// Rule: between steps every access is allowed.
TEST(StepChecks, BetweenStepsEverybodyMayLook) {
  Simulation simulation;
  Entity& entity = simulation.world().add("a", std::make_shared<const Model>("dot", Chain{}.base("base")));
  simulation.attach<Bystander>("bystander", entity, 1000);
  simulation.at(1ms, [&] { entity.base().set(other, 3); });
  simulation.run(3ms);
  EXPECT_EQ(entity.base().get(other), 3);
}

// Rule: what changes in a wave must be declared by an algorithm of the wave, however it was reached.
TEST(StepChecksDeathTest, ChangingWhatIsNotDeclared) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto meddle = [] {
    Simulation simulation;
    Entity& entity = simulation.world().add("a", std::make_shared<const Model>("dot", Chain{}.base("base")));
    double* taken = &entity.column(other).values[0];
    simulation.attach<Suspect>("suspect", entity, 1000, [taken](Entity&, double&) { *taken = 7; });
    simulation.run(2ms);
  };
  EXPECT_DEATH(meddle(), "'other' of 'a' was changed");
}

// Rule: numbers of state that were finite stay finite, or their entity is frozen.
TEST(StepChecksDeathTest, NumbersThatAreNone) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DEATH(run([](Entity&, double& number) { number = none; }), "'counter' of 'a' is not finite");
  run([](Entity& entity, double& number) {
    number = none;
    entity.freeze("its numbers have gone bad");
  });
}

}  // namespace
}  // namespace murosimf

#endif
