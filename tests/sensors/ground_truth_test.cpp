// Ground truth shows true poses and velocities at the instant of its time stamp.
#include "murosimf/sensors/ground_truth.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::sensors {
namespace {

/// Control software that only looks.
class Observer final : public Algorithm {
 public:
  explicit Observer(Setup& setup) : sightings_(setup) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void step(const Instant&) noexcept override { seen = sightings_.look(); }
  std::vector<Sighting> seen;

 private:
  Sightings sightings_;
};

TEST(GroundTruth, ShowsWhereEverybodyIs) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21(), {.position = {1, 2, 0}, .heading = 0.5, .team = "blue"});
  Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = {0, 0, 1}});
  rig.simulation.attach<GroundTruth>("ground_truth", robot, 100, SensorSpec{.name = "ground_truth"},
                                     SensorSurroundings{.moving_entities = {&robot, &ball}});
  auto& observer = rig.simulation.attach<Observer>("observer", robot, 100);
  rig.simulation.attach<dynamics::KinematicWalking>("kinematic_walking", robot, 1000);
  rig.attach_dynamics(ball, {.on_ground = false});
  rig.run(0.1);
  const Vec3d place = test::Rig::place(ball);  // at 0.1 s, when the next sample is due
  rig.simulation.step();
  EXPECT_EQ(find_reading(robot, "ground_truth")->time, from_seconds(0.1));
  ASSERT_EQ(observer.seen.size(), 2u);
  EXPECT_TRUE(observer.seen[0].self);
  EXPECT_EQ(observer.seen[0].team, "blue");
  EXPECT_NEAR(observer.seen[0].heading, 0.5, 1e-9);
  EXPECT_NEAR(observer.seen[0].position.x, 1, 1e-9);
  EXPECT_FALSE(observer.seen[1].self);
  EXPECT_EQ(observer.seen[1].name, "ball");
  EXPECT_EQ(observer.seen[1].position.z, place.z);
  EXPECT_NEAR(observer.seen[1].velocity.z, -test::g * 0.1, 1e-9);
}

TEST(GroundTruth, NamesEntitiesThatThereAreNoneOf) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21());
  const SensorSpec spec{.name = "truth", .objects = {"robbot"}};
  const auto attach = [&] {
    rig.simulation.attach<GroundTruth>("truth", robot, 100, spec, SensorSurroundings{.moving_entities = {&robot}});
  };
  EXPECT_EQ(fixtures::error_of(attach), "unknown entity 'robbot'; did you mean 'robot'?");
}

}  // namespace
}  // namespace murosimf::sensors
