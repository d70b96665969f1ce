// Robots that step in lanes are robots that step alone, bit for bit: whatever steps beside them, falls, breaks, changes its level, or
// leaves.
#include <gtest/gtest.h>

#include "murosimf/math/pack.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/scene/scene_hashes.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;

const std::vector<std::string> commands{"0.1, 0, 0",   "0.2, 0, 0",       "0, 0, 0.5",   "-0.1, 0, 0",
                                        "0, 0.05, 0",  "0.15, 0.03, 0.3", "0, 0, 0",     "0.25, 0, 0",
                                        "0.1, 0, 0.1", "0.05, 0, 0",      "0.1, 0, -0.2"};

/// Eleven copies of one robot with commands of their own; the first two meet, and one begins in the air.
std::string eleven(const std::string& level) {
  std::string text = "[defaults]\nmodel = \"kid21\"\ncontroller = \"walk\"\nlevel = \"" + level + "\"\n";
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const double x = i == 1 ? 0.22 : 0, y = i < 2 ? 0 : static_cast<double>(i);
    text += "[[robots]]\nname = \"r" + std::to_string(i) + "\"\ncommand = [" + commands[i] + "]\nposition = [" +
            std::to_string(x) + ", " + std::to_string(y) +
            (i == 9 && level != "kinematic_walking" ? ", 0.05]\n" : "]\n");
    if (i == 1) text += "heading_deg = 180\n";
  }
  return text;
}

/// What happens to some of them on the way, all of it where lanes are shared.
const std::vector<std::string> mishaps{"0.15:r3.present=false",           "0.35:r3.present=true",
                                       "0.2:r4.level=full_dynamics",      "0.3:r4.level=articulated_dynamics",
                                       "0.25:r5.level=kinematic_walking", "0.28:r6.level=simplified_dynamics"};
const std::vector<std::string> pushes{"r7.torso=[90,0,0]@0.1..0.3", "r8.torso=[0,20,0]@0.2..0.25"};

/// How many of eight robots are in lanes if as many threads share them out: a thread with too few has them step one by one.
std::size_t in_lanes(std::size_t threads) {
  constexpr std::size_t members = 8, fewest = Pack8::registers + 1;
  const std::size_t share = members / threads, threads_with_one_more = members % threads;
  if (share >= fewest) return members;
  return share + 1 >= fewest ? threads_with_one_more * (share + 1) : 0;
}

class LanesAtLevel : public testing::TestWithParam<const char*> {
 protected:
  /// Hashes of all columns after every 25 ms of half a second, in which one robot gets a target that is no number.
  std::vector<std::map<std::string, std::uint64_t>> course(const SceneOptions& options, std::size_t fewest_in_lanes) {
    SceneOptions with_mishaps = options;
    with_mishaps.events = mishaps;
    if (GetParam() != std::string("kinematic_walking")) with_mishaps.pushes = pushes;  // which feels none
    Scene scene(fixtures::write_scene(eleven(GetParam())), with_mishaps);
    std::vector<std::map<std::string, std::uint64_t>> hashes;
    for (int i = 0; i < 20; ++i) {
      if (i == 10) break_a_robot(scene);
      scene.simulation().run(25ms);
      hashes.push_back(hashes_of(scene));
    }
    EXPECT_GE(scene.simulation().algorithms_in_lanes(), fewest_in_lanes) << "of those that have not left their level";
    EXPECT_TRUE(scene.simulation().world().entity("r10").frozen());
    return hashes;
  }

 private:
  static void break_a_robot(Scene& scene) {
    Entity& robot = scene.simulation().world().entity("r10");
    robot.base().set(properties::position, {std::nan(""), 0, 0});
  }
};

TEST_P(LanesAtLevel, AreRobotsThatStepAlone) {
  const auto alone = course({.lanes = false}, 0);
  EXPECT_EQ(difference(course({}, in_lanes(1)), alone), "");
  EXPECT_EQ(difference(course({.threads = 2}, in_lanes(2)), alone), "");
  EXPECT_EQ(difference(course({.threads = 3}, in_lanes(3)), alone), "");
}

TEST_P(LanesAtLevel, CanBeSwitchedAndGoOnFromAState) {
  const std::string file = fixtures::write_scene(eleven(GetParam()));
  Scene lanes(file), alone(file, {.lanes = false}), by_turns(file);
  for (int i = 0; i < 6; ++i) {
    by_turns.simulation().use_lanes(i % 2 == 0);
    for (Scene* scene : {&lanes, &alone, &by_turns}) scene->simulation().run(17ms);
  }
  ASSERT_EQ(difference({hashes_of(lanes)}, {hashes_of(alone)}), "");
  EXPECT_EQ(difference({hashes_of(by_turns)}, {hashes_of(alone)}), "");
  const auto state = alone.save();
  by_turns.simulation().run(100ms);
  by_turns.load(state);
  EXPECT_EQ(difference(go_on(by_turns, 50ms), go_on(alone, 50ms)), "") << "from a state";
  lanes.reset();
  alone.reset();
  EXPECT_EQ(difference(go_on(lanes, 50ms), go_on(alone, 50ms)), "") << "after a reset";
}

/// What is written into a robot's columns between two steps is taken over.
TEST_P(LanesAtLevel, TakeOverWhatOthersChange) {
  const std::string file = fixtures::write_scene(eleven(GetParam()));
  const auto changed = [&](bool use_lanes) {
    Scene scene(file, {.lanes = use_lanes});
    scene.simulation().run(50ms);
    Entity& robot = scene.simulation().world().entity("r2");
    robot.base().set(properties::position, robot.base().get(properties::position) + Vec3d{0.5, 0, 0});
    const auto joint = static_cast<std::size_t>(robot.model().joints()[5]);
    robot.object(robot.model().objects()[joint].name).set(properties::joint_position, 0.3);
    return go_on(scene, 50ms);
  };
  EXPECT_EQ(difference(changed(true), changed(false)), "");
}

INSTANTIATE_TEST_SUITE_P(All, LanesAtLevel,
                         testing::Values("kinematic_walking", "simplified_dynamics", "full_dynamics",
                                         "articulated_dynamics"));

class LanesInScene : public testing::TestWithParam<std::string> {};

TEST_P(LanesInScene, AreRobotsThatStepAlone) {
  const auto hashes = [&](bool use_lanes) {
    Scene scene(GetParam(), {.lanes = use_lanes, .cameras = false});
    return go_on(scene, 300ms);
  };
  EXPECT_EQ(difference(hashes(true), hashes(false)), "");
}

INSTANTIATE_TEST_SUITE_P(All, LanesInScene, testing::ValuesIn(all_scenes()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace murosimf::scene
