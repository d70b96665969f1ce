// The link between a robot and its software, through the whole of a scene: when commands hold and signals come, repeatable by seed, from
// saved states and with any number of threads; without one everything is as it was.
#include <gtest/gtest.h>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::control_software {
namespace {

using namespace std::chrono_literals;

/// Both robots walk to the ball by examples/controllers/walk_to_ball.cpp.
scene::SceneOptions walkers(std::vector<std::string> more, int threads = 1) {
  std::vector<std::string> overrides{"left.library=" MUROSIMF_EXAMPLE_CONTROLLERS "/walk_to_ball.so",
                                     "right.library=" MUROSIMF_EXAMPLE_CONTROLLERS "/walk_to_ball.so"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return {.threads = threads, .overrides = std::move(overrides), .cameras = false};
}

const std::string to_the_ball = MUROSIMF_SOURCE_DIR "/examples/controllers/to_the_ball.toml";

std::uint64_t hash_of(std::vector<std::string> more, int threads = 1, std::optional<std::uint64_t> seed = {}) {
  scene::SceneOptions options = walkers(std::move(more), threads);
  options.seed = seed;
  scene::Scene scene(to_the_ball, options);
  scene.simulation().run(5s);
  return scene.simulation().state_hash();
}

const std::vector<std::string> unsteady{"*.link.delay=0.03", "*.link.jitter=0.04", "*.link.loss=0.2"};

/// [ms] until the first command holds.
long long holds_after(const std::vector<std::string>& link) {
  scene::Scene scene(to_the_ball, walkers(link));
  scene.simulation().initialize();
  const auto& velocity = scene.simulation().world().entity("left").base();
  const auto forward = [&] { return norm(velocity.get(properties::walk_command)); };
  for (long long ms = 0; ms < 1000; ++ms) {
    if (forward() > 0) return ms;
    scene.simulation().run(1ms);
  }
  return -1;
}

TEST(ControlLink, ThatDoesNothingChangesNothing) {
  const std::uint64_t without = hash_of({});
  EXPECT_EQ(hash_of({"*.link.delay=0"}), without);
  EXPECT_EQ(hash_of({"*.link.delay=0.05", "*.link.signals=false", "*.link.commands=false"}), without);
  EXPECT_NE(hash_of({"*.link.delay=0.05"}), without);
  EXPECT_NE(hash_of({"*.link.delay=0.05", "*.link.signals=false"}), without);
  EXPECT_NE(hash_of({"*.link.delay=0.05", "*.link.commands=false"}), without);
}

// To the millisecond, whatever the rate of the software is.
TEST(ControlLink, CommandsHoldWhenTheyArrive) {
  const long long at_once = holds_after({});
  ASSERT_GE(at_once, 0);
  EXPECT_EQ(holds_after({"*.link.delay=0.013", "*.link.signals=false"}), at_once + 13);
  EXPECT_EQ(holds_after({"*.link.delay=0.2", "*.link.signals=false"}), at_once + 200);
}

TEST(ControlLink, IsTheSameForASeedWithAnyNumberOfThreads) {
  const std::uint64_t hash = hash_of(unsteady);
  EXPECT_EQ(hash_of(unsteady, 2), hash);
  EXPECT_EQ(hash_of(unsteady, 3), hash);
  EXPECT_NE(hash_of(unsteady, 1, 99), hash);
}

TEST(ControlLink, BelongsToStateAndStart) {
  scene::Scene scene(to_the_ball, walkers(unsteady));
  scene.simulation().run(1230ms);
  const std::vector<std::byte> state = scene.save();
  scene.simulation().run(1s);
  const std::uint64_t there = scene.simulation().state_hash();
  scene::Scene other(to_the_ball, walkers(unsteady));
  other.load(state);
  other.simulation().run(1s);
  EXPECT_EQ(other.simulation().state_hash(), there);
  scene.reset();
  scene.simulation().run(2230ms);
  EXPECT_EQ(scene.simulation().state_hash(), there);
}

TEST(ControlLink, IsCountedInTheReport) {
  scene::Scene scene(to_the_ball, walkers({"left.link.delay=0.02", "left.link.loss=0.25"}));
  scene.simulation().run(20s);
  const scene::RunReport report = make_report(scene);
  const auto& link = report.control.at(0).software.link;
  ASSERT_TRUE(link);
  for (const LinkCounts& way : {link->signals, link->commands}) {
    EXPECT_NEAR(static_cast<double>(way.lost) / static_cast<double>(way.sent), 0.25, 0.06);
    EXPECT_EQ(way.overtaken, 0U);
    EXPECT_EQ(way.longest, 20ms);
  }
  EXPECT_EQ(link->signals.sent, static_cast<std::uint64_t>(report.control[0].software.calls));
  EXPECT_FALSE(report.control.at(1).software.link);
  EXPECT_TRUE(fixtures::says(to_text(report), {"link of", "left         signals", "20.0 ms"}));
  EXPECT_TRUE(fixtures::says(to_json(report), {"\"overtaken\""}));
}

TEST(ControlLink, IsRefusedIfItCannotBe) {
  const auto error = [](const std::string& key) {
    return fixtures::error_of([&] { scene::Scene(to_the_ball, walkers({key})); });
  };
  EXPECT_TRUE(fixtures::says(error("left.link.delay=-1"), {"left.link.delay=-1", "'delay' must not be negative"}));
  EXPECT_TRUE(fixtures::says(error("left.link.loss=1.5"), {"'loss' must be from 0 to 1"}));
  EXPECT_TRUE(fixtures::says(error("left.link.bandwidth=0.5"), {"must be from 1 to 1e12 bytes in a second"}));
  EXPECT_TRUE(fixtures::says(error("left.link.dealy=1"), {"dealy", "delay"}));
  EXPECT_TRUE(fixtures::says(error("left.link=5"), {"'link' must be a table"}));
  scene::Scene scene("walk", {.overrides = {"walker.link.delay=0.1"}, .cameras = false});
  const auto warnings = make_report(scene).warnings;
  EXPECT_EQ(std::ranges::count(warnings, "walker: controller 'walk' has no 'link'; it changes nothing"), 1);
}

/// Control software that is a function.
class Program final : public ControlSoftware {
 public:
  explicit Program(std::function<void(Duration)> step) : step_(std::move(step)) {}
  CallOutcome start() override { return {}; }
  CallOutcome step(Duration now) noexcept override {
    step_(now);
    return {};
  }

 private:
  std::function<void(Duration)> step_;
};

// Sent once in each cycle of 10 ms: with 15 ms on the way, two cycles later.
TEST(ControlLink, SignalsAreThoseOfTheCyclesBefore) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21());
  std::vector<std::pair<long long, long long>> seen;  // [ms] now, time
  std::uint64_t first = 0;
  rig.simulation.attach<ControllerTask>(
      "control_software", robot, 100,
      [&](auto& /*setup*/, RobotPort& port, const SayLine&) {
        const murosimf_signal* position = port.signal("joint.position");
        return std::make_unique<Program>([&, position](Duration now) {
          if (position->samples == 0) return;
          if (first == 0) first = position->samples;
          seen.emplace_back(now.count() / 1'000'000, position->time / 1'000'000);
        });
      },
      ControllerTaskOptions{.software = "program", .link = {.delay = 0.015}});
  rig.attach_dynamics(robot, {.level = "simplified_dynamics"});
  rig.simulation.run(60ms);
  EXPECT_EQ(first, 1U);
  EXPECT_EQ(seen, (std::vector<std::pair<long long, long long>>{{20, 0}, {30, 10}, {40, 20}, {50, 30}}));
}

}  // namespace
}  // namespace murosimf::control_software
