// A robot that gets up changes its level on the way: joints that servos have left behind may not throw it up when they catch up.
#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/law.h"

namespace murosimf::test {
namespace {

struct Outcome {
  int changes = 0, lying = 0;
};

/// Changes to `level` every 0.1 s of the 4 s of a get-up; how many of them lie 6 s after the beginning.
Outcome change_on_the_way(const std::string& from, const std::string& level) {
  scene::Scene scene("get_up", {.overrides = {"robot.level=" + from}});
  Simulation& simulation = scene.simulation();
  Entity& robot = simulation.world().entity("robot");
  Outcome outcome;
  for (; simulation.now() < from_seconds(4); simulation.run(from_seconds(0.1))) {
    const auto state = scene.save();
    scene.exchange_level("robot", level);
    simulation.run(from_seconds(6) - simulation.now());
    ++outcome.changes;
    if (robot.base().get(properties::position).z < 0.25) ++outcome.lying;
    scene.load(state);
  }
  return outcome;
}

TEST(GetUpHandover, SucceedsWhereverTheLevelChanges) {
  int changes = 0, lying = 0;
  for (const char* from : {"articulated_dynamics", "full_dynamics", "simplified_dynamics"}) {
    for (const char* to : {"articulated_dynamics", "full_dynamics", "simplified_dynamics"}) {
      if (std::string(from) == to) continue;
      const Outcome outcome = change_on_the_way(from, to);
      changes += outcome.changes;
      lying += outcome.lying;
      fmt::print("{} -> {}: {} of {} lie\n", from, to, outcome.lying, outcome.changes);
    }
  }
  EXPECT_EQ(changes, 240);
  law::expect_below({.law = "a robot gets up and changes its level on the way, 240 times: lies afterwards",
                     .level = "all levels with forces",
                     .source = "the key frames succeed at each level alone"},
                    lying, 1, "");
}

}  // namespace
}  // namespace murosimf::test
