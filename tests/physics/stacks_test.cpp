// What stands on a box stands still, as high as its shape says, and its weight goes through to the ground.
#include <gtest/gtest.h>

#include "murosimf/collision/touches.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/geometry/hull.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

constexpr double least = 1e-5;      // [m] mean overlap of two bodies that carry weight, below which nothing was carried
constexpr double deepest = 0.4e-3;  // [m] three boxes on the lowest one: 0.1 mm each, and what sweeps leave
constexpr double box_height = 0.1;

/// A body of 1 kg and 0.1 m height.
ModelPtr solid(const Shape& shape) {
  PlacedShape placed;
  placed.shape = shape;
  return std::make_shared<const Model>("solid", Chain{}
                                                    .base("solid")
                                                    .with(properties::mass, 1)
                                                    .with(properties::inertia, diagonal(2e-3))
                                                    .with(properties::shapes, {placed}));
}

/// A frustum of six sides.
Shape frustum() {
  std::vector<Vec3d> points;
  for (int i = 0; i < 6; ++i) {
    const Vec3d out = rotation_z(i * pi / 3).x;
    points.push_back(0.06 * out - Vec3d{0, 0, 0.05});
    points.push_back(0.03 * out + Vec3d{0, 0, 0.05});
  }
  return Convex{std::make_shared<const ConvexHull>(geometry::make_hull(points).hull)};
}

/// Things one on top of the other, the lowest on the ground.
struct Stack {
  Stack(const std::string& level, double rate_hz, const std::vector<ModelPtr>& models, double slope = 0,
        double offset = 0.005)
      : rig(0.8, slope, rate_hz) {
    std::vector<Rig::Together> all;
    for (std::size_t i = 0; i < models.size(); ++i) {
      Entity& entity = rig.add("part" + std::to_string(i), models[i],
                               {.position = {offset * static_cast<double>(i), 0, box_height * static_cast<double>(i)}});
      parts.push_back(&entity);
      all.push_back({&entity, {.level = level}});
    }
    rig.attach_together(all);
  }
  double ground_force() {
    double sum = 0;
    for (const auto& touch : collision::touches(rig.simulation.world(), *parts[0])) {
      if (touch.other == rig.ground) sum += touch.force.z;
    }
    return sum;
  }
  /// Largest speed [m/s] of a base in the next `seconds`.
  law::Worst largest_speed(double seconds) {
    law::Worst speed;
    for (int i = 0; i < std::lround(rig.rate * seconds); ++i) {
      rig.simulation.step();
      for (Entity* part : parts) speed.see(norm(Rig::velocity(*part)), part->name());
    }
    return speed;
  }
  double weight() {
    double sum = 0;
    for (Entity* part : parts) sum += g * part->base().get(properties::total_mass);
    return sum;
  }
  Rig rig;
  std::vector<Entity*> parts;
};

/// A level and a rate [Hz].
using LevelAndRate = std::tuple<std::string, int>;

class Stacks : public testing::TestWithParam<LevelAndRate> {
 protected:
  static std::string words(const std::string& what) {
    return fmt::format("{}, {} ms, {}", std::get<0>(GetParam()), 1000 / std::get<1>(GetParam()), what);
  }
  static void expect_at_rest(Stack& stack, const std::string& what) {
    stack.rig.run(4);
    law::expect_below({.law = "stack: largest speed after 4 s", .level = words(what), .source = "it rests"},
                      stack.largest_speed(1), 1e-6, "m/s");
    law::expect_near({.law = "stack: force of the ground on the lowest", .level = words(what), .source = "all weight"},
                     stack.ground_force(), stack.weight(), 1e-4 * stack.weight(), "N");
    law::Worst sunk, risen;
    for (std::size_t i = 0; i < stack.parts.size(); ++i) {
      const double height = box_height * (static_cast<double>(i) + 0.5);
      const double depth = (height - Rig::place(*stack.parts[i]).z) / static_cast<double>(i + 1);
      sunk.see(depth, "part", i);
      risen.see(-depth, "part", i);
    }
    law::expect_below({.law = "stack: how deep its parts have sunk, per contact below",
                       .level = words(what),
                       .source = "0.1 mm under one weight, three on the lowest"},
                      sunk, deepest, "m");
    EXPECT_LT(law::Measured(risen).value, -least);
  }
};

TEST_P(Stacks, OfThreeBoxesRest) {
  const auto& [level, rate] = GetParam();
  Stack stack(level, rate, {box_model(), box_model(), box_model()});
  expect_at_rest(stack, "three boxes");
}

TEST_P(Stacks, CarryACylinderAndAHull) {
  const auto& [level, rate] = GetParam();
  Stack cylinder(level, rate, {box_model(), solid(Cylinder{0.05, 0.05})});
  expect_at_rest(cylinder, "cylinder on a box");
  Stack hull(level, rate, {box_model(), solid(frustum())});
  expect_at_rest(hull, "hull on a box");
}

// Friction remembers its contacts from step to step by their features: nothing creeps.
TEST_P(Stacks, DoNotCreepOnASlope) {
  const auto& [level, rate] = GetParam();
  for (const auto& [top, what] : std::vector<std::pair<ModelPtr, std::string>>{
           {box_model(), "box"}, {solid(Cylinder{0.05, 0.05}), "cylinder"}, {solid(frustum()), "hull"}}) {
    Stack stack(level, rate, {box_model(), top}, 3 * degree);
    stack.rig.run(2);
    const Vec3d before = Rig::place(*stack.parts[1]);
    stack.rig.run(2);
    law::expect_below({.law = "stack on a slope of 3 degrees: mean speed of the upper part",
                       .level = words(what),
                       .source = "friction holds: none"},
                      norm(Rig::place(*stack.parts[1]) - before) / 2, 1e-5, "m/s");
  }
}

/// A cube of 0.1 m.
ModelPtr cube(double mass) {
  PlacedShape placed;
  placed.shape = Box{{0.05, 0.05, 0.05}};
  return std::make_shared<const Model>("cube", Chain{}
                                                   .base("cube")
                                                   .with(properties::mass, mass)
                                                   .with(properties::inertia, diagonal(mass * 0.01 / 6))
                                                   .with(properties::shapes, {placed}));
}

/// How far [m] the top of the stack has come from where it was put, in any direction.
double drift_of_top(Stack& stack, double seconds) {
  stack.rig.simulation.initialize();
  const Vec3d before = Rig::place(*stack.parts.back());
  stack.rig.run(seconds);
  return norm(Rig::place(*stack.parts.back()) - before);
}

// Greenhill's column (contact_parameters.h) stands up to 11 cubes with springs that the weight of one presses by 0.1 mm, whatever the
// step. Tolerance: a tenth of an edge, two more in long steps, where sweeps end before the column does not sway any more; the one that buckled lay 1 m away.
TEST(TallStacks, OfTenCubesStandAMinute) {
  for (const int rate : {1000, 500, 200, 100}) {
    Stack stack("simplified_dynamics", rate, std::vector<ModelPtr>(10, cube(1)), 0, 0);
    const double seconds = rate == 100 ? 20 : 60;
    law::expect_below({.law = fmt::format("stack of ten cubes: way of the topmost in {:g} s", seconds),
                       .level = fmt::format("simplified_dynamics, {} ms", 1000 / rate),
                       .source = "its springs are stiffer than those that buckle"},
                      drift_of_top(stack, seconds), rate <= 200 ? 0.03 : 0.01, "m");
  }
}

// The same at every step: with springs of m / dt^2 neither stood at 5 ms. Tolerance: what the sweeps leave.
TEST(TallStacks, LightCubeCarriesAHeavyOne) {
  for (const int ms : {1, 2, 5, 10}) {
    const double mass = 30, between = 0.1e-3;   // [kg], [m] deflection: under the weight of the heavy one
    const double below = between * (1 + mass);  // the light one's springs: its own weight presses them by as much
    Stack stack("simplified_dynamics", 1000.0 / ms, {cube(1), cube(mass)}, 0, 0);
    law::expect_near({.law = fmt::format("cube of {} kg on one of 1 kg: how far it has sunk in 10 s", mass),
                      .level = fmt::format("simplified_dynamics, {} ms", ms),
                      .source = "its weight on both springs"},
                     drift_of_top(stack, 10), below + between, 0.05 * below, "m");
  }
}

// Long steps damp it more. Tolerance: a tenth.
TEST(Rebound, OfABoxIsThatOfACriticallyDampedSpring) {
  for (const double rate : {4000.0, 1000.0, 200.0}) {
    Rig rig(0.8, 0, rate);
    Entity& box = rig.add("box", cube(1), {.position = {0, 0, 1}});
    rig.attach_dynamics(box, {.level = "simplified_dynamics"});
    rig.run(0.47);
    double highest = 0;
    for (int i = 0; i < std::lround(0.3 * rate); ++i) {
      rig.simulation.step();
      if (Rig::velocity(box).z > 0) highest = std::max(highest, Rig::place(box).z - 0.05);
    }
    law::expect_below({.law = fmt::format("box falls flat from 1 m, {} Hz: how high it rises", rate),
                       .level = "simplified_dynamics",
                       .source = "critically damped spring that cannot pull: e = exp(-2), e^2 h"},
                      highest, std::exp(-4.0) * 1.1, "m");
  }
}

// Tolerance: as above, and what its pelvis goes down on its servos is seen without a crate, too.
TEST(TallStacks, ALightCrateCarriesARobot) {
  const auto pelvis = [](const std::vector<ModelPtr>& below) {
    Rig rig(0.8, 0, 1000);
    std::vector<Rig::Together> all;
    for (const ModelPtr& model : below) all.push_back({&rig.add("crate", model), {.level = "simplified_dynamics"}});
    const double height = below.empty() ? 0 : 0.1;
    Entity& robot = rig.add("robot", kid21(), {.position = {0, 0, height}});
    all.push_back({&robot, {.level = "articulated_dynamics"}});
    rig.attach_together(all);
    rig.run(3);
    return Rig::place(robot).z - height;
  };
  PlacedShape placed;
  placed.shape = Box{{0.2, 0.2, 0.05}};
  const auto crate = std::make_shared<const Model>("crate", Chain{}
                                                                .base("crate")
                                                                .with(properties::mass, 0.1)
                                                                .with(properties::inertia, diagonal(1.5e-3))
                                                                .with(properties::shapes, {placed}));
  law::expect_near({.law = "kid21 on a crate of 100 g: its pelvis above the crate, less the same on the ground",
                    .level = "articulated_dynamics, 1 ms",
                    .source = "0.1 mm at each of two faces at most"},
                   pelvis({crate}) - pelvis({}), 0, 1e-3, "m");
}

INSTANTIATE_TEST_SUITE_P(Bodies, Stacks,
                         testing::Combine(testing::ValuesIn(dynamic_levels()), testing::Values(1000, 500, 200)),
                         [](const auto& test) {
                           return fmt::format("{}_{}Hz", std::get<0>(test.param), std::get<1>(test.param));
                         });

}  // namespace
}  // namespace murosimf::test
