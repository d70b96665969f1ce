// Recordings of simulated runs return the numbers of the runs; bad ones are refused in one line.
#include "murosimf/identification/contact_logs.h"

#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include "murosimf/air/air.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/law.h"
#include "tests/written_scene.h"

namespace murosimf::identification {
namespace {

constexpr double radius = 0.05, mass = 0.1;

std::string write(const std::string& name, const std::string& text) {
  const std::string file = (fixtures::temp_folder() / name).string();
  std::ofstream(file) << text;
  return file;
}

/// Lets a scene run for `seconds` and writes where an entity is, 50 times per second, as `run --log` would.
std::string record(const std::string& name, const std::string& text, const std::string& entity, double duration) {
  scene::Scene scene(fixtures::write_scene("[field]\ngoals = false\n" + text));
  Simulation& simulation = scene.simulation();
  simulation.initialize();
  if (text.find("# rolls") != std::string::npos) {
    const Vec3d v = simulation.world().entity("ball").base().get(properties::linear_velocity);
    simulation.world().entity("ball").base().set(properties::angular_velocity, (1 / radius) * cross(Vec3d{0, 0, 1}, v));
  }
  std::string table = fmt::format("time [s],{0}.x [m],{0}.y [m],{0}.z [m]\n", entity + ".position");
  for (int i = 0; i <= std::lround(50 * duration); ++i) {
    const Vec3d r = simulation.world().entity(entity).base().get(properties::position);
    table += fmt::format("{},{},{},{}\n", seconds(simulation.now()), r.x, r.y, r.z);
    simulation.run(from_seconds(0.02));
  }
  return write(name + ".csv", table);
}

std::string rolling_ball(const Vec3d& v, double rolling) {
  return fmt::format("[ball]\nvelocity = [{}, {}, 0] # rolls\n[[materials]]\npair = ['ball', 'carpet']\nrolling = {}\n",
                     v.x, v.y, rolling);
}

ContactFitOptions with_air() {
  return {.body = "ball",
          .ground = "carpet",
          .drag = air::drag_per_meter(1.2, {.radius = radius, .mass = mass, .drag = air::usual_drag})};
}

double value(const ContactFit& fit, const std::string& key) {
  const toml::table table = toml::parse(to_toml(fit));
  return table["materials"][0][key].value_or(-1.0);
}

TEST(ContactLogs, GivesBackRollingResistanceAndRestitutionOfSimulatedBalls) {
  const ContactLogs logs{.rolls = {record("roll_x", rolling_ball({1.5, 0, 0}, 0.04), "ball", 8),
                                   record("roll_xy", rolling_ball({-1, 0.8, 0}, 0.04), "ball", 3)},
                         .slides = {},
                         .drops = {record("drop",
                                          "[ball]\nposition = [0, 0, 1.2]\n[[materials]]\npair = ['ball', 'carpet']\n"
                                          "restitution = 0.7\n",
                                          "ball", 4)}};
  const ContactFit fit = fit_contact_logs(logs, with_air());
  law::expect_near({.law = "fit of two rolls of the simulator, in air: rolling resistance",
                    .level = "fit-contact",
                    .source = "that of the scene"},
                   value(fit, "rolling"), 0.04, 4e-4, "");
  law::expect_near({.law = "fit of a drop of the simulator, in air: restitution",
                    .level = "fit-contact",
                    .source = "that of the scene"},
                   value(fit, "restitution"), 0.7, 7e-3, "");
  EXPECT_EQ(value(fit, "torsional"), 0.002) << "the table's";
}

std::string sliding_box(double heading, double lean) {
  return fmt::format(
      "surface = 'grass'\nfriction_direction = [{}, {}]\n[[bodies]]\nname = 'box'\nshape = 'box'\nsize = [0.2, 0.2, "
      "0.05]\n"
      "mass = 1\nvelocity = [{}, {}, 0]\n[[materials]]\npair = ['plastic', 'grass']\nfriction = 0.35\n"
      "friction_anisotropy = 0.2\n",
      std::cos(lean), std::sin(lean), 2 * std::cos(heading), 2 * std::sin(heading));
}

TEST(ContactLogs, GivesBackFrictionAndThePileOfSimulatedSlides) {
  ContactLogs logs;
  for (const double heading : {0.2, 2.1, 4.4}) {
    logs.slides.push_back(record(fmt::format("slide_{}", heading), sliding_box(heading, 1.0), "box", 2));
  }
  const ContactFit fit = fit_contact_logs(logs, {.body = "plastic", .ground = "grass"});
  law::expect_near({.law = "fit of three slides of the simulator: friction",
                    .level = "fit-contact",
                    .source = "that of the scene"},
                   value(fit, "friction"), 0.35, 0.005, "");
  EXPECT_NEAR(value(fit, "friction_anisotropy"), 0.2, 0.02);
  ASSERT_TRUE(fit.numbers.at(0).lean);
  const Vec3d direction = fit.numbers[0].lean->direction;
  EXPECT_NEAR(std::atan2(direction.y, direction.x), 1.0, 0.1);
}

std::string ball_on_grass(double heading) {
  return fmt::format(
      "surface = 'grass'\nfriction_direction = [0, 1]\n[air]\ndensity = 0\n[ball]\nvelocity = [{}, {}, 0] # rolls\n"
      "[[materials]]\npair = ['ball', 'grass']\nrolling = 0.08\nrolling_anisotropy = 0.2\n",
      std::cos(heading), std::sin(heading));
}

TEST(ContactLogs, GivesBackThePileOfSimulatedRolls) {
  ContactLogs logs;
  for (const double heading : {0.2, 2.1, 4.4}) {
    logs.rolls.push_back(record(fmt::format("grass_roll_{}", heading), ball_on_grass(heading), "ball", 2));
  }
  const ContactFit fit = fit_contact_logs(logs, {.body = "ball", .ground = "grass"});
  EXPECT_NEAR(value(fit, "rolling"), 0.08, 0.002);
  EXPECT_NEAR(value(fit, "rolling_anisotropy"), 0.2, 0.02);
  EXPECT_EQ(value(fit, "friction_anisotropy"), 0.15) << "the table's";
  ASSERT_TRUE(fit.numbers.at(0).lean);
  EXPECT_NEAR(fit.numbers[0].lean->direction.y, 1, 0.01);
}

void expect_refused(const std::string& table, const std::string& words, bool drop = false) {
  const std::string file = write("bad.csv", table);
  const ContactLogs logs = drop ? ContactLogs{.rolls = {}, .slides = {}, .drops = {file}}
                                : ContactLogs{.rolls = {file}, .slides = {}, .drops = {}};
  try {
    (void)fit_contact_logs(logs, with_air());
    ADD_FAILURE() << "taken: " << words;
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("bad.csv"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(ContactLogs, RefusesWhatIsNoRun) {
  expect_refused("time,z\n0,1\n", "no column 'x'");
  expect_refused("time,x\n0,1\n", "no column 'z'", true);
  expect_refused("time,a.x,b.x\n0,1,2\n", "both 'x'");
  expect_refused("time,x [mm]\n0,1\n", "is in mm");
  expect_refused("time,x\n0,1\n0,2\n", "is not after");
  expect_refused("time,x\n0,1\n1,nan\n", "no finite number");
  expect_refused("time,x,y\n0,1,2\n1,2,\n", "at other times");
  expect_refused("time,x\n0,1\n1,2\n", "2 samples");
  expect_refused("time,x\n0,one\n", "bad.csv:2");
  expect_refused("time,z\n0,1\n1,0.5\n2,0\n", "does not bounce", true);
}

}  // namespace
}  // namespace murosimf::identification
