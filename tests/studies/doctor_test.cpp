// What the doctor finds: robots that end otherwise when a number changes that should not matter. And that shipped motions do not.
#include "murosimf/studies/doctor.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/studies/doctor_cases.h"
#include "tests/written_scene.h"

namespace murosimf {
namespace {

using namespace studies;

DoctorOptions of(const std::string& text, std::vector<std::string> dimensions) {
  DoctorOptions options{.scene = fixtures::write_scene(text), .dimensions = std::move(dimensions)};
  options.common.threads = 2;
  options.common.cameras = false;
  return options;
}

const std::string walker = R"(
name = "walker"
duration = 1.5
[[robots]]
name = "a"
model = "kid21"
controller = "walk"
command = [0.2, 0, 0]
)";

const EntityEnding& ending(const Checkup& checkup, const std::string& label) {
  const auto& runs = checkup.dimensions.front().runs;
  const auto run = std::ranges::find(runs, label, &DoctorRun::label);
  if (run == runs.end() || run->entities.empty()) throw SetupError("no run " + label);
  return run->entities.front();
}

std::vector<std::string> labels(const DoctorDimension& dimension) {
  std::vector<std::string> all;
  for (const DoctorRun& run : dimension.runs) all.push_back(run.label);
  return all;
}

TEST(Doctor, ChangesOneThingAtATime) {
  DoctorOptions options = of(walker + "level = \"articulated_dynamics\"\n", {});
  options.duration = 0.02;
  const Checkup all = examine(options);
  ASSERT_EQ(all.dimensions.size(), 5U);
  EXPECT_EQ(labels(all.dimensions[0]),
            (std::vector<std::string>{"as it is", "0.5 ms", "1 ms", "2 ms", "5 ms", "10 ms"}));
  EXPECT_EQ(labels(all.dimensions[2]), (std::vector<std::string>{"as it is", "none", "moon", "earth"}));
  EXPECT_EQ(labels(all.dimensions[3]), (std::vector<std::string>{"as it is", "1", "2", "3", "4", "5"}));
  EXPECT_EQ(labels(all.dimensions[4]), (std::vector<std::string>{"as it is", "-20 %", "+20 %"}));
  EXPECT_TRUE(all.flips.empty());
  EXPECT_EQ(all.duration, 0.02);
  options.quick = true;
  const Checkup quick = examine(options);
  EXPECT_EQ(labels(quick.dimensions[0]), (std::vector<std::string>{"as it is", "0.5 ms", "10 ms"}));
  EXPECT_EQ(labels(quick.dimensions[3]), (std::vector<std::string>{"as it is", "1", "2"}));
}

// The gains that are set are 0.8 and 1.2 times those of each joint.
TEST(Doctor, ScalesTheGainsOfEveryServo) {
  const DoctorOptions options = of(walker + "level = \"articulated_dynamics\"\n", {"servos"});
  const scene::Scene as_it_is(options.scene);
  const auto dimensions = doctor_cases(options, as_it_is);
  ASSERT_EQ(dimensions.size(), 1U);
  ASSERT_EQ(dimensions[0].cases.size(), 2U);
  const Model& before = as_it_is.moving_entities().front()->model();
  for (const std::size_t i : {0U, 1U}) {
    const scene::Scene changed(options.scene, {.overrides = dimensions[0].cases[i].overrides});
    const Model& after = changed.moving_entities().front()->model();
    for (const int joint : before.joints()) {
      const double factor = i == 0 ? 0.8 : 1.2;
      EXPECT_NEAR(after.find(properties::servo, joint)->position_gain,
                  factor * before.find(properties::servo, joint)->position_gain, 1e-9);
    }
  }
}

TEST(Doctor, KnowsWhoFalls) {
  DoctorOptions options = of(walker + "level = \"articulated_dynamics\"\n", {"seeds"});
  options.common.pushes = {"a.torso=[150,0,0]@0.2..0.3"};
  options.duration = 2;
  const Checkup checkup = examine(options);
  EXPECT_EQ(ending(checkup, "as it is").ending, Ending::fell) << to_text(checkup);
  EXPECT_TRUE(checkup.flips.empty()) << "with every seed";
}

// Without gravity no robot gets anywhere on foot.
TEST(Doctor, OtherWaysAreFlips) {
  DoctorOptions options = of(walker + "level = \"articulated_dynamics\"\n", {"gravity"});
  options.duration = 4;
  const Checkup checkup = examine(options);
  EXPECT_GT(ending(checkup, "earth").way, 0.5);
  EXPECT_FALSE(ending(checkup, "earth").flips);
  EXPECT_TRUE(ending(checkup, "none").flips) << to_text(checkup);
}

// A robot that lies at the start is put upright by kinematic_walking.
TEST(Doctor, KnowsWhoBeginsLying) {
  DoctorOptions options =
      of("duration = 0.5\n[[robots]]\nname = \"a\"\nmodel = \"kid21\"\ncontroller = \"none\"\nlevel = "
         "\"full_dynamics\"\npitch_deg = 90\nheading_deg = 70\n",
         {"levels"});
  const Checkup checkup = examine(options);
  EXPECT_EQ(ending(checkup, "as it is").ending, Ending::lies);
  EXPECT_EQ(ending(checkup, "kinematic_walking").ending, Ending::stands);
}

TEST(Doctor, WhatCannotBeIsRefusedInItsPlace) {
  const Checkup checkup =
      examine(of("duration = 0.1\n[[robots]]\nname = \"c\"\nmodel = \"car\"\ncontroller = "
                 "\"drive\"\nlevel = \"simplified_dynamics\"\n",
                 {"levels", "servos"}));
  const DoctorRun& kinematic = checkup.dimensions[0].runs[1];
  EXPECT_EQ(kinematic.label, "kinematic_walking");
  EXPECT_NE(kinematic.refused.find("cannot walk kinematically"), std::string::npos) << kinematic.refused;
  EXPECT_EQ(kinematic.refused.find('\n'), std::string::npos);
  EXPECT_TRUE(checkup.flips.empty());
  EXPECT_FALSE(checkup.dimensions[1].skipped.empty());
  EXPECT_NE(to_text(checkup).find("levels, kinematic_walking: refused: "), std::string::npos);
  const auto json = nlohmann::json::parse(to_json(checkup));
  EXPECT_EQ(json["schema"], "murosimf/doctor/1");
  EXPECT_EQ(json["dimensions"][0]["runs"][1]["entities"].size(), 0U);
}

TEST(Doctor, ResultsDoNotDependOnThreads) {
  DoctorOptions options = of(walker + "level = \"simplified_dynamics\"\n", {"steps", "seeds"});
  options.quick = true;
  options.common.threads = 1;
  const std::string one = to_json(examine(options));
  options.common.threads = 3;
  EXPECT_EQ(to_json(examine(options)), one);
}

TEST(Doctor, MistakesAreRefused) {
  EXPECT_THROW((void)examine(of(walker, {"sedes"})), SetupError);
  EXPECT_THROW((void)examine({.scene = "no_such_scene"}), SetupError);
}

/// Plays a shipped motion; `pitch` [deg] of the robot at the start.
Checkup of_motion(const std::string& motion, const std::string& level, int pitch) {
  return examine(
      of("duration = 4.5\n[field]\ngoals = false\n[[robots]]\nname = \"a\"\nmodel = \"kid21\"\ncontroller = "
         "\"keyframes\"\nmotion = \"" +
             motion + "\"\nlevel = \"" + level + "\"\npitch_deg = " + std::to_string(pitch) + "\n",
         {"steps", "servos"}));
}

// How a motion ends is no matter of the step or of a weaker servo.
TEST(Doctor, ShippedMotionsHaveNoFlips) {
  for (const auto& [motion, pitch] :
       {std::pair{"get_up_front", 90}, {"get_up_back", -90}, {"kick", 0}, {"arm_swing_on_one_leg", 0}}) {
    for (const char* level : {"simplified_dynamics", "full_dynamics", "articulated_dynamics"}) {
      const Checkup checkup = of_motion(motion, level, pitch);
      EXPECT_EQ(ending(checkup, "as it is").ending, Ending::stands) << motion << ", " << level;
      EXPECT_TRUE(checkup.flips.empty()) << motion << ", " << level << "\n" << to_text(checkup);
    }
  }
}

}  // namespace
}  // namespace murosimf
