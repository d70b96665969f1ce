// A servo law that was chosen while it did not matter holds when a level comes that has servos.
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/temp_folder.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;

/// [rad] where the knees and all other joints are at the end.
std::vector<double> joints_after(const std::vector<std::string>& overrides, const std::vector<std::string>& events) {
  const auto file = fixtures::temp_folder() / "servo_law_memory.toml";
  std::ofstream(file) << "duration = 1.0\n[[robots]]\nname = 'robot'\nmodel = 'kid21'\ncontroller = 'walk'\n"
                         "level = 'full_dynamics'\n";
  Scene scene(file.string(), {.overrides = overrides, .events = events});
  scene.simulation().run(350ms);
  EXPECT_EQ(scene.simulation().world().entity("robot").level, "articulated_dynamics");
  return scene.simulation().world().entity("robot").find(properties::joint_position)->values;
}

TEST(ServoLawMemory, HoldsAfterALaterChangeOfTheLevel) {
  const std::string level = "0.2:robot.level=articulated_dynamics";
  const auto chosen = joints_after({}, {"0.1:robot.servo_law=ideal_pd", level});
  EXPECT_EQ(chosen, joints_after({"robot.servo_law=ideal_pd"}, {level}));
  EXPECT_NE(chosen, joints_after({}, {level})) << "the laws differ";
}

}  // namespace
}  // namespace murosimf::scene
