// Overlaps of entities with each other and with the ground when a scene begins.
#include "murosimf/scene/start_overlaps.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/fixtures.h"

namespace murosimf::scene {
namespace {

using fixtures::says;

/// Warnings of a scene with two robots and a ball at these places.
std::string said_of(const std::string& first, const std::string& second, const std::string& ball) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::string file = fmt::format("{}overlaps_{}_{}.toml", testing::TempDir(), info->name(), getpid());
  std::ofstream(file) << "[ball]\nposition = " << ball
                      << "\n[defaults]\nmodel = 'kid21'\nsensors = false\ncontroller = 'none'\n"
                         "level = 'simplified_dynamics'\n[[robots]]\nname = 'a'\nposition = "
                      << first << "\n[[robots]]\nname = 'b'\nposition = " << second << "\n";
  Scene scene(file);
  scene.simulation().initialize();
  return fmt::format("{}", fmt::join(make_report(scene).warnings, "\n"));
}

TEST(StartOverlaps, AreNamedWithBothEntities) {
  const std::string apart = "[1, 0]", far = "[-2, 1]";
  EXPECT_EQ(said_of("[0, 0]", apart, far), "");
  EXPECT_TRUE(says(said_of("[0, 0]", "[0, 0]", far), {"a and b overlap at the start"}));
  EXPECT_TRUE(says(said_of("[0, 0]", "[0.1, 0]", far), {"a and b overlap at the start"}));
  EXPECT_TRUE(says(said_of("[0, 0]", apart, "[1, 0]"), {"ball and b overlap at the start"}));
  EXPECT_TRUE(says(said_of("[0, 0, -0.1]", apart, far), {"a is in the ground by 100 mm"}));
  EXPECT_TRUE(says(said_of("[0, 0]", apart, "[-2, 1, -0.03]"), {"ball is in the ground by 30 mm"}));
  EXPECT_TRUE(says(said_of("[3, 0.7]", apart, far), {"a and field overlap at the start", "goal_right"}));
}

}  // namespace
}  // namespace murosimf::scene
