// scenes/heap.toml: 22 robots fall over one spot, come to rest, and stay where they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/scene/scene.h"
#include "tests/law.h"
#include "tests/physics/mechanics.h"
#include "tests/sanitizer.h"

namespace murosimf::test {
namespace {

/// A level and a rate [Hz].
using LevelAndRate = std::tuple<std::string, int>;

class Heap {
 public:
  explicit Heap(const std::string& level, int rate, const std::vector<std::string>& more = {})
      : scene_("heap", {.overrides = overrides(level, rate, more)}) {
    scene_.simulation().initialize();
    World& world = scene_.simulation().world();
    for (const auto& entity : world.entities()) {
      if (entity->name() != "field") robots_.push_back(entity.get());
    }
    pairs_ = &world.common().find(collision::pair_contacts)->values[0];
  }

  void run(double s) { scene_.simulation().run(from_seconds(s)); }
  void step() { scene_.simulation().step(); }
  [[nodiscard]] double time() { return seconds(scene_.simulation().now()); }

  /// [m/s] of the fastest limb.
  double speed() {
    double fastest = 0;
    for (Entity* robot : robots_) {
      for (const MovingBody& body : moving_bodies(*robot)) fastest = std::max(fastest, norm(body.velocity));
    }
    return fastest;
  }
  /// [m] of the contacts between robots, the smallest first.
  [[nodiscard]] std::vector<double> depths() const {
    std::vector<double> result;
    for (const auto& c : pairs_->points) result.push_back(c.depth);
    std::sort(result.begin(), result.end());
    return result;
  }
  /// [J] of motion and height, and what springs of contacts and servos hold.
  double energy() {
    double sum = stored(pairs_->points, pairs_->parameters);
    for (Entity* robot : robots_) {
      const double height = robot->base().get(properties::common_center_of_mass).z;
      sum += kinetic_energy(*robot) + robot->base().get(properties::total_mass) * 9.81 * height;
      const auto& ground = robot->find(collision::contacts)->values[0];
      sum += stored(ground.points, robot->find(collision::contact_interface)->values[0].terms.parameters) +
             wound_up(*robot);
    }
    return sum;
  }
  [[nodiscard]] bool all_play() const {
    return std::none_of(robots_.begin(), robots_.end(), [](const Entity* robot) { return robot->frozen(); });
  }

 private:
  static std::vector<std::string> overrides(const std::string& level, int rate, std::vector<std::string> more) {
    more.insert(more.end(), {"r*.level=" + level, fmt::format("rate={}", rate)});
    return more;
  }
  template <class Points>
  static double stored(const Points& points, const std::vector<collision::ContactParameters>& parameters) {
    double sum = 0;
    for (const auto& c : points) {
      const auto& p = parameters[c.surface];
      sum += 0.5 * p.stiffness * c.depth * c.depth + 0.5 * p.tangent_stiffness * dot(c.stretch, c.stretch);
    }
    return sum;
  }
  static double wound_up(Entity& robot) {
    const auto* position = robot.find(properties::joint_position);
    const auto* target = robot.find(properties::joint_target);
    double sum = 0;
    for (const int joint : robot.model().joints()) {
      const double bend = position->values[joint] - target->values[joint];
      sum += 0.5 * robot.model().find(properties::servo, joint)->position_gain * bend * bend;
    }
    return sum;
  }

  scene::Scene scene_;
  std::vector<Entity*> robots_;
  const collision::PairSet* pairs_ = nullptr;
};

class HeapOfRobots : public testing::TestWithParam<LevelAndRate> {};

TEST_P(HeapOfRobots, ComesToRest) {
  const auto& [level, rate] = GetParam();
  // sanitizers make a heap thirty times slower; the longest step then stands for all
  if (fixtures::sanitized && (rate != 200 || level != "articulated_dynamics"))
    GTEST_SKIP() << "too slow under a sanitizer";
  const std::string words = fmt::format("{}, {} Hz", level, rate);
  Heap heap(level, rate);
  heap.run(10);
  law::expect_below({.law = "heap of 22 robots: speed of the fastest limb after 10 s",
                     .level = words,
                     .source = "it lies"},
                    heap.speed(), 1e-3, "m/s");
  const auto depths = heap.depths();
  ASSERT_GT(depths.size(), 20u) << "that is no heap";
  EXPECT_TRUE(heap.all_play());
  if (rate != 1000) return;  // with longer steps limbs meet deeper, and some stay hooked
  law::expect_below({.law = "heap of 22 robots: median depth of contacts between robots",
                     .level = words,
                     .source = "stiffness chosen by weight"},
                    depths[depths.size() / 2], 1e-3, "m");
  law::expect_below({.law = "heap of 22 robots: deepest contact between robots",
                     .level = words,
                     .source = "no limb is stuck in another"},
                    depths.back(), 8e-3, "m");
}

INSTANTIATE_TEST_SUITE_P(
    Levels, HeapOfRobots,
    testing::Values(LevelAndRate{"articulated_dynamics", 1000}, LevelAndRate{"articulated_dynamics", 500},
                    LevelAndRate{"articulated_dynamics", 200}, LevelAndRate{"simplified_dynamics", 1000},
                    LevelAndRate{"simplified_dynamics", 500}, LevelAndRate{"simplified_dynamics", 200}),
    [](const auto& test) { return fmt::format("{}_{}Hz", std::get<0>(test.param), std::get<1>(test.param)); });

// Springs give back what they took, and no more; dampers and friction only take.
TEST(HeapOfRobots, NeverGainsEnergy) {
  if (fixtures::sanitized) GTEST_SKIP() << "too slow under a sanitizer";
  Heap heap("articulated_dynamics", 1000);
  double least = heap.energy();
  law::Worst rise;
  while (heap.time() < 4) {
    for (int i = 0; i < 10; ++i) heap.step();
    const double energy = heap.energy();
    rise.see(energy - least, "time", heap.time());
    least = std::min(least, energy);
  }
  law::expect_below({.law = "heap of 22 robots: largest rise of the energy, springs included",
                     .level = "articulated_dynamics, 1000 Hz",
                     .source = "contacts and servos at rest do no work"},
                    rise, 0.1, "J");
}

// With the paper's laws on the ground and between robots. By the letter, friction that is stronger than what stops a limb
// within a step turns it back faster than it came: all robots froze in the first second.
TEST(HeapOfRobots, StaysInTheGameUnderThePapersLaws) {
  if (fixtures::sanitized) GTEST_SKIP() << "too slow under a sanitizer";
  for (const char* law : {"paper", "paper_multipoint"}) {
    const std::vector<std::string> laws{fmt::format("defaults.contact={}", law), fmt::format("body_contact={}", law)};
    Heap heap("articulated_dynamics", 1000, laws);
    heap.run(2);
    EXPECT_TRUE(heap.all_play()) << law;
    law::expect_below({.law = "heap of 22 robots falls: speed of the fastest limb after 2 s",
                       .level = fmt::format("articulated_dynamics, {}, 1000 Hz", law),
                       .source = "below a free fall from 3 m"},
                      heap.speed(), 7.7, "m/s");
    std::vector<std::string> literal = laws;
    literal.insert(literal.end(), {"defaults.contact_options.bounded=false", "body_contact_options.bounded=false"});
    Heap letter("articulated_dynamics", 1000, literal);
    letter.run(1);
    EXPECT_FALSE(letter.all_play()) << law;
  }
}

// What contacts are found does not depend on the kind of bounding volume.
TEST(HeapOfRobots, IsTheSameForAllVolumes) {
  if (fixtures::sanitized) GTEST_SKIP() << "too slow under a sanitizer";
  std::vector<std::vector<double>> depths;
  for (const char* volume : {"sphere", "aabb", "obb", "capsule"}) {
    Heap heap("simplified_dynamics", 500, {fmt::format("r*.volume={}", volume)});
    heap.run(1.5);
    depths.push_back(heap.depths());
    EXPECT_EQ(depths.back(), depths.front()) << volume;
  }
  EXPECT_GT(depths.front().size(), 10u);
}

}  // namespace
}  // namespace murosimf::test
