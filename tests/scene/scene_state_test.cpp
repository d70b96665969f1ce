// A state that is loaded goes on as the one that was saved: the same bits in all columns, readings and pictures.
#include "murosimf/scene/scene_state.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/scene/scene_hashes.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;

SceneOptions options() { return {}; }

void expect_repeats(const std::string& file, Duration before, Duration after, const SceneOptions& how = options()) {
  Scene scene(file, how);
  scene.simulation().run(before);
  const auto before_saving = hashes_of(scene);
  const std::vector<std::byte> saved = scene.save();
  EXPECT_EQ(hashes_of(scene), before_saving) << "saving changed something";
  const auto hashes = go_on(scene, after);
  scene.load(saved);
  EXPECT_TRUE(scene.save() == saved);
  EXPECT_EQ(difference(hashes, go_on(scene, after)), "") << "in the same scene";
  Scene other(file, how);
  other.load(saved);
  EXPECT_EQ(difference(hashes, go_on(other, after)), "") << "in another one";
}

class SceneState : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Scenes, SceneState, testing::ValuesIn(all_scenes()),
                         [](const auto& test) { return test.param; });

TEST_P(SceneState, RepeatsBitForBit) { expect_repeats(GetParam(), 263ms, 150ms); }

/// One robot that walks at a level into a ball, with all that sensors remember: noise, walks, filters, delays.
std::string game(const std::string& level, const std::string& more = "") {
  return "seed = 7\n" + more + R"(
[ball]
position = [0.16, -0.03]
[defaults]
model = "kid21"
controller = "walk"
command = [0.2, 0, 0.1]
[defaults.sensors.imu]
delay = 0.013
[defaults.sensors.imu.gyroscope]
noise_density = 1e-3
bias_random_walk = 1e-3
low_pass = 40
[[robots]]
name = "one"
level = ")" +
         level + "\"\n[[robots]]\nname = \"two\"\nposition = [0.3, 0.05]\nheading_deg = 180\n";
}

class SceneStateOfLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, SceneStateOfLevel,
                         testing::Values("kinematic_walking", "simplified_dynamics", "full_dynamics",
                                         "articulated_dynamics"),
                         [](const auto& test) { return test.param; });

TEST_P(SceneStateOfLevel, RemembersSensorsAndLawsBetweenBodies) {
  for (const std::string law : {"island_gauss_seidel", "carry", "kelvin_voigt"}) {
    expect_repeats(fixtures::write_scene(game(GetParam(), "body_contact = '" + law + "'\n")), 433ms, 150ms);
  }
}

// The level that a state was saved at is not that of the scene that it is loaded into, nor the one before loading.
TEST_P(SceneStateOfLevel, BringsItsLevelAndLaws) {
  for (const std::string other : {"kinematic_walking", "articulated_dynamics"}) {
    const std::string file = fixtures::write_scene(
        game(GetParam()) + "[[events]]\ntime = 0.1\nset = ['one.level = " + other +
        "', 'one.contact = kelvin_voigt']\n" + "[[events]]\ntime = 0.4\nset = 'one.level = full_dynamics'\n");
    for (const Duration before : {50ms, 230ms, 430ms}) expect_repeats(file, before, 300ms);
  }
}

// Much is remembered for one step only, like what a foot that lifts off was loaded with: every step of a pace is tried.
TEST_P(SceneStateOfLevel, CanBeOfAnyStep) {
  const std::string file = fixtures::write_scene(game(GetParam()));
  SceneOptions sharing = options();
  sharing.assets = std::make_shared<Assets>();
  Scene scene(file, sharing);
  scene.simulation().run(300ms);
  for (int i = 0; i < 300; ++i) {
    Scene other(scene.spec(), sharing);  // a new one: what it does not load, it does not have
    other.load(scene.save());
    scene.simulation().step();
    other.simulation().step();
    ASSERT_EQ(difference({hashes_of(scene)}, {hashes_of(other)}), "") << i;
  }
}

TEST(SceneStates, RemembersPicturesOnTheirWay) {
  expect_repeats(fixtures::write_scene(game("simplified_dynamics",
                                            "[defaults.sensors.camera]\nwidth = 40\nheight = 30\nrate = 20\ndelay = "
                                            "0.07\nalways_on = true\n")),
                 213ms, 40ms);  // one of two has arrived by then, and shows
}

// Constant errors of sensors are no state, but what their seed has drawn.
TEST(SceneStates, BringsItsSeed) {
  const std::string file = fixtures::write_scene(game("simplified_dynamics"));
  SceneOptions other_seed = options();
  other_seed.seed = 8;
  Scene scene(file, options()), other(file, other_seed);
  scene.simulation().run(100ms);
  other.load(scene.save());
  EXPECT_EQ(other.spec().seed, 7u);
  EXPECT_EQ(difference(go_on(scene, 150ms), go_on(other, 150ms)), "");
}

TEST(SceneStates, RemembersWhoWasFrozen) {
  Scene scene(fixtures::write_scene(game("simplified_dynamics")));
  scene.simulation().run(50ms);
  const auto healthy = scene.save();
  scene.simulation().world().entity("one").freeze("a test");
  scene.simulation().run(20ms);
  const auto frozen = scene.save();
  const auto hashes = go_on(scene, 50ms);
  const auto warnings = scene.simulation().warnings();
  scene.load(healthy);
  EXPECT_FALSE(scene.simulation().world().entity("one").frozen());
  EXPECT_TRUE(scene.simulation().warnings().empty());
  const Vec3d before = scene.simulation().world().entity("one").base().get(properties::position);
  scene.simulation().run(50ms);
  EXPECT_GT(norm(scene.simulation().world().entity("one").base().get(properties::position) - before), 0);
  scene.load(frozen);
  EXPECT_EQ(difference(hashes, go_on(scene, 50ms)), "");
  EXPECT_EQ(scene.simulation().warnings(), warnings);
}

// Whatever is wrong, one line says it, and the scene continues as without the attempt.
TEST(SceneStates, RefusesWhatIsNoneOfItsOwn) {
  const std::string file = fixtures::write_scene(game("simplified_dynamics"));
  Scene scene(file);
  scene.simulation().run(100ms);
  const auto saved = scene.save();
  const auto refused = [&](const std::vector<std::byte>& bytes, std::initializer_list<std::string_view> words) {
    const std::string said = error_of([&] { scene.load(bytes); });
    EXPECT_TRUE(says(said, words)) << said;
    EXPECT_TRUE(scene.save() == saved) << said;
  };
  refused({}, {"these bytes are no state of a scene"});
  refused(std::vector<std::byte>(300, std::byte{0x7f}), {"these bytes are no state of a scene"});
  auto bytes = saved;
  bytes.pop_back();
  refused(bytes, {"the state is cut off", fmt::format("{} bytes", bytes.size())});
  bytes = saved;
  bytes.push_back({});
  refused(bytes, {"damaged"});
  bytes = saved;
  bytes[bytes.size() / 2] ^= std::byte{1};
  refused(bytes, {"damaged"});
  const std::string older = "1234567 MuRoSimF state 2 and more", newer = "MuRoSimF scene state 4 and more";
  for (const std::string& text : {older, newer}) {
    const auto other = std::as_bytes(std::span(text));
    refused({other.begin(), other.end()}, {"of another form than this version of the program has"});
  }
  const auto refused_of = [&](const std::string& text, std::initializer_list<std::string_view> words) {
    Scene other(fixtures::write_scene(text));
    refused(other.save(), words);
  };
  refused_of(game("simplified_dynamics") + "[[robots]]\nname = 'three'\nposition = [2, 1]\n", {"has 4 values, not 3"});
  refused_of(game("simplified_dynamics") + "[[events]]\ntime = 1\nset = 'one.level = full_dynamics'\n",
             {"calls at given times"});
  refused_of(game("simplified_dynamics", "rate = 500\n[defaults.sensors.eye]\ntype = 'sonar'\nrange = 2\n"),
             {"sensor.eye", "built otherwise"});
}

// A checksum stands over all of it.
TEST(SceneStates, RefusesAnyFlippedBitAndAnyEnd) {
  Scene scene("walk", {.overrides = {"walker.level=simplified_dynamics"}, .cameras = false});
  scene.simulation().run(50ms);
  const auto saved = scene.save();
  const auto is_refused = [&](const std::vector<std::byte>& bytes) {
    return error_of([&] { scene.load(bytes); }) != "no error";
  };
  const std::size_t every = std::max<std::size_t>(1, saved.size() / 400);
  for (std::size_t i = 0; i < saved.size(); i += i < 200 ? 1 : every) {
    auto bytes = saved;
    bytes[i] ^= std::byte{static_cast<unsigned char>(1U << i % 8)};
    EXPECT_TRUE(is_refused(bytes)) << "bit " << i % 8 << " of byte " << i << " of " << saved.size();
    EXPECT_TRUE(is_refused({saved.begin(), saved.begin() + static_cast<std::ptrdiff_t>(i)})) << i << " bytes";
  }
  EXPECT_TRUE(scene.save() == saved);
  EXPECT_FALSE(is_refused(saved));
}

}  // namespace
}  // namespace murosimf::scene
