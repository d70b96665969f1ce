// What rate = "auto" comes to. That these steps change little is measured by benchmarks/step_sizes.py (docs/scenes.md).
#include "murosimf/scene_file/automatic_rate.h"

#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/written_scene.h"

namespace murosimf::scene_file {
namespace {

using fixtures::error_of;
using fixtures::says;

SceneSpec scene(const std::string& text, const std::vector<std::string>& events = {}) {
  return read_scene(fixtures::write_scene("rate = \"auto\"\n" + text), {}, events, {});
}

std::string robot(const std::string& level, const std::string& more = "") {
  return "[[robots]]\nname = \"blue\"\nmodel = \"kid21\"\nlevel = \"" + level + "\"\n" + more;
}

TEST(AutomaticRate, GoesByLevelAndLaw) {
  EXPECT_EQ(scene(robot("kinematic_walking")).rate, 200);
  for (const char* level : {"simplified_dynamics", "full_dynamics", "articulated_dynamics"}) {
    EXPECT_EQ(scene(robot(level)).rate, 500) << level;
    EXPECT_EQ(scene(robot(level, "contact = \"kelvin_voigt\"\n")).rate, 1000) << level;
  }
  EXPECT_EQ(scene(robot("articulated_dynamics", "contact = \"paper\"\n")).rate, 500);
  EXPECT_EQ(scene(robot("full_dynamics", "contact = \"paper\"\n")).rate, 1000);
  EXPECT_EQ(scene(robot("articulated_dynamics", "contact = \"paper\"\ncontact_options = {bounded = false}\n")).rate,
            1000)
      << "the paper's letter is not even stable in longer steps";
}

TEST(AutomaticRate, TheMostDemandingDecides) {
  const std::string walker = robot("kinematic_walking");
  EXPECT_EQ(scene("[ball]\n" + walker).rate, 500);
  EXPECT_EQ(scene("body_contact = \"kelvin_voigt\"\n[ball]\n" + walker).rate, 1000);
  EXPECT_EQ(scene("body_contact = \"kelvin_voigt\"\n" + walker).rate, 200) << "which touches no other robot";
  const std::string box = "[[bodies]]\nname = \"box\"\nshape = \"box\"\nsize = [0.1, 0.1, 0.1]\n";
  EXPECT_EQ(scene(walker + box + "mass = 1\ncontact = \"kelvin_voigt\"\n").rate, 1000);
  EXPECT_EQ(scene(walker + box + "static = true\n").rate, 200) << "it stands still";
}

// v dt <= r / 5, down to 0.5 ms.
TEST(AutomaticRate, GoesByFastBalls) {
  const auto ball = [](double speed) {
    return scene(fmt::format("[ball]\nradius = 0.05\nvelocity = [0, 0, -{}]\n", speed));
  };
  EXPECT_EQ(ball(4.9).rate, 500);
  EXPECT_EQ(ball(9).rate, 1000);
  EXPECT_EQ(ball(15).rate, 2000);
  EXPECT_EQ(ball(15).rate_because, "ball at 15 m/s");
  EXPECT_EQ(ball(300).rate, 2000);
  EXPECT_EQ(scene("[[bodies]]\nname = 'b'\nshape = 'sphere'\nradius = 0.01\nmass = 0.1\nvelocity = [2, 0, 0]\n").rate,
            1000);
}

// dt^2 k / m_p <= 0.02, m_p half of the mass: 1 kg and 10 kN/m at 1 ms, 10 g at 0.1 ms. Where a law is implicit any step will do.
TEST(AutomaticRate, GoesByAStiffnessThatExplicitLawsBear) {
  const auto box = [](double mass, const std::string& contact) {
    return scene(
        fmt::format("[[bodies]]\nname = 'b'\nshape = 'box'\nsize = [0.1, 0.1, 0.1]\nmass = {}\ncontact = '{}'\n"
                    "[[materials]]\npair = ['plastic', 'carpet']\nstiffness = 1e4\n",
                    mass, contact));
  };
  EXPECT_EQ(box(1.01, "kelvin_voigt").rate, 1000);
  EXPECT_EQ(box(0.0101, "kelvin_voigt").rate, 10000);
  EXPECT_EQ(box(0.0101, "kelvin_voigt").rate_because, "b on stiff ground under kelvin_voigt");
  EXPECT_EQ(box(0.0101, "implicit_stick").rate, 500);
  EXPECT_NEAR(longest_stiff_step(box(1, "kelvin_voigt"), "kelvin_voigt", "plastic", 1), 1e-3, 1e-12);
  EXPECT_EQ(longest_stiff_step(scene(""), "kelvin_voigt", "plastic", 1), std::numeric_limits<double>::infinity());
}

TEST(AutomaticRate, KnowsWhatEventsBring) {
  EXPECT_EQ(scene(robot("kinematic_walking"), {"2:blue.level=full_dynamics"}).rate, 500);
  EXPECT_EQ(scene(robot("articulated_dynamics"), {"2:blue.contact=kelvin_voigt"}).rate, 1000);
  EXPECT_EQ(scene(robot("kinematic_walking"), {"2:blue.contact=kelvin_voigt"}).rate, 200) << "which it does not feel";
}

TEST(AutomaticRate, SaysWhoDecides) {
  EXPECT_EQ(scene("[ball]\n" + robot("articulated_dynamics", "contact = \"kelvin_voigt\"\n")).rate_because,
            "blue at articulated_dynamics under kelvin_voigt");
  EXPECT_EQ(scene("[ball]\n").rate_because, "ball under implicit_stick");
  EXPECT_EQ(scene("").rate_because, "nothing moves");
}

TEST(AutomaticRate, OtherWordsAreRefused) {
  const auto read = [](const std::string& rate) {
    return error_of([&] { (void)read_scene(fixtures::write_scene("rate = " + rate + "\n"), {}, {}, {}); });
  };
  EXPECT_TRUE(says(read("\"fast\""), {"rate", "a number of Hz, or \"auto\""}));
  EXPECT_TRUE(says(read("true"), {"rate", "a number of Hz, or \"auto\""}));
  EXPECT_TRUE(says(read("-5"), {"rate"}));
}

}  // namespace
}  // namespace murosimf::scene_file
