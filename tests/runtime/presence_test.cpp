// Entities that come into a running simulation, leave it and come back.
#include <gtest/gtest.h>

#include "murosimf/model/chain.h"
#include "murosimf/runtime/simulation.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;

constexpr Property<double> ticks{{"ticks", "1", "-", "calls so far", Scope::base}};
constexpr Property<double> total{{"total", "1", "-", "of the ticks of all", Scope::base}};
constexpr Property<double> nobodys{{"nobodys", "1", "-", "that no algorithm writes", Scope::base}};

class Tick final : public Algorithm {
 public:
  explicit Tick(Setup& setup) : ticks_(setup.write(ticks)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { ticks_ = 100; }
  void step(const Instant&) noexcept override { ticks_ += ++memory_; }
  void state(StateArchive& archive) override { archive(memory_); }

 private:
  double& ticks_;
  int memory_ = 0;
};

/// Of the whole world.
class Total final : public Algorithm {
 public:
  Total(Setup& setup, const std::vector<Entity*>& entities) : total_(setup.write(total)[0]) {
    for (Entity* entity : entities) all_.push_back({entity, setup.of(*entity).read(ticks)});
  }
  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void initialize() override { total_ = 0; }
  void entity_added(Setup& setup) override {
    if (setup.entity().name() == "unwanted") throw SetupError("nobody wants it");
    all_.push_back({&setup.entity(), setup.read(ticks)});
  }
  void entity_taken_back(const Entity& entity) noexcept override {
    if (all_.back().first == &entity) all_.pop_back();
  }
  void entity_entered(const Entity& entity) override { entered.push_back(entity.name()); }
  void step(const Instant&) noexcept override {
    total_ = 0;
    for (const auto& [entity, count] : all_) total_ += entity->present() ? count[0] : 0;
  }
  std::vector<std::string> entered;

 private:
  std::vector<std::pair<const Entity*, std::span<const double>>> all_;
  double& total_;
};

class Reads final : public Algorithm {
 public:
  explicit Reads(Setup& setup) { (void)setup.read(nobodys); }
  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void step(const Instant&) noexcept override {}
};

class CannotStart final : public Algorithm {
 public:
  explicit CannotStart(Setup& setup) : ticks_(setup.write(ticks)[0]) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override { throw SetupError("no request to start"); }
  void step(const Instant&) noexcept override { ticks_ = 0; }

 private:
  double& ticks_;
};

ModelPtr dot() { return std::make_shared<const Model>("dot", Chain{}.base("base")); }

struct Presence : testing::Test {
  Presence() : one(add("one")), two(add("two")) {
    all = &simulation.attach<Total>("total", 1000, std::vector<Entity*>{&one, &two});
  }
  Entity& add(const std::string& name) {
    return simulation.add(name, dot(), {}, [&](Entity& entity) { simulation.attach<Tick>("tick", entity, 1000); });
  }
  double sum() { return simulation.world().common().find(total)->values[0]; }
  static double ticks_of(Entity& entity) { return entity.base().get(ticks); }

  Simulation simulation;
  Entity &one, &two;
  Total* all = nullptr;
};

TEST_F(Presence, WhoHasLeftStandsStill) {
  simulation.run(3ms);
  EXPECT_EQ(ticks_of(one), 106);
  EXPECT_EQ(sum(), 212);
  const ColumnView view = one.view("ticks");
  simulation.leave(one);
  EXPECT_TRUE(one.idle());
  simulation.run(2ms);
  EXPECT_EQ(ticks_of(one), 106);
  EXPECT_EQ(ticks_of(two), 115);
  EXPECT_EQ(sum(), 115);
  EXPECT_EQ(view(0, 0), 106) << "what looks at it stays valid";
  EXPECT_EQ(simulation.world().find("one"), &one);
  EXPECT_EQ(simulation.world().index_of(&one), 0);
  EXPECT_EQ(simulation.events().back().text, "one: left");
}

TEST_F(Presence, WhoComesBackBeginsAnew) {
  simulation.run(3ms);
  simulation.leave(one);
  simulation.run(1ms);
  double in_between = 0;
  simulation.enter(one, [&](Entity& entity) { in_between = entity.present() ? -1 : 1; });
  EXPECT_EQ(in_between, 1) << "is prepared before it is there";
  EXPECT_EQ(ticks_of(one), 100);
  EXPECT_EQ(all->entered, std::vector<std::string>{"one"});
  simulation.run(2ms);
  EXPECT_EQ(ticks_of(one), 103) << "its memory is that of the start, too";
  EXPECT_EQ(simulation.events().back().text, "one: entered");
}

TEST_F(Presence, IsRefusedToWhomItChangesNothing) {
  simulation.run(1ms);
  EXPECT_TRUE(says(error_of([&] { simulation.enter(one); }), {"one", "there already"}));
  simulation.leave(one);
  EXPECT_TRUE(says(error_of([&] { simulation.leave(one); }), {"one", "not there"}));
}

TEST_F(Presence, BelongsToTheState) {
  simulation.run(1ms);
  const auto bytes = simulation.save();
  const auto hash = simulation.state_hash();
  simulation.leave(one);
  EXPECT_NE(simulation.state_hash(), hash);
  const auto without = simulation.save();
  simulation.load(bytes);
  EXPECT_TRUE(one.present());
  EXPECT_EQ(simulation.state_hash(), hash);
  simulation.step();
  EXPECT_EQ(ticks_of(one), 103);
  simulation.load(without);
  EXPECT_FALSE(one.present());
  simulation.step();
  EXPECT_EQ(ticks_of(one), 101) << "and an absent entity is not executed";
}

TEST_F(Presence, OfTheStartComesBackWithAReset) {
  Entity& three = simulation.add("three", dot(), {.present = false},
                                 [&](Entity& entity) { simulation.attach<Tick>("tick", entity, 1000); });
  simulation.run(2ms);
  EXPECT_EQ(ticks_of(three), 100);
  simulation.enter(three);
  simulation.leave(one);
  simulation.run(2ms);
  EXPECT_EQ(ticks_of(three), 103);
  simulation.reset();
  EXPECT_TRUE(one.present());
  EXPECT_FALSE(three.present());
  simulation.run(2ms);
  EXPECT_EQ(ticks_of(one), 103);
  EXPECT_EQ(ticks_of(three), 100);
}

TEST_F(Presence, IsShownToReaders) {
  const auto reader = simulation.poses().subscribe();
  simulation.leave(one);
  simulation.step();
  const PoseFrame* frame = reader->latest();
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->present, (std::vector<bool>{false, true}));
}

TEST_F(Presence, OfANewOneIsKnownToAll) {
  simulation.run(3ms);
  Entity& three = add("three");
  EXPECT_EQ(ticks_of(three), 100);
  EXPECT_EQ(all->entered, std::vector<std::string>{"three"});
  simulation.run(2ms);
  EXPECT_EQ(ticks_of(three), 103);
  EXPECT_EQ(sum(), 115 + 115 + 103);
  EXPECT_EQ(simulation.world().index_of(&three), 2);
  EXPECT_EQ(simulation.events().back().text, "three: added");
  simulation.reset();
  simulation.run(2ms);
  EXPECT_EQ(sum(), 309) << "it belongs to the simulation as if it had always";
  EXPECT_EQ(ticks_of(three), 103);
}

TEST_F(Presence, OfANewOneIsNotNeededAtOnce) {
  simulation.run(1ms);
  Entity& three = simulation.add("three", dot(), {.present = false},
                                 [&](Entity& entity) { simulation.attach<Tick>("tick", entity, 1000); });
  simulation.run(1ms);
  EXPECT_EQ(ticks_of(three), 100);
  EXPECT_EQ(sum(), 206);
}

// Law: a rejected entity leaves no trace, wherever it was rejected.
TEST_F(Presence, OfSomebodyRefusedLeavesNoTrace) {
  simulation.run(3ms);
  const auto bytes = simulation.save();
  const auto tick = [&](Entity& entity) { simulation.attach<Tick>("tick", entity, 1000); };
  const auto refused = [&](const std::string& name, const std::function<void(Entity&)>& furnish) {
    return error_of([&] { (void)simulation.add(name, dot(), {}, furnish); });
  };
  EXPECT_TRUE(says(refused("one", tick), {"two entities", "one"}));
  EXPECT_TRUE(says(refused("a b", tick), {"a b"}));
  EXPECT_TRUE(says(refused("unwanted", tick), {"total of world", "nobody wants it"}));
  EXPECT_TRUE(says(refused("three", [](Entity&) { throw SetupError("no furniture"); }), {"no furniture"}));
  EXPECT_TRUE(says(refused("four", [&](Entity& e) { simulation.attach<Tick>("tick", e, 0); }), {"tick", "rate"}));
  EXPECT_TRUE(says(refused("five",
                           [&](Entity& e) {
                             tick(e);
                             simulation.attach<Reads>("reads", e, 1000);
                           }),
                   {"reads of five", "nobodys"}));
  EXPECT_TRUE(says(refused("six", [&](Entity& e) { simulation.attach<CannotStart>("idler", e, 1000); }),
                   {"idler of six", "no request to start"}));
  EXPECT_EQ(simulation.world().entities().size(), 2u);
  EXPECT_EQ(simulation.save(), bytes);
  simulation.run(1ms);
  EXPECT_EQ(sum(), 220);
  (void)add("three");
  simulation.run(1ms);
  EXPECT_EQ(sum(), 115 + 115 + 101) << "one that is welcome comes after them";
}

TEST_F(Presence, BeforeTheFirstStepNeedsNoHaste) {
  EXPECT_TRUE(says(error_of([&] {
                     (void)simulation.add("three", dot(), {}, [](Entity&) { throw SetupError("no furniture"); });
                   }),
                   {"no furniture"}));
  EXPECT_EQ(simulation.world().entities().size(), 2u);
  simulation.step();
  EXPECT_EQ(sum(), 202);
}

}  // namespace
}  // namespace murosimf
