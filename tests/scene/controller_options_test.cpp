// Every option of a controller acts, and its default is what happens without it.
#include <gtest/gtest.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {
namespace {

struct Play {
  std::string scene;
  double duration;  ///< [s]
  std::vector<std::string> set = {};
};

std::uint64_t hash_of(const Play& play, const std::string& option = {}) {
  SceneOptions options{.overrides = play.set, .cameras = false};
  if (!option.empty()) options.overrides.push_back(option);
  Scene scene(play.scene, options);
  scene.simulation().run(from_seconds(play.duration));
  return scene.simulation().world().state_hash();
}

void expect_options_act(const std::string& controller, const std::string& robots, const Play& play) {
  const std::uint64_t plain = hash_of(play);
  for (const OptionInfo& option : catalog::controllers().find(controller).options) {
    const std::string path = robots + ".options." + option.name + "=";
    const double usual = std::get<double>(option.fallback);
    EXPECT_EQ(hash_of(play, path + value_text(usual)), plain) << path;
    EXPECT_NE(hash_of(play, path + value_text(0.7 * usual)), plain) << path;
  }
}

TEST(ControllerOptions, OfTheBallChaserAct) { expect_options_act("ball_chaser", "*", {"three_on_three", 20}); }

TEST(ControllerOptions, OfDriveAct) {
  expect_options_act("drive", "car", {"car_crash", 1, {"car.command=[1, 0, 0.5]"}});
}

TEST(ControllerOptions, OfBalanceAct) {
  expect_options_act("balance", "robot", {"push", 3, {"robot.controller=balance"}});
}

}  // namespace
}  // namespace murosimf::scene
