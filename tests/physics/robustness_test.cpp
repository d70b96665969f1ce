// Numbers that go bad freeze one entity; the others play on. Same seed, same bits.
#include <gtest/gtest.h>

#include <limits>

#include "murosimf/io/scene.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

/// Writes NaN into a joint target after half a second.
class Saboteur final : public Algorithm {
 public:
  explicit Saboteur(Setup& setup) : target_(setup.write(properties::joint_target)) {}
  void initialize() override { std::fill(target_.begin(), target_.end(), 0.0); }
  void step(const Instant& instant) noexcept override {
    if (instant.now >= from_seconds(0.5)) target_[3] = std::numeric_limits<double>::quiet_NaN();
  }

 private:
  std::span<double> target_;
};

TEST(Freezing, BadTargetsFreezeOneRobotOnly) {
  Rig rig;
  Entity& bad = rig.add("bad", kid21());
  Entity& good = rig.add("good", kid21(), {.position = {1, 0, 0}});
  const int joint = kid21()->joints()[0];
  ASSERT_EQ(joint, 3) << "the saboteur's target must be a joint's";
  rig.simulation.attach<Saboteur>("saboteur", bad, 100);
  rig.simulation.attach<control::WalkEngine>("walk_engine", good, 100, Vec3d{0.2, 0, 0});
  rig.attach_dynamics(bad);
  rig.attach_dynamics(good);
  rig.run(3.0);
  EXPECT_TRUE(bad.frozen());
  EXPECT_TRUE(std::isfinite(norm(Rig::place(bad))));
  EXPECT_FALSE(good.frozen());
  EXPECT_GT(Rig::place(good).x, 1.3);
  ASSERT_EQ(rig.simulation.warnings().size(), 1u);
  EXPECT_NE(rig.simulation.warnings()[0].find("'bad' was frozen at 0.50"), std::string::npos)
      << rig.simulation.warnings()[0];
}

TEST(Freezing, BadForcesFreezeTheEntityThatFeelsThem) {
  Rig rig;
  Entity& ball = rig.add("ball", io::ball_model());
  rig.attach_dynamics(ball);
  rig.run(0.1);
  const double infinite = std::numeric_limits<double>::infinity();
  ball.base().set(properties::applied_force, Forced{{}, {infinite, 0, 0}});
  rig.run(0.1);
  EXPECT_TRUE(ball.frozen());
  EXPECT_TRUE(std::isfinite(norm(Rig::place(ball))));
}

std::uint64_t hash_of(int threads, std::uint64_t seed, const std::vector<std::string>& overrides = {}) {
  io::Scene scene(std::string(MUROSIMF_SOURCE_DIR) + "/scenes/three_on_three.toml",
                  {.threads = threads, .seed = seed, .overrides = overrides});
  scene.simulation().run(from_seconds(8.0));
  return scene.simulation().state_hash();
}

// The same scene and seed give the same state, bit for bit, on every run and for any number of threads.
TEST(Determinism, HashDependsOnTheSeedOnly) {
  const std::uint64_t one = hash_of(1, 7);
  EXPECT_EQ(hash_of(1, 7), one);
  EXPECT_EQ(hash_of(2, 7), one);
  EXPECT_EQ(hash_of(3, 7), one);
  EXPECT_NE(hash_of(1, 8), one);
}

// Adding a robot changes nobody else's start: jitter comes from streams named by robot.
TEST(Determinism, StartPlacesDoNotDependOnOtherRobots) {
  const std::string file = std::string(MUROSIMF_SOURCE_DIR) + "/scenes/three_on_three.toml";
  io::Scene all(file);
  const Vec3d before = all.simulation().world().entity("red3").options().position;
  io::Scene renamed(file, {.overrides = {"blue1.name=\"goalie\""}});
  const Vec3d after = renamed.simulation().world().entity("red3").options().position;
  EXPECT_EQ(before.x, after.x);
  EXPECT_EQ(before.y, after.y);
}

}  // namespace
}  // namespace murosimf::test
