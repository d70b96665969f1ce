// What other threads change in a running scene can be repeated, bit for bit.
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/scene/scene_hashes.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using fixtures::says;

std::string game() {
  return fixtures::write_scene(R"(
seed = 3
[ball]
position = [0.3, 0.1]
[[teams]]
name = "blue"
[defaults]
model = "kid21"
team = "blue"
controller = "walk"
command = [0.2, 0, 0.1]
level = "simplified_dynamics"
[[robots]]
name = "one"
[[robots]]
name = "two"
position = [0.5, 0.2]
heading_deg = 180
)");
}

std::string random_change(std::mt19937& dice) {
  const std::vector<std::string> changes{
      "one.level = full_dynamics",
      "two.level = articulated_dynamics",
      "blue.*.level = simplified_dynamics",
      "one.contact = kelvin_voigt",
      "ball.contact = implicit_stick",
      "two.command = [0.1, 0.05, -0.2]",
      "one.command = [0, 0, 0]",
      "one.pelvis.applied_force = {force = [3, -2, 0]}",
      "two.present = false",
      "two.present = true",
      "ball.present = false",
      "ball.present = true",
      "ball.radius = 0.08",
      "ball.radius = 0.05",
      "ball.mass = 0.3",
      "ball.material = rubber",
      "light.brightness = 0.5",
      "nobody.level = full_dynamics",
      "two.level = no_such_level",
  };
  return changes[dice() % changes.size()];
}

TEST(SceneCommands, OfAnotherThreadAreRepeatedFromTheirRecord) {
  const std::string file = game();
  Scene scene(file);
  std::vector<std::future<void>> done;
  std::atomic<bool> ended{false};
  std::thread other([&] {
    std::mt19937 dice(5);
    while (!ended) {
      done.push_back(scene.post(random_change(dice)));
      std::this_thread::sleep_for(1ms);  // some steps lie between most of them
    }
  });
  const auto& commands = scene.simulation().commands();
  while (commands.size() < 30 && scene.simulation().now() < 100s) scene.simulation().run(50ms);
  ended = true;
  other.join();
  scene.simulation().run(10ms);
  ASSERT_GE(commands.size(), 30u);
  for (int threads = 1; threads <= 3; ++threads) {
    Scene again(file, {.threads = threads, .events = events_of_commands(commands)});
    again.simulation().run(scene.simulation().now());
    EXPECT_EQ(difference({hashes_of(scene)}, {hashes_of(again)}), "") << threads;
  }
}

TEST(SceneCommands, AreDoneAtTheBeginningOfTheNextStep) {
  Scene scene(game());
  scene.simulation().run(20ms);
  auto done = scene.post("one.level = full_dynamics");
  EXPECT_EQ(done.wait_for(0s), std::future_status::timeout);
  EXPECT_EQ(scene.simulation().world().entity("one").level, "simplified_dynamics");
  scene.simulation().step();
  EXPECT_NO_THROW(done.get());
  EXPECT_EQ(scene.simulation().world().entity("one").level, "full_dynamics");
  ASSERT_EQ(scene.simulation().commands().size(), 1u);
  EXPECT_EQ(events_of_commands(scene.simulation().commands())[0], "0.020000000:one.level = full_dynamics");
}

TEST(SceneCommands, TellWhatIsWrongInOneLine) {
  Scene scene(game());
  const auto said = [&](const std::string& change) {
    auto done = scene.post(change);
    scene.simulation().step();
    return fixtures::error_of([&] { done.get(); });
  };
  EXPECT_TRUE(says(said("nobody.level = full_dynamics"), {"nobody", "one"}));
  EXPECT_TRUE(says(said("one.level = full_dynamic"), {"full_dynamic", "full_dynamics"}));
  EXPECT_TRUE(says(said("one.levels = full_dynamics"), {"levels", "level"}));
  EXPECT_TRUE(says(said("one"), {"PATH=VALUE"}));
  EXPECT_TRUE(says(said("one.torso.mass = -3"), {"above 0"}));
  EXPECT_TRUE(scene.simulation().commands().empty());
}

TEST(SceneCommands, AResetForgetsThem) {
  Scene scene(game());
  (void)scene.post("one.level = full_dynamics");
  scene.simulation().step();
  scene.reset();
  EXPECT_TRUE(scene.simulation().commands().empty());
  EXPECT_EQ(scene.simulation().world().entity("one").level, "simplified_dynamics");
}

TEST(ScenePoses, ShowContactsWithTheGroundAndTheWeight) {
  Scene scene(
      fixtures::write_scene("[defaults]\nmodel = 'kid21'\nlevel = 'full_dynamics'\n[[robots]]\nname = 'one'\n"));
  const auto reader = scene.simulation().poses().subscribe({.contacts = true});
  scene.simulation().run(1s);
  const PoseFrame* frame = reader->latest();
  ASSERT_NE(frame, nullptr);
  ASSERT_GE(frame->contacts.size(), 3u);
  double weight = 0;
  for (const ContactMark& mark : frame->contacts) {
    weight += mark.force.z;
    EXPECT_NEAR(mark.point.z, 0, 0.01);
  }
  const double mass = scene.simulation().world().entity("one").model().tree().mass;
  EXPECT_NEAR(weight, 9.81 * mass, 0.02 * 9.81 * mass);
}

}  // namespace
}  // namespace murosimf::scene
