// Algorithms that come and go in a running simulation.
#include <gtest/gtest.h>

#include "murosimf/model/chain.h"
#include "murosimf/runtime/simulation.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;

constexpr Property<double> counter{{"counter", "1", "-", "calls so far", Scope::base}};
constexpr Property<double> doubled{{"doubled", "1", "-", "twice the calls", Scope::base}};
constexpr Property<double> request{{"request", "1", "-", "an input", Scope::base}};

class Count final : public Algorithm {
 public:
  explicit Count(Setup& setup, double first = 0) : counter_(setup.write(counter)[0]), first_(first) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { counter_ = first_; }
  void step(const Instant&) noexcept override { counter_ += 1; }

 private:
  double& counter_;
  double first_;
};

class Twice final : public Algorithm {
 public:
  explicit Twice(Setup& setup)
      : counter_(setup.read(counter)[0]), wish_(setup.input(request, 5)[0]), doubled_(setup.write(doubled)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void initialize() override { doubled_ = -1; }
  void step(const Instant&) noexcept override { doubled_ = 2 * counter_ + 0 * wish_; }
  void state(StateArchive& archive) override { archive(memory); }
  int memory = 3;

 private:
  const double &counter_, &wish_;
  double& doubled_;
};

class CannotStart final : public Algorithm {
 public:
  explicit CannotStart(Setup& setup) : doubled_(setup.write(doubled)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { throw SetupError("no request to start"); }
  void step(const Instant&) noexcept override { doubled_ = 0; }

 private:
  double& doubled_;
};

struct LateAlgorithms : testing::Test {
  LateAlgorithms() : dot(simulation.world().add("dot", std::make_shared<const Model>("dot", Chain{}.base("base")))) {
    simulation.attach<Count>("count", dot, 1000);
  }
  Simulation simulation;
  Entity& dot;
};

TEST_F(LateAlgorithms, AreInitializedAtOnceAndStepFromTheNextStepOn) {
  simulation.run(10ms);
  simulation.attach<Twice>("twice", dot, 1000);
  EXPECT_EQ(dot.base().get(doubled), -1);
  EXPECT_EQ(dot.base().get(request), 5);
  EXPECT_EQ(dot.base().get(counter), 10) << "others do not notice";
  simulation.step();
  EXPECT_EQ(dot.base().get(doubled), 22);
}

// At 400 Hz the common tick becomes 0.5 ms, and stays so as long as the time is no whole multiple of 1 ms.
TEST_F(LateAlgorithms, MayChangeTheTick) {
  simulation.run(10ms);
  const auto& twice = simulation.attach<Twice>("twice", dot, 400);
  EXPECT_EQ(simulation.tick(), Duration(500us));
  simulation.run(2500us);
  EXPECT_EQ(simulation.now(), Duration(12500us));
  EXPECT_EQ(dot.base().get(counter), 13) << "at 10, 11 and 12 ms";
  EXPECT_EQ(dot.base().get(doubled), 22) << "at 10 ms";
  simulation.detach(twice);
  EXPECT_EQ(simulation.tick(), Duration(500us));
  simulation.run(2ms);
  EXPECT_EQ(dot.base().get(counter), 15) << "at 13 and 14 ms";
  simulation.reset();
  EXPECT_EQ(simulation.tick(), Duration(1ms));
}

TEST_F(LateAlgorithms, KeepWhatStandsInTheirInputs) {
  simulation.attach<Twice>("twice", dot, 1000);
  simulation.run(5ms);
  dot.base().set(request, 8);
  class Other final : public Algorithm {
   public:
    explicit Other(murosimf::Setup& setup) : counter_(setup.input(counter, 99)[0]), wish_(setup.input(request, 7)[0]) {}
    [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
    void step(const Instant&) noexcept override { sum = counter_ + wish_; }
    double sum = 0;

   private:
    const double &counter_, &wish_;
  };
  const Other& other = simulation.attach<Other>("other", dot, 1000);
  EXPECT_EQ(dot.base().get(counter), 5) << "written by an algorithm";
  EXPECT_EQ(dot.base().get(request), 8) << "set by a user";
  simulation.step();
  EXPECT_EQ(other.sum, 14);
}

TEST_F(LateAlgorithms, WhoIsRefusedLeavesNothingBehind) {
  simulation.run(3ms);
  const auto hash = simulation.state_hash();
  EXPECT_TRUE(says(error_of([&] { simulation.attach<CannotStart>("lazy", dot, 1000); }), {"lazy", "no request"}));
  EXPECT_TRUE(says(error_of([&] { simulation.attach<Twice>("twice", dot, 1e9); }), {"twice", "rate"}));
  EXPECT_TRUE(says(error_of([&] { simulation.attach<Twice>("twice", dot, 333.331); }), {"does not fit"}));
  EXPECT_EQ(simulation.state_hash(), hash);
  EXPECT_EQ(dot.find(doubled), nullptr);
  simulation.run(3ms);
  EXPECT_EQ(dot.base().get(counter), 6);
  EXPECT_EQ(simulation.statistics().size(), 1u);
}

TEST_F(LateAlgorithms, NobodyComesWhoReadsWhatNobodyWrites) {
  Simulation empty;
  Entity& other = empty.world().add("dot", dot.model_ptr());
  empty.run(1ms);
  EXPECT_TRUE(says(error_of([&] { empty.attach<Twice>("twice", other, 1000); }), {"twice", "counter"}));
  EXPECT_TRUE(other.columns().empty());
}

TEST_F(LateAlgorithms, AreAsNewAfterAReset) {
  simulation.run(10ms);
  auto& twice = simulation.attach<Twice>("twice", dot, 1000);
  simulation.run(10ms);
  twice.memory = 4;
  dot.base().set(request, 8);
  simulation.reset();
  EXPECT_EQ(twice.memory, 3);
  EXPECT_EQ(dot.base().get(request), 5);
  EXPECT_EQ(dot.base().get(doubled), -1);
  EXPECT_EQ(dot.base().get(counter), 0);
}

TEST_F(LateAlgorithms, WhoGoesTakesItsColumnsAlong) {
  auto& twice = simulation.attach<Twice>("twice", dot, 1000);
  simulation.run(10ms);
  const ConstColumnView view = std::as_const(dot).view("doubled");
  simulation.detach(twice);
  EXPECT_EQ(dot.find(doubled), nullptr);
  EXPECT_EQ(dot.find(request), nullptr);
  EXPECT_EQ(view(0, 0), 20) << "a view keeps what was there";
  simulation.run(5ms);
  EXPECT_EQ(dot.base().get(counter), 15);
  EXPECT_EQ(view(0, 0), 20);
  simulation.attach<Twice>("twice", dot, 1000);
  simulation.step();
  EXPECT_EQ(view(0, 0), 32) << "and shows it again";
  for (const AlgorithmStatistics& row : simulation.statistics()) {
    if (row.name == "twice") {
      EXPECT_EQ(row.calls, 11);
    }
  }
}

TEST_F(LateAlgorithms, WhomSomebodyNeedsStays) {
  Algorithm& count = simulation.attach<Count>("other_count", simulation.world().add("b", dot.model_ptr()), 1000);
  simulation.attach<Twice>("twice", simulation.world().entity("b"), 1000);
  simulation.run(4ms);
  EXPECT_TRUE(says(error_of([&] { simulation.detach(count); }), {"other_count of b", "stays", "counter"}));
  simulation.run(4ms);
  EXPECT_EQ(simulation.world().entity("b").base().get(counter), 8);
  Count stranger(*std::make_unique<murosimf::Setup>(simulation.world(), dot, *std::make_unique<AccessSet>()));
  EXPECT_TRUE(says(error_of([&] { simulation.detach(stranger); }), {"not attached"}));
}

TEST_F(LateAlgorithms, ComeInTheOrderOfPhases) {
  simulation.attach<Twice>("twice", dot, 1000);
  simulation.run(1ms);
  Entity& other = simulation.world().entity("dot");
  class Add final : public Algorithm {
   public:
    explicit Add(murosimf::Setup& setup) : counter_(setup.write(counter)[0]) {}
    [[nodiscard]] Phase phase() const noexcept override { return Phase::motion; }
    void step(const Instant&) noexcept override { counter_ += 100; }

   private:
    double& counter_;
  };
  simulation.attach<Add>("add", other, 1000);
  simulation.step();
  EXPECT_EQ(dot.base().get(doubled), 2 * 102) << "before the observers";
}

}  // namespace
}  // namespace murosimf
