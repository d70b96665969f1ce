// Columns of bodies that buckle on the springs of their contacts: named before the first step, and it is so at every rate.
#include "murosimf/scene_file/unsteady_stacks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <regex>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;

/// Cubes of 0.1 m, from below, every other one 2 mm off.
std::string tower(const std::vector<double>& masses, const std::string& more = "") {
  std::string text = "[field]\ngoals = false\n" + more;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    text += fmt::format(
        "[[bodies]]\nname = 'c{}'\nshape = 'box'\nsize = [0.1, 0.1, 0.1]\nmass = {}\nposition = [{}, 0, {}]\n", i,
        masses[i], 0.002 * static_cast<double>(i % 2), 0.1 * static_cast<double>(i));
  }
  return text;
}

std::vector<std::string> named(const std::string& text) {
  return scene_file::unsteady_stacks(scene_file::read_scene(fixtures::write_scene(text), {}, {}, {}));
}

bool falls(const std::vector<double>& masses, int rate) {
  Scene scene(fixtures::write_scene(tower(masses)), {.overrides = {fmt::format("rate={}", rate)}});
  scene.simulation().run(10s);
  Entity& top = scene.simulation().world().entity(fmt::format("c{}", masses.size() - 1));
  return top.base().get(properties::position).z < 0.1 * (static_cast<double>(masses.size()) - 0.5) - 0.05;
}

std::vector<double> cubes(std::size_t number) { return std::vector<double>(number, 1.0); }

// Law: least lambda of det(K - lambda G) = 0, which numpy finds to be 1.23, 0.96, 1.08, 0.87 and 1.59. What the simulation does agrees.
TEST(UnsteadyStacks, AreNamedIfTheyFallAtEveryRate) {
  for (const auto& [masses, fall] : {std::pair{cubes(11), false},
                                     {cubes(12), true},
                                     {{1, 10, 80}, false},
                                     {{1, 10, 100}, true},
                                     {{1, 100}, false}}) {
    const double mass = std::accumulate(masses.begin(), masses.end(), 0.0);
    EXPECT_EQ(named(tower(masses)).size(), fall ? 1U : 0U) << masses.size() << " of " << mass << " kg";
    for (const int rate : {1000, 200})
      EXPECT_EQ(falls(masses, rate), fall) << masses.size() << ' ' << mass << ' ' << rate;
  }
}

TEST(UnsteadyStacks, TheLineSaysWhatWouldCarryThem) {
  const std::vector<double> masses{1, 10, 100};
  const auto lines = named(tower(masses));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("c0 with 2 more on it (111 kg in all) falls at any rate"), std::string::npos) << lines[0];
  std::smatch factor;
  ASSERT_TRUE(std::regex_search(lines[0], factor, std::regex("([0-9.]+) times smaller 'static_deflection'")))
      << lines[0];
  const double deflection = 1e-4 / std::stod(factor[1]);
  const auto stiffer = [&](double by) {
    return "[[materials]]\npair = ['plastic', 'carpet']\n" + fmt::format("static_deflection = {}\n", by) +
           "[[materials]]\npair = ['plastic', 'plastic']\n" + fmt::format("static_deflection = {}\n", by);
  };
  EXPECT_TRUE(named(tower(masses, stiffer(deflection))).empty()) << lines[0];
  EXPECT_FALSE(named(tower(masses, stiffer(0.95e-4))).empty());
}

TEST(UnsteadyStacks, AScenesWarningsHaveTheLineBeforeTheFirstStep) {
  const Scene scene(fixtures::write_scene(tower(cubes(12))));
  const auto& warnings = scene.parts().diagnostics.warnings();
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const std::string& line) { return line.find("c0 with 11 more") == 0; }));
}

// Rule: what floats, lies, is thrown or stands beside something is no column.
TEST(UnsteadyStacks, OtherThingsAreNoColumns) {
  const std::string text = tower(cubes(12));
  EXPECT_TRUE(named("gravity = [0, 0, 0]\n" + text).empty());
  EXPECT_TRUE(named("body_contact = 'kelvin_voigt'\n" + text).empty());
  EXPECT_EQ(named(text + "velocity = [1, 0, 0]\n").size(), 0U) << "the topmost flies, eleven stand";
  EXPECT_TRUE(named(std::regex_replace(text, std::regex("0.1, 0.1, 0.1"), "0.3, 0.3, 0.1")).empty())
      << "broad ones stand";
}

}  // namespace
}  // namespace murosimf::scene
