// Robots, ball and bodies that leave a scene and come back, by name, by event and from other threads.
#include "murosimf/scene/scene_presence.h"

#include <gtest/gtest.h>

#include "murosimf/collision/queries.h"
#include "murosimf/collision/touches.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/sensors/ground_truth.h"
#include "tests/fixtures.h"
#include "tests/scene/scene_hashes.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;

/// Two robots that push each other, and a ball between them.
std::string duel(const std::string& level, const std::string& about_red, const std::string& more = "") {
  return fixtures::write_scene("seed = 4\n" + more + R"(
[ball]
position = [0.3, 0.02]
[[teams]]
name = "blue"
[[teams]]
name = "red"
[defaults]
model = "kid21"
controller = "walk"
command = [0.25, 0, 0]
level = ")" + level + R"("
[[robots]]
name = "blue1"
team = "blue"
position = [-0.1, 0]
)" + about_red);
}

const std::string red1 = R"(
[[robots]]
name = "red1"
team = "red"
position = [0.7, 0.05]
heading_deg = 180
)";

Vec3d place_of(Scene& scene, const std::string& name) {
  return scene.simulation().world().entity(name).base().get(properties::position);
}

double distance(Scene& one, Scene& other, const std::string& name) {
  return norm(place_of(one, name) - place_of(other, name));
}

/// Only of some entities.
std::map<std::string, std::uint64_t> hashes_of(const Scene& scene, const std::vector<std::string>& entities) {
  std::map<std::string, std::uint64_t> all = hashes_of(scene), some;
  for (const auto& [name, hash] : all) {
    const std::string entity = name.substr(0, name.find(' '));
    if (std::ranges::find(entities, entity) != entities.end()) some[name] = hash;
  }
  return some;
}

class PresenceAtLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, PresenceAtLevel,
                         testing::Values("kinematic_walking", "simplified_dynamics", "full_dynamics",
                                         "articulated_dynamics"),
                         [](const auto& test) { return test.param; });

// Law: to all others, an absent entity is as one that the scene does not have.
TEST_P(PresenceAtLevel, WhoIsNotThereChangesNothingForTheOthers) {
  Scene scene(duel(GetParam(), red1 + "present = false\n"));
  scene.simulation().run(3s);
  Scene without(duel(GetParam(), ""));
  without.simulation().run(3s);
  const std::vector<std::string> others{"blue1", "ball"};
  EXPECT_EQ(difference({hashes_of(without, others)}, {hashes_of(scene, others)}), "");
  Scene with(duel(GetParam(), red1));
  with.simulation().run(3s);
  EXPECT_NE(difference({hashes_of(with, others)}, {hashes_of(scene, others)}), "") << "it would have touched them";
}

// Law: an entity that leaves at once is as one that was never there, and one that enters at once as one that always was.
TEST_P(PresenceAtLevel, AtTheStartIsAsInTheFile) {
  Scene leaves(duel(GetParam(), red1));
  leaves.leave("red1");
  Scene absent(duel(GetParam(), red1 + "present = false\n"));
  absent.simulation().initialize();
  EXPECT_EQ(leaves.simulation().state_hash(), absent.simulation().state_hash());
  leaves.simulation().run(1s);
  absent.simulation().run(1s);
  EXPECT_EQ(leaves.simulation().state_hash(), absent.simulation().state_hash());

  Scene enters(duel(GetParam(), red1 + "present = false\n")), there(duel(GetParam(), red1));
  enters.enter("red1");
  there.simulation().initialize();
  EXPECT_EQ(difference(go_on(enters, 2s), go_on(there, 2s)), "");
}

// Law: an entity that comes back far from all others moves as at the start.
TEST_P(PresenceAtLevel, WhoComesBackMovesAsAtTheStart) {
  const std::string far = R"(
[[robots]]
name = "red1"
team = "red"
position = [0, 1.5]
controller = "none"
roll_deg = 15
)";
  const std::string file = duel(GetParam(), GetParam() == "kinematic_walking" ? red1 : far);
  Scene scene(file), fresh(file);
  scene.simulation().run(730ms);
  scene.leave("red1");
  scene.leave("blue1");
  scene.leave("ball");
  scene.simulation().run(100ms);
  scene.enter("red1");
  fresh.simulation().initialize();
  fresh.leave("blue1");
  fresh.leave("ball");
  EXPECT_EQ(distance(scene, fresh, "red1"), 0);
  for (int i = 0; i < 5; ++i) {
    scene.simulation().run(200ms);
    fresh.simulation().run(200ms);
    EXPECT_EQ(distance(scene, fresh, "red1"), 0) << i;
  }
}

TEST_P(PresenceAtLevel, BelongsToTheState) {
  const std::string file = duel(GetParam(), red1);
  Scene scene(file), other(file);
  scene.simulation().run(1s);
  scene.leave("red1");
  scene.simulation().run(50ms);
  const auto bytes = scene.save();
  const auto expected = go_on(scene, 500ms);
  other.load(bytes);
  EXPECT_EQ(difference(go_on(other, 500ms), expected), "");
  other.enter("red1");
  other.simulation().run(100ms);
  const auto entered = other.save();
  const auto after = go_on(other, 500ms);
  scene.load(entered);
  EXPECT_EQ(difference(go_on(scene, 500ms), after), "");
}

// The level may change meanwhile; it begins when its robot does.
TEST_P(PresenceAtLevel, LevelsChangeMeanwhile) {
  Scene scene(duel("simplified_dynamics", red1 + "present = false\n"));
  scene.simulation().run(200ms);
  scene.exchange_level("red1", GetParam());
  scene.simulation().run(10ms);
  scene.enter("red1");
  Scene fresh(duel("simplified_dynamics", red1 + "level = '" + GetParam() + "'\n"));
  fresh.simulation().initialize();
  for (Scene* one : {&scene, &fresh}) {
    one->leave("blue1");
    one->leave("ball");
  }
  EXPECT_EQ(difference({hashes_of(fresh, {"red1"})}, {hashes_of(scene, {"red1"})}), "");
  for (Scene* one : {&scene, &fresh}) one->simulation().run(2s);
  EXPECT_EQ(distance(scene, fresh, "red1"), 0);
  EXPECT_LT(place_of(scene, "red1").x, 0.6) << "it walks";
}

TEST(ScenePresence, OfABallThatComesBack) {
  Scene scene(fixtures::write_scene("[air]\ndensity = 0\n[ball]\nposition = [0, 0, 0.3]\nvelocity = [1, 0, 0]\n"));
  scene.simulation().run(200ms);
  const Vec3d place = place_of(scene, "ball");
  EXPECT_NEAR(place.x, 0.2, 1e-6);
  scene.leave("ball");
  scene.simulation().run(1s);
  EXPECT_EQ(norm(place_of(scene, "ball") - place), 0) << "stays where it was";
  scene.enter("ball");
  EXPECT_EQ(place_of(scene, "ball").x, 0);
  scene.simulation().run(200ms);
  EXPECT_EQ(norm(place_of(scene, "ball") - place), 0) << "and comes as it came";
}

// A body that leaves the middle of a heap takes its contacts along.
TEST(ScenePresence, NobodyTouchesWhoHasLeft) {
  Scene scene(duel("full_dynamics", red1));
  const World& world = scene.simulation().world();
  const auto touched = [&](const std::string& name, const std::string& by) {
    const auto touches = collision::touches(world, world.entity(name));
    return std::ranges::any_of(touches, [&](const auto& t) { return t.other && t.other->name() == by; });
  };
  for (int i = 0; i < 5000 && !touched("blue1", "red1"); ++i) scene.simulation().step();
  ASSERT_TRUE(touched("blue1", "red1"));
  scene.leave("red1");
  scene.simulation().step();
  EXPECT_FALSE(touched("blue1", "red1"));
  EXPECT_FALSE(touched("red1", "field"));
  const auto reader = scene.simulation().poses().subscribe({.contacts = true});
  scene.simulation().step();
  for (const ContactMark& mark : reader->latest()->contacts) EXPECT_LT(mark.point.x, 0.45);
  scene.simulation().run(2s);
  EXPECT_GT(place_of(scene, "blue1").x, place_of(scene, "red1").x) << "walks through where it stood";
  EXPECT_TRUE(scene.simulation().warnings().empty());
}

TEST(ScenePresence, SensorsSeeNothingOfIt) {
  Scene scene(duel("kinematic_walking", red1 + R"(
[[robots]]
name = "eye"
controller = "none"
position = [0, -0.8]
heading_deg = 90
[robots.sensors.truth]
type = "ground_truth"
[robots.sensors.detect]
type = "detector"
range_min = 0.05
[robots.sensors.around]
type = "laser"
position = [0, 0, 0.1]
rays = 31
)"));
  const Entity& eye = scene.simulation().world().entity("eye");
  const auto numbers = [&](const char* sensor, const std::string& output) {
    const sensors::Reading& reading = *sensors::find_reading(eye, sensor);
    std::size_t first = 0;
    for (const sensors::Output& one : reading.info->outputs) {
      if (one.name == output) return reading.values[first];
      first += one.size();
    }
    ADD_FAILURE() << output;
    return 0.0;
  };
  const auto seen = [&] {
    scene.simulation().step();
    return std::isfinite(numbers("truth", "red1_position")) && std::isfinite(numbers("detect", "red1"));
  };
  collision::QueryScene queries(scene.simulation().world());
  const auto on_the_ray = [&] {
    queries.refresh();
    const Vec3d r = place_of(scene, "red1");
    const auto hits = queries.cast_all({{r.x, r.y, 5}, {0, 0, -1}});
    return std::ranges::any_of(hits, [](const auto& hit) { return hit.body.entity->name() == "red1"; });
  };
  EXPECT_TRUE(seen());
  EXPECT_TRUE(on_the_ray());
  const Entity &red = scene.simulation().world().entity("red1"), &blue = scene.simulation().world().entity("blue1");
  EXPECT_TRUE(queries.distance({&red}, {&blue}).has_value());
  scene.leave("red1");
  EXPECT_FALSE(seen());
  EXPECT_FALSE(on_the_ray());
  EXPECT_FALSE(queries.distance({&red}, {&blue}).has_value());
  EXPECT_FALSE(queries.distance({&blue}, {&red}).has_value());
  EXPECT_TRUE(std::isnan(numbers("truth", "red1_heading")));
  EXPECT_TRUE(std::isfinite(numbers("truth", "blue1_position"))) << "others are seen";
  scene.enter("red1");
  EXPECT_TRUE(seen());
  EXPECT_TRUE(on_the_ray());
}

TEST(ScenePresence, CamerasSeeNothingOfIt) {
  Scene scene(duel("kinematic_walking", red1 + R"(
[[robots]]
name = "eye"
controller = "none"
position = [0.6, -0.6]
heading_deg = 90
[robots.sensors.camera]
type = "camera"
width = 64
height = 48
always_on = true
labels = true
)"));
  const auto* frame = sensors::frames_of(scene.simulation().world().entity("eye"))[0];
  const auto& labels = frame->info->labels;
  const auto red = static_cast<std::uint16_t>(std::ranges::find(labels, "red1") - labels.begin());
  const auto pixels = [&] {
    const auto before = frame->number;
    while (frame->number < before + 2) scene.simulation().step();
    return std::ranges::count(frame->labels.pixels(), red);
  };
  EXPECT_GT(pixels(), 50);
  scene.leave("red1");
  EXPECT_EQ(pixels(), 0);
  scene.enter("red1");
  EXPECT_GT(pixels(), 50);
}

// Players go on without a mate, and stand still without a ball.
TEST(ScenePresence, PlayersGoOnWithoutOthers) {
  Scene scene(fixtures::write_scene(R"(
seed = 4
[ball]
position = [0.6, 0]
[[teams]]
name = "blue"
[defaults]
model = "kid21"
team = "blue"
controller = "ball_chaser"
[[robots]]
name = "near"
position = [0.2, 0]
[[robots]]
name = "far"
position = [-0.7, 0]
)"));
  scene.simulation().run(100ms);
  scene.leave("near");
  scene.simulation().run(6s);
  EXPECT_GT(place_of(scene, "far").x, -0.1) << "it is the nearest to the ball now";
  scene.leave("ball");
  scene.simulation().run(2s);
  const Vec3d place = place_of(scene, "far");
  scene.simulation().run(2s);
  EXPECT_LT(norm(place_of(scene, "far") - place), 0.02) << "there is nothing to run after";
}

TEST(ScenePresence, ChangesByEvents) {
  Scene scene(duel("kinematic_walking", red1, ""), {.events = {"0.5:red1.present=false", "1:red1.present=true",
                                                               "1:ball.present=false", "1.5:red.*.present=false"}});
  const Entity& red = scene.simulation().world().entity("red1");
  const auto there = [&](Duration time) {
    scene.simulation().run(time - scene.simulation().now());
    return red.present();
  };
  EXPECT_TRUE(there(500ms));
  EXPECT_FALSE(there(501ms));
  EXPECT_FALSE(there(1s));
  EXPECT_TRUE(there(1001ms));
  EXPECT_FALSE(there(1600ms));
  std::vector<std::string> said;
  for (const Event& event : scene.simulation().events()) said.push_back(event.text);
  EXPECT_EQ(said, (std::vector<std::string>{"red1: left", "red1: entered", "ball: left", "red1: left"}));
  const std::string report = to_text(make_report(scene));
  EXPECT_TRUE(says(report, {"absent"}));
  EXPECT_TRUE(says(to_json(make_report(scene)), {"\"present\": false"}));
}

TEST(ScenePresence, WrongWishesAreRefusedInOneLine) {
  Scene scene(duel("kinematic_walking", red1));
  EXPECT_TRUE(says(error_of([&] { scene.enter("red1"); }), {"red1", "there already"}));
  EXPECT_TRUE(says(error_of([&] { scene.leave("red2"); }), {"red2", "red1"}));
  EXPECT_TRUE(says(error_of([&] { scene.leave("field"); }), {"field", "always there"}));
  const auto event = [&](const std::string& text) {
    return error_of([&] { Scene(duel("kinematic_walking", red1), {.events = {text}}); });
  };
  EXPECT_TRUE(says(event("1:red1.present=maybe"), {"1:red1.present=maybe", "true or false", "maybe"}));
  EXPECT_TRUE(says(event("1:red1.presnt=true"), {"presnt", "present"}));
  EXPECT_TRUE(says(error_of([&] {
                     Scene(
                         fixtures::write_scene("[[bodies]]\nname = 'wall'\nshape = 'box'\nsize = [1, 1, 1]\n"
                                               "static = true\npresent = false\n"));
                   }),
                   {"present", "static body"}));
}

// An entity that enters where another stands is pushed apart from it; a warning says so.
TEST(ScenePresence, ATakenPlaceIsAWarning) {
  Scene scene(duel("simplified_dynamics", red1));
  scene.simulation().initialize();
  scene.leave("red1");
  scene.simulation().world().entity("blue1").base().set(properties::position, {0.7, 0.05, place_of(scene, "blue1").z});
  scene.simulation().step();
  EXPECT_TRUE(scene.parts().diagnostics.warnings().empty());
  scene.enter("red1");
  ASSERT_EQ(scene.parts().diagnostics.warnings().size(), 1u);
  EXPECT_TRUE(says(scene.parts().diagnostics.warnings()[0], {"blue1", "red1", "overlap"}));
}

TEST(ScenePresence, OfTheStartComesBackWithAReset) {
  const std::string file = duel("full_dynamics", red1 + "present = false\n", "[start]\njitter_position = 0.02\n");
  Scene scene(file);
  scene.simulation().run(300ms);
  scene.enter("red1");
  scene.leave("ball");
  scene.simulation().run(300ms);
  scene.reset();
  Scene fresh(file);
  fresh.simulation().initialize();
  EXPECT_EQ(difference(go_on(scene, 300ms), go_on(fresh, 300ms)), "");
}

// What was set of a robot is set when it comes back, too.
TEST(ScenePresence, SettingsHoldAgain) {
  Scene scene(duel("full_dynamics", red1), {.overrides = {"red1.pelvis.applied_force=[0,0,0,3,0,0]"}});
  Entity& red = scene.simulation().world().entity("red1");
  scene.simulation().run(100ms);
  const auto force = [&] { return red.object("pelvis").get("applied_force").numbers; };
  const auto set = force();
  red.object("pelvis").set("applied_force", std::vector<double>(6, 0.0));
  scene.leave("red1");
  scene.enter("red1");
  EXPECT_EQ(force(), set);
}

}  // namespace
}  // namespace murosimf::scene
