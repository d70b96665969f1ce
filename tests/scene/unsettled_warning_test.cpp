// Loads that steps of 10 ms do not carry through a light body: the run says so, and at the rate that it names they are carried.
#include "murosimf/scene/unsettled_warning.h"

#include <chrono>
#include <cmath>
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

/// Cubes of 0.1 m, from below.
std::string tower(const std::vector<double>& masses) {
  std::string text = "[field]\ngoals = false\n";
  for (std::size_t i = 0; i < masses.size(); ++i) {
    text += fmt::format(
        "[[bodies]]\nname = 'c{}'\nshape = 'box'\nsize = [0.1, 0.1, 0.1]\nmass = {}\nposition = [{}, 0, {}]\n", i,
        masses[i], 0.002 * static_cast<double>(i % 2), 0.1 * static_cast<double>(i));
  }
  return text;
}

/// The warning after 4 s, and how far the topmost is from where it was put, to the side.
struct Outcome {
  std::string warning;
  double off = 0;  // [m]
};

Outcome outcome(const std::vector<double>& masses, int rate) {
  Scene scene(fixtures::write_scene(tower(masses)), {.overrides = {fmt::format("rate={}", rate)}});
  scene.simulation().run(4s);
  const World& world = scene.simulation().world();
  const Vec3d top = world.entity(fmt::format("c{}", masses.size() - 1)).base().get(properties::position);
  return {unsettled_warning(world), std::hypot(top.x, top.y)};
}

TEST(UnsettledWarning, NamesARateThatCarriesTheLoad) {
  for (const std::vector<double>& masses : {std::vector<double>{1, 100}, {1, 1, 1, 30}}) {
    const Outcome slow = outcome(masses, 100);
    std::smatch rate;
    ASSERT_TRUE(std::regex_search(slow.warning, rate, std::regex("rate = ([0-9]+) Hz"))) << slow.warning;
    EXPECT_NE(slow.warning.find("steps of 10 ms"), std::string::npos) << slow.warning;
    const Outcome mended = outcome(masses, std::stoi(rate[1]));
    EXPECT_EQ(mended.warning, "") << "at the rate of: " << slow.warning;
    EXPECT_LT(mended.off, 0.02);
  }
}

TEST(UnsettledWarning, IsNoneWhereThingsStand) {
  for (const int rate : {1000, 200, 100}) {
    const Outcome ten = outcome(std::vector<double>(10, 1.0), rate);
    EXPECT_EQ(ten.warning, "") << rate;
    EXPECT_LT(ten.off, 0.05) << rate;
  }
  EXPECT_EQ(outcome({1, 30}, 200).warning, "");
}

// Its contact is too soft, at any step: another warning says that (interpenetration_warnings.h).
TEST(UnsettledWarning, NamesNoStepWhereNoneHelps) { EXPECT_EQ(outcome({1, 1000}, 100).warning, ""); }

}  // namespace
}  // namespace murosimf::scene
