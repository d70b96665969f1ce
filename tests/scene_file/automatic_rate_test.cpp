// What rate = "auto" comes to. That these steps change little is measured by benchmarks/step_sizes.py (docs/scenes.md).
#include "murosimf/scene_file/automatic_rate.h"

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
  EXPECT_EQ(scene("body_contact = \"kelvin_voigt\"\n" + walker).rate, 200) << "which touches nobody";
  const std::string box = "[[bodies]]\nname = \"box\"\nshape = \"box\"\nsize = [0.1, 0.1, 0.1]\n";
  EXPECT_EQ(scene(walker + box + "mass = 1\ncontact = \"kelvin_voigt\"\n").rate, 1000);
  EXPECT_EQ(scene(walker + box + "static = true\n").rate, 200) << "it stands still";
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
