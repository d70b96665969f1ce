// In whatever way the state of a robot is written, its level continues from there in the next step.
#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/scene/scene_hashes.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;

class WritingState : public testing::TestWithParam<std::string> {
 protected:
  std::string file() {
    return fixtures::write_scene(
        "[defaults]\nmodel = 'kid21'\ncontroller = 'walk'\ncommand = [0.2, 0, 0.1]\nlevel = '" + GetParam() +
        "'\n[[robots]]\nname = 'robot'\n");
  }
};
INSTANTIATE_TEST_SUITE_P(Levels, WritingState,
                         testing::Values("kinematic_walking", "simplified_dynamics", "full_dynamics",
                                         "articulated_dynamics"),
                         [](const auto& test) { return test.param; });

TEST_P(WritingState, ThroughAViewIsAsByName) {
  Scene by_name(file()), by_view(file()), untouched(file());
  for (Scene* scene : {&by_name, &by_view, &untouched}) scene->simulation().run(100ms);
  const ObjectAccess base = by_name.simulation().world().entity("robot").base();
  const Vec3d r = base.get(properties::position), v = base.get(properties::linear_velocity);
  Entity& robot = by_name.simulation().world().entity("robot");
  const int neck = robot.model().joints()[3];
  robot.base().set(properties::position, r + Vec3d{0.25, -0.5, 0.01});
  robot.base().set(properties::linear_velocity, v + Vec3d{0.1, 0.2, 0.3});
  ObjectAccess(robot, neck).set(properties::joint_position, 0.11);
  Entity& other = by_view.simulation().world().entity("robot");
  const ColumnView position = other.view("position"), velocity = other.view("linear_velocity");
  const auto row = [](const Vec3d& p) { return std::array{p.x, p.y, p.z}; };
  for (std::size_t i = 0; i < 3; ++i) {
    position(0, i) = row(r + Vec3d{0.25, -0.5, 0.01})[i];
    velocity(0, i) = row(v + Vec3d{0.1, 0.2, 0.3})[i];
  }
  other.view("joint_position")(static_cast<std::size_t>(neck), 0) = 0.11;
  EXPECT_EQ(difference(go_on(by_name, 50ms), go_on(by_view, 50ms)), "");
  untouched.simulation().run(50ms + 3 * untouched.simulation().tick());
  const Vec3d moved = by_view.simulation().world().entity("robot").base().get(properties::position) -
                      untouched.simulation().world().entity("robot").base().get(properties::position);
  EXPECT_NEAR(moved.x, 0.25, 0.03);
  EXPECT_NEAR(moved.y, -0.5, 0.03);
}

// A view that is only held, or written with what stands there, is no change: not a bit.
TEST_P(WritingState, TheSameIsNoChange) {
  Scene touched(file()), untouched(file());
  for (Scene* scene : {&touched, &untouched}) scene->simulation().run(100ms);
  Entity& robot = touched.simulation().world().entity("robot");
  robot.base().set(properties::position, robot.base().get(properties::position));
  const ColumnView rates = robot.view("joint_velocity");
  for (std::size_t i = 0; i < rates.rows(); ++i) rates(i, 0) = +rates(i, 0);
  EXPECT_EQ(difference(go_on(touched, 50ms), go_on(untouched, 50ms)), "");
}

}  // namespace
}  // namespace murosimf::scene
