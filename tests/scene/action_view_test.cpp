// A view that follows: everything followed is in the picture, large, and the picture does not jump.
#include "murosimf/scene/action_view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "tests/fixtures.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;

std::string walker() {
  return fixtures::write_scene(
      "[ball]\nposition = [0.6, 0.1]\n[[robots]]\nname = 'one'\nmodel = 'kid21'\ncommand = [0.2, 0, 0]\n"
      "[[robots]]\nname = 'far'\nmodel = 'kid21'\nposition = [-2, 1]\n");
}

/// How far out the outermost origin of an entity's bodies is: 1 is the edge of the picture; infinite behind the eye.
double outermost(const Scene& scene, const std::string& name, const sensors::Perspective& view) {
  double most = 0;
  for (const Vec3d& r : scene.simulation().world().find(name)->find(properties::position)->values) {
    const Vec3d seen = transposed_times(view.axes, r - view.eye);
    if (seen.z <= 0) return HUGE_VAL;
    most = std::fmax(most, std::fmax(std::abs(seen.x / seen.z) / view.right, std::abs(seen.y / seen.z) / view.bottom));
  }
  return most;
}

TEST(ActionView, HasWhatItFollowsInThePictureAndLarge) {
  Scene scene(walker());
  scene.simulation().initialize();
  ActionView view(scene);
  view.follow({"one"}, true);
  for (int i = 0; i < 100; ++i) {
    scene.simulation().run(40ms);
    const sensors::Perspective from = view.look(640, 360);
    ASSERT_LT(outermost(scene, "one", from), 1) << i;
    ASSERT_GT(outermost(scene, "one", from), 0.3) << i;
  }
  EXPECT_GT(outermost(scene, "far", view.look(640, 360)), 1) << "nobody has asked for it";
  view.follow({"one", "far"}, true);
  EXPECT_LT(outermost(scene, "far", view.look(640, 360)), 1);
}

TEST(ActionView, TakesTheBallInWhereItIsNear) {
  Scene scene(walker());
  scene.simulation().initialize();
  ActionView view(scene);
  view.follow({"one"}, true);
  const sensors::Perspective with_ball = view.look(640, 360);
  EXPECT_LT(outermost(scene, "ball", with_ball), 1);
  view.follow({"far"}, true);
  const auto away = [&](const std::string& name, const sensors::Perspective& from) {
    return norm(from.eye - scene.simulation().world().entity(name).base().get(properties::position));
  };
  EXPECT_LT(away("far", view.look(640, 360)), away("one", with_ball) - 0.1) << "nearer, as it is alone";
}

// Law: a low-pass of first order with 0.35 s: of a jump to what is new, exp(-t/0.35) is left.
TEST(ActionView, PansToWhatIsNewWithoutAJump) {
  Scene scene(walker());
  scene.simulation().initialize();
  ActionView view(scene);
  view.follow({"one"}, true);
  const Vec3d start = view.look(640, 360).eye;
  view.follow({"far"}, false);
  EXPECT_LT(norm(view.look(640, 360).eye - start), 1e-12) << "no time has gone by";
  scene.simulation().run(40ms);
  const double first = norm(view.look(640, 360).eye - start);
  scene.simulation().run(4s);
  const double all = norm(view.look(640, 360).eye - start);
  EXPECT_NEAR(first / all, 1 - std::exp(-0.04 / 0.35), 0.05);
}

TEST(ActionView, NamesWhoIsNotThere) {
  Scene scene(walker());
  scene.simulation().initialize();
  ActionView view(scene);
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { view.follow({"ona"}, true); }), {"ona", "did you mean 'one'?"}));
}

}  // namespace
}  // namespace murosimf::scene
