// Boxes, spheres, ramps and steps of a scene file: what they are, what they do, and every error in one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/written_scene.h"

namespace murosimf::scene_file {
namespace {

std::string body_scene(const std::string& text) { return fixtures::write_scene("[field]\ngoals = false\n" + text); }

std::string body_mistake(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    scene::Scene scene(body_scene(text), {.overrides = overrides});
    scene.simulation().initialize();
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string one_body(const std::string& keys) { return "[[bodies]]\nname = \"b\"\n" + keys; }

constexpr double incline = 20 * pi / 180;

/// A cube on an incline of 20 degrees.
std::string cube_on_incline(double friction) {
  return fmt::format(R"([[bodies]]
name = "ramp"
shape = "box"
size = [1.6, 1.0, 0.1]
pitch_deg = -20
static = true
material = "wood"
[[bodies]]
name = "cube"
shape = "box"
size = [0.1, 0.1, 0.1]
mass = 0.5
pitch_deg = -20
position = [0.4357, 0.0, 0.5215]
material = "plastic"
[[materials]]
pair = ["plastic", "wood"]
friction = {}
)",
                     friction);
}

/// [m] down the slope within 0.6 s, after 0.2 s in which the contact sinks in.
struct Slide {
  double early, late;
};
Slide slide(const std::string& scene_text, const std::vector<std::string>& overrides = {}) {
  scene::Scene scene(body_scene(scene_text), {.overrides = overrides});
  const auto place = [&] {
    const Vec3d r = scene.simulation().world().entity("cube").base().get(properties::position);
    return -(std::cos(incline) * r.x + std::sin(incline) * r.z);
  };
  scene.simulation().initialize();
  scene.simulation().run(std::chrono::milliseconds(200));
  const double start = place();
  scene.simulation().run(std::chrono::milliseconds(200));
  const double middle = place();
  scene.simulation().run(std::chrono::milliseconds(200));
  return {middle - start, place() - middle};
}

// g (sin a - mu cos a): the law of Coulomb. Positions are compared, so what is not exact is the sinking in before.
TEST(SceneBodies, SlideDownAnInclineAsCoulombSays) {
  for (const double friction : {0.0, 0.1, 0.25}) {
    const Slide way = slide(cube_on_incline(friction));
    const double acceleration = (way.late - way.early) / (0.2 * 0.2);
    EXPECT_NEAR(acceleration, 9.81 * (std::sin(incline) - friction * std::cos(incline)), 0.01) << friction;
  }
}

TEST(SceneBodies, StayOnAnInclineIfFrictionIsAboveItsTangent) {
  const Slide way = slide(cube_on_incline(1.1 * std::tan(incline)));
  EXPECT_NEAR(way.early + way.late, 0, 1e-5);
}

TEST(SceneBodies, SlideAlikeWhateverTheirMass) {
  const Slide light = slide(cube_on_incline(0.1)), heavy = slide(cube_on_incline(0.1), {"cube.mass=5"});
  EXPECT_NEAR(light.late, heavy.late, 1e-3);
}

TEST(SceneBodies, HaveMassAndInertiaOfTheirShape) {
  scene::Scene scene(body_scene(one_body("shape = \"cylinder\"\nradius = 0.1\nlength = 0.4\ndensity = 500\n")));
  const Model& model = scene.simulation().world().entity("b").model();
  const double mass = 500 * pi * 0.1 * 0.1 * 0.4;
  EXPECT_NEAR(*model.find(properties::mass, 0), mass, 1e-9);
  EXPECT_NEAR(model.find(properties::inertia, 0)->zz, 0.5 * mass * 0.01, 1e-9);
}

TEST(SceneBodies, StartWhereAndAsFastAsTheySay) {
  scene::Scene scene(
      body_scene(one_body("shape = \"capsule\"\nradius = 0.05\nlength = 0.3\nmass = 1\nroll_deg = 90\n"
                          "position = [1, 2, 0.5]\nvelocity = [1, 0, 2]\nangular_velocity = [0, 0, 3]\n")));
  scene.simulation().initialize();
  const auto base = scene.simulation().world().entity("b").base();
  EXPECT_NEAR(base.get(properties::position).z, 0.55, 1e-12) << "lying, its lowest point at 0.5 m";
  EXPECT_EQ(base.get(properties::linear_velocity).z, 2);
  scene.simulation().run(std::chrono::milliseconds(100));
  EXPECT_NEAR(base.get(properties::position).x, 1.1, 1e-6);
  EXPECT_NEAR(base.get(properties::angular_velocity).z, 3, 1e-9);
}

TEST(SceneBodies, CanBeModelsAndAreInTheReport) {
  scene::Scene scene(body_scene("[[bodies]]\nname = \"pole\"\nmodel = \"obstacle_pole\"\nposition = [0.5, 0]\n"));
  scene.simulation().run(std::chrono::milliseconds(10));
  const scene::RunReport report = make_report(scene);
  ASSERT_EQ(report.entities.size(), 1u);
  EXPECT_EQ(report.entities[0].name, "pole");
  EXPECT_EQ(report.entities[0].level, "simplified_dynamics");
}

// With `jitter` the place varies from seed to seed, within what [start] says; without it stays.
TEST(SceneBodies, StandElsewhereForOtherSeedsIfAsked) {
  const auto place = [](const std::string& keys, std::uint64_t seed) {
    const std::string ball = one_body("shape = \"sphere\"\nradius = 0.1\nmass = 1\nposition = [1, 2]\n" + keys);
    scene::Scene scene(body_scene(ball + "[start]\njitter_position = 0.2\n"), {.seed = seed});
    scene.simulation().initialize();
    return scene.simulation().world().entity("b").base().get(properties::position) - Vec3d{1, 2, 0.1};
  };
  EXPECT_LT(norm(place("", 1)), 1e-9);
  const Vec3d one = place("jitter = true\n", 1), other = place("jitter = true\n", 2);
  EXPECT_GT(norm(one - other), 0.01);
  for (const Vec3d& away : {one, other}) {
    EXPECT_LE(std::abs(away.x), 0.2);
    EXPECT_LE(std::abs(away.y), 0.2);
    EXPECT_GT(norm(away), 1e-3);
    EXPECT_NEAR(away.z, 0, 1e-9);
  }
  EXPECT_TRUE(
      has(body_mistake(one_body("shape = \"sphere\"\nradius = 0.1\nstatic = true\njitter = true\n")), "jitter"));
}

TEST(SceneBodies, OfDynamicRobotsAreSteps) {
  const std::string scene_text = R"([[bodies]]
name = "step"
shape = "box"
size = [1, 1, 0.1]
static = true
[[robots]]
name = "r"
model = "kid21"
level = "simplified_dynamics"
position = [0, 0, 0.1]
controller = "none"
)";
  scene::Scene scene(body_scene(scene_text));
  scene.simulation().initialize();
  const auto base = scene.simulation().world().entity("r").base();
  const double before = base.get(properties::position).z;
  scene.simulation().run(std::chrono::seconds(1));
  EXPECT_NEAR(base.get(properties::position).z, before, 0.002) << "it stands on the step";
  EXPECT_TRUE(make_report(scene).warnings.empty());
  scene::Scene kinematic(body_scene(scene_text), {.overrides = {"r.level=kinematic_walking"}});
  kinematic.simulation().run(std::chrono::seconds(1));
  EXPECT_NEAR(kinematic.simulation().world().entity("r").base().get(properties::position).z, before, 0.005)
      << "it stands on the step, too";
  EXPECT_TRUE(make_report(kinematic).warnings.empty());
}

TEST(SceneBodies, ChangeByOverridesAndEvents) {
  scene::Scene scene(body_scene(one_body("shape = \"sphere\"\nradius = 0.1\nmass = 1\n")),
                     {.overrides = {"b.mass=2", "b.b.linear_velocity=[1,0,0]"}, .events = {"0.01:b.contact=paper"}});
  scene.simulation().run(std::chrono::milliseconds(20));
  Entity& body = scene.simulation().world().entity("b");
  EXPECT_EQ(*body.model().find(properties::mass, 0), 2);
  EXPECT_GT(body.base().get(properties::linear_velocity).x, 0.5);
  EXPECT_EQ(body.contact, "paper");
}

TEST(SceneBodies, RefuseWhatTheyCannotBe) {
  EXPECT_TRUE(has(body_mistake(one_body("shape = \"bx\"\n")), "unknown shape 'bx'; did you mean 'box'?"));
  EXPECT_TRUE(has(body_mistake(one_body("")), "'shape' is missing"));
  EXPECT_TRUE(has(body_mistake(one_body("shape = \"box\"\n")), "'size' is missing"));
  EXPECT_TRUE(
      has(body_mistake(one_body("shape = \"box\"\nsize = [1, 1]\nmass = 1\n")), "'size' must be three numbers"));
  EXPECT_TRUE(has(body_mistake(one_body("shape = \"box\"\nsize = [1, 1, 1]\n")), "'mass' is missing"));
  EXPECT_TRUE(has(body_mistake(one_body("shape = \"sphere\"\nradius = 1\nmass = 0\n")), "'mass' must be positive"));
  EXPECT_TRUE(has(body_mistake(one_body("shape = \"sphere\"\nradius = -1\n")), "'radius' must be above 0"));
  EXPECT_TRUE(has(body_mistake(one_body("shape = \"sphere\"\nradius = 1\nlength = 1\n")), "'length' is nothing"));
  EXPECT_TRUE(has(body_mistake(one_body("shape = \"sphere\"\nradius = 1\nmass = 1\nmaterial = \"woood\"\n")),
                  "unknown material 'woood'"));
  EXPECT_TRUE(has(body_mistake(one_body("shape = \"sphere\"\nradius = 1\nstatic = true\nmass = 1\n")),
                  "'mass' is nothing that a static body has"));
  EXPECT_TRUE(has(body_mistake(one_body("shape = \"sphere\"\nradius = 1\nmas = 1\n")), "unknown key 'mas'"));
  EXPECT_TRUE(
      has(body_mistake(one_body("shape = \"sphere\"\nradius = 1\nstatic = true\n"), {"b.b.linear_velocity=[1,0,0]"}),
          "'b' stands there for good"));
  EXPECT_TRUE(has(body_mistake("[[bodies]]\nname = \"ball\"\nshape = \"sphere\"\nradius = 1\nmass = 1\n"),
                  "two entities are called 'ball'"));
  EXPECT_TRUE(has(body_mistake(one_body("shape = \"sphere\"\nradius = 1\nmass = 1\n"), {"b.mas=2"}),
                  "unknown setting 'mas'; did you mean 'mass'?"));
}

}  // namespace
}  // namespace murosimf::scene_file
