// include/murosimf/scene.h: the run, against the scene inside; its entities, contacts and rays against laws.
#include "murosimf/scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/scene/scene.h"
#include "tests/written_scene.h"

namespace murosimf::api {
namespace {

/// What() of the exception of type E that `call` throws; empty if it throws none.
template <class E, class Call>
std::string thrown(const Call& call) {
  try {
    call();
  } catch (const E& error) {
    return error.what();
  }
  return {};
}

const std::vector<std::string> simplified = {"walker.level=simplified_dynamics"};

TEST(ApiScene, RunsAsTheSceneInside) {
  scene::Scene truth("walk", {.overrides = simplified});
  truth.simulation().run(std::chrono::milliseconds(1500));
  for (const int threads : {1, 2}) {
    Scene scene("walk", {.threads = threads, .set = simplified});
    scene.run(1.0);
    scene.step(500);
    EXPECT_EQ(scene.state_hash(), truth.simulation().state_hash());
    EXPECT_EQ(scene.nanoseconds(), 1'500'000'000);
    EXPECT_DOUBLE_EQ(scene.time(), 1.5);
    EXPECT_DOUBLE_EQ(scene.step_length(), 1e-3);
    EXPECT_EQ(scene.name(), "Walk");
  }
}

TEST(ApiScene, TwoDoNotKnowEachOther) {
  Scene alone("walk", {.set = simplified});
  alone.run(0.5);
  Scene a("walk", {.set = simplified}), b("walk");
  for (int i = 0; i < 500; ++i) {
    a.step();
    b.step();
    if (i == 100) b.change("walker.level=full_dynamics");
  }
  EXPECT_EQ(a.state_hash(), alone.state_hash());
  EXPECT_NE(b.state_hash(), alone.state_hash());
}

TEST(ApiScene, GoesBackToItsStart) {
  const std::vector<std::string> jitter = {"start.jitter_heading_deg=20"};
  Scene scene("walk", {.set = jitter});
  const std::uint64_t start = scene.state_hash();
  scene.run(0.3);
  EXPECT_NE(scene.state_hash(), start);
  scene.reset();
  EXPECT_EQ(scene.state_hash(), start);
  scene.reset(7);
  EXPECT_EQ(scene.state_hash(), Scene("walk", {.seed = 7, .set = jitter}).state_hash());
}

TEST(ApiScene, GoesOnFromASavedStateAndAsACopy) {
  Scene scene("walk", {.set = simplified});
  scene.run(0.4);
  const std::vector<std::byte> state = scene.save();
  Scene copy = scene.copy();
  scene.run(0.4);
  copy.run(0.4);
  EXPECT_EQ(copy.state_hash(), scene.state_hash());
  Scene other("walk", {.set = simplified});
  other.load(state);
  EXPECT_DOUBLE_EQ(other.time(), 0.4);
  other.run(0.4);
  EXPECT_EQ(other.state_hash(), scene.state_hash());
  const std::vector<std::byte> damaged(state.begin(), state.begin() + 100);
  EXPECT_NE(thrown<InputError>([&] { other.load(damaged); }), "");
  EXPECT_EQ(other.state_hash(), scene.state_hash());
}

TEST(ApiScene, RunsUntilSomethingIsTrue) {
  Scene scene("walk", {.set = simplified});
  const Robot walker = scene.robot("walker");
  const double begin = walker.pose().position.x;
  EXPECT_TRUE(scene.run_until([&] { return walker.pose().position.x > begin + 0.1; }, 10));
  EXPECT_GT(walker.pose().position.x, begin + 0.1);
  const double time = scene.time();
  EXPECT_LT(time, 10);
  EXPECT_FALSE(scene.run_until([] { return false; }, 0.25));
  EXPECT_DOUBLE_EQ(scene.time(), time + 0.25);
}

TEST(ApiScene, HandlesOutliveIt) {
  std::optional<Robot> robot;
  std::span<const double> positions;
  double first = 0;
  {
    Scene scene("walk", {.set = simplified});
    robot = scene.robot("walker");
    scene.run(0.2);
    positions = robot->joint_position();
    first = positions[3];
    Scene moved = std::move(scene);
    moved.step();
    EXPECT_EQ(thrown<Error>([&] { scene.step(); }), "this scene was moved from");
  }
  const Robot taken = std::move(*robot);
  EXPECT_EQ(taken.name(), "walker");
  EXPECT_EQ(robot->name(), "walker") << "of a handle that was moved, too";
  EXPECT_EQ(positions[3], first);
  EXPECT_EQ(robot->joint_position().data(), positions.data());
}

TEST(ApiScene, SaysWhatIsWrong) {
  EXPECT_NE(thrown<InputError>([] { Scene("no_such_scene"); }).find("no file 'no_such_scene'"), std::string::npos);
  EXPECT_NE(thrown<InputError>([] {
              Scene("walk", {.set = {"walker.levle=full_dynamics"}});
            }).find("did you mean 'level'"),
            std::string::npos);
  EXPECT_NE(thrown<InputError>([] { Scene("walk", {.threads = 0}); }).find("at least 1"), std::string::npos);
  const std::string file = fixtures::write_scene("duration = 2.0\nseeed = 3\n");
  EXPECT_NE(thrown<InputError>([&] { Scene{file}; }).find(file + ":2:1"), std::string::npos);
  Scene scene("walk");
  EXPECT_NE(thrown<UnknownName>([&] { (void)scene.robot("walkr"); }).find("did you mean 'walker'"), std::string::npos);
  EXPECT_NE(thrown<UnknownName>([&] { (void)scene.entity("bal"); }), "");
  EXPECT_NE(thrown<UnknownName>([&] { (void)scene.robot("walker").pose("heat"); }).find("did you mean 'head'"),
            std::string::npos);
  EXPECT_NE(thrown<InputError>([&] { scene.run(-1); }), "");
  EXPECT_NE(thrown<InputError>([&] { scene.run(std::nan("")); }), "");
  EXPECT_NE(thrown<InputError>([&] { scene.step(-1); }), "");
  EXPECT_NE(thrown<InputError>([&] { scene.change("walker.level=full"); }), "");
  EXPECT_DOUBLE_EQ(scene.time(), 0);
}

TEST(ApiScene, IsReadFromAText) {
  const std::string text = "[ball]\nposition = [0.5, 0.0]\n[[robots]]\nname = \"a\"\nmodel = \"kid21\"\n";
  Scene scene = Scene::of_text(text);
  scene.run(0.1);
  EXPECT_EQ(scene.robots(), std::vector<std::string>{"a"});
  scene::Scene truth(fixtures::write_scene(text));
  truth.simulation().run(std::chrono::milliseconds(100));
  EXPECT_EQ(scene.state_hash(), truth.simulation().state_hash());
  const std::string message = thrown<InputError>([] { (void)Scene::of_text("[ball]\nsize = 3\n"); });
  EXPECT_EQ(message.substr(0, 15), "scene.toml:2:1:") << message;
}

TEST(ApiScene, HasARobotAlone) {
  Scene scene = Scene::of_robot("kid21");
  EXPECT_EQ(scene.robots(), std::vector<std::string>{"robot"});
  EXPECT_EQ(scene.robot().level(), "articulated_dynamics");
  scene.run(0.1);
  EXPECT_EQ(scene.robot().frozen(), "");
  EXPECT_NE(thrown<InputError>([] { (void)Scene::of_robot("no\"such"); }).find("no\"such"), std::string::npos);
}

TEST(ApiScene, EntitiesComeAndGo) {
  Scene scene("walk");
  scene.run(0.2);
  Robot second =
      scene.add(NewRobot{.name = "second", .model = "kid21", .level = "simplified_dynamics", .position = {0, 1, 0}});
  EntityHandle box = scene.add(
      NewBody{.name = "box", .shape = NewBody::Shape::box, .size = {0.2, 0.3, 0.1}, .mass = 1, .position = {1, 2, 0}});
  EXPECT_EQ(scene.robots(), (std::vector<std::string>{"walker", "second"}));
  scene.run(0.5);
  EXPECT_NEAR(second.pose().position.y, 1, 0.05);
  EXPECT_NEAR(box.pose().position.z, 0.05, 2e-3);  // half of its height, less what it sinks in
  scene.leave("box");
  EXPECT_FALSE(box.present());
  scene.enter("box");
  EXPECT_TRUE(box.present());
  EXPECT_NE(thrown<InputError>([&] { (void)scene.add(NewBody{.name = "box"}); }), "");
  EXPECT_NE(thrown<InputError>([&] {
              (void)scene.add(NewBody{.name = "flat", .shape = NewBody::Shape::box, .size = {1, 1, 0}});
            }),
            "");
  EXPECT_NE(thrown<InputError>([&] { (void)scene.add(NewRobot{.name = "third", .model = "kid22"}); }), "");
}

TEST(ApiScene, ContactsCarryTheWeight) {
  Scene scene = Scene::of_text(
      "[[bodies]]\nname = \"a\"\nshape = \"box\"\nsize = [0.2, 0.2, 0.1]\nmass = 2.0\n"
      "[[bodies]]\nname = \"b\"\nshape = \"sphere\"\nradius = 0.1\nmass = 0.5\nposition = [1.0, 0.0, 0.0]\n");
  scene.run(2.0);
  double on_a = 0, on_b = 0;
  const std::vector<Contact> contacts = scene.contacts();
  for (const Contact& contact : contacts) {
    (contact.a == "a" ? on_a : on_b) += contact.force.z;
    EXPECT_NEAR(contact.normal.z, 1, 1e-9);
    EXPECT_NEAR(contact.point.z, 0, 2e-3);
    EXPECT_EQ(contact.b, "field");
  }
  EXPECT_NEAR(on_a, 2.0 * 9.81, 0.02);
  EXPECT_NEAR(on_b, 0.5 * 9.81, 0.01);
}

TEST(ApiScene, ContactsOfTwoThatMoveAreListedOnce) {
  Scene scene = Scene::of_text(
      "[[bodies]]\nname = \"low\"\nshape = \"box\"\nsize = [0.4, 0.4, 0.1]\nmass = 2.0\n"
      "[[bodies]]\nname = \"high\"\nshape = \"box\"\nsize = [0.2, 0.2, 0.1]\nmass = 1.0\nposition = [0.0, 0.0, 0.1]\n");
  scene.run(2.0);
  double between = 0;
  for (const Contact& contact : scene.contacts()) {
    if (contact.a == "low" && contact.b == "high") between -= contact.force.z;
    if (contact.a == "high" && contact.b == "low") between += contact.force.z;
  }
  EXPECT_NEAR(between, 9.81, 0.05);
}

TEST(ApiScene, AnswersRaysAndDistances) {
  Scene scene = Scene::of_text(
      "[[bodies]]\nname = \"a\"\nshape = \"sphere\"\nradius = 0.1\nmass = 1.0\nposition = [1.0, 0.0, 0.0]\n"
      "[[bodies]]\nname = \"b\"\nshape = \"sphere\"\nradius = 0.2\nmass = 1.0\nposition = [-1.0, 0.0, 0.0]\n");
  const auto ground = scene.cast({0, 3, 0.7}, {0, 0, -2});
  ASSERT_TRUE(ground);
  EXPECT_EQ(ground->entity, "field");
  EXPECT_NEAR(ground->distance, 0.7, 1e-12);
  EXPECT_NEAR(ground->normal.z, 1, 1e-12);
  const auto sphere = scene.cast({0, 0, 0.1}, {1, 0, 0});
  ASSERT_TRUE(sphere);
  EXPECT_EQ(sphere->entity, "a");
  EXPECT_NEAR(sphere->distance, 0.9, 1e-9);
  EXPECT_FALSE(scene.cast({0, 0, 0.1}, {1, 0, 0}, 0.5));
  const auto behind = scene.cast({0, 0, 0.1}, {1, 0, 0}, 1.5, "a");
  EXPECT_TRUE(!behind || behind->entity != "a");
  EXPECT_NEAR(scene.distance("a", "b").value(), std::hypot(2.0, 0.1) - 0.3, 1e-9);
  (void)scene.add(NewBody{.name = "c", .size = {0.1, 0, 0}, .position = {0.5, 0, 0}});
  EXPECT_EQ(scene.cast({0, 0, 0.1}, {1, 0, 0})->entity, "c");
  EXPECT_NE(thrown<InputError>([&] { (void)scene.cast({}, {}); }), "");
  EXPECT_NE(thrown<UnknownName>([&] { (void)scene.distance("a", "d"); }), "");
}

TEST(ApiScene, TellsWhatHappened) {
  Scene scene("walk", {.events = {"0.1:walker.level=full_dynamics"}});
  scene.run(0.2);
  ASSERT_FALSE(scene.events().empty());
  EXPECT_DOUBLE_EQ(scene.events()[0].time, 0.1);
  EXPECT_NE(scene.events()[0].text.find("full_dynamics"), std::string::npos);
  EXPECT_EQ(scene.robot().level(), "full_dynamics");
}

TEST(ApiScene, DrawsWhatPeopleWouldSee) {
  Scene scene = Scene::of_text(
      "[[bodies]]\nname = \"a\"\nshape = \"sphere\"\nradius = 0.5\nmass = 1.0\ncolor = [1.0, 0.0, 0.0]\n");
  Image image;
  try {
    image = scene.picture({.eye = {-2, 0, 0.5}, .look_at = {0, 0, 0.5}, .width = 64, .height = 48});
  } catch (const InputError& error) {
    GTEST_SKIP() << error.what();
  }
  ASSERT_EQ(image.rgb.size(), 3U * 64 * 48);
  ASSERT_EQ(image.depth.size(), 64U * 48);
  const std::size_t middle = 24 * 64 + 32;
  EXPECT_NEAR(image.depth[middle], 1.5, 0.01);
  EXPECT_GT(image.rgb[3 * middle], 2 * image.rgb[3 * middle + 1]);
  EXPECT_NE(thrown<InputError>([&] { (void)scene.picture({.width = 0}); }), "");
}

}  // namespace
}  // namespace murosimf::api
