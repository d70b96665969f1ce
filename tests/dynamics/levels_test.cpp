// What levels refuse before the first step: one clear line each; and that they start whatever they write.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/articulated_dynamics.h"
#include "murosimf/dynamics/full_dynamics.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/simplified_dynamics.h"
#include "murosimf/runtime/simulation.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using fixtures::says;

/// The message with which a level refuses a model.
template <class Level>
std::string refusal(const Chain& chain) {
  return fixtures::error_of([&] {
    Simulation simulation;
    Entity& robot = simulation.world().add("robot", std::make_shared<const Model>("odd", chain));
    simulation.attach<Level>("level", robot, 1000);
    simulation.initialize();
  });
}

const SymMat3d ball_inertia{1e-3, 1e-3, 1e-3, 0, 0, 0};

TEST(Levels, RefuseAModelWithoutMass) {
  const Chain chain = Chain{}.base("pelvis").revolute("hinge", {0, 1, 0});
  EXPECT_TRUE(says(refusal<SimplifiedDynamics>(chain), {"model 'odd' has no mass", "simplified_dynamics needs it"}));
  EXPECT_TRUE(says(refusal<FullDynamics>(chain), {"model 'odd' has no mass", "full_dynamics needs it"}));
  EXPECT_TRUE(says(refusal<ArticulatedDynamics>(chain), {"model 'odd' has no mass", "articulated_dynamics needs it"}));
}

TEST(Levels, RefuseAModelWithoutInertia) {
  const Chain point = Chain{}.base("pelvis").with(properties::mass, 1.0);
  EXPECT_TRUE(says(refusal<SimplifiedDynamics>(point), {"no inertia about some axis"}));
  EXPECT_TRUE(says(refusal<FullDynamics>(point), {"no inertia about some axis"}));
  EXPECT_TRUE(says(refusal<ArticulatedDynamics>(point), {"no inertia about some axis"}));
}

/// A base with mass, and a hinge that moves nothing.
Chain empty_hinge() {
  return Chain{}
      .base("pelvis")
      .with(properties::mass, 1.0)
      .with(properties::inertia, ball_inertia)
      .revolute("hinge", {0, 1, 0});
}

TEST(ArticulatedLevel, RefusesAJointThatMovesNoInertia) {
  EXPECT_TRUE(says(refusal<ArticulatedDynamics>(empty_hinge()), {"joint 'hinge' moves no inertia", "armature"}));
  EXPECT_EQ(refusal<ArticulatedDynamics>(empty_hinge().with(properties::joint_armature, 0.01)), "no error");
  EXPECT_EQ(refusal<FullDynamics>(empty_hinge()), "no error");
}

TEST(ArticulatedLevel, RefusesABaseThatMovesNoInertia) {
  const Chain chain = Chain{}
                          .base("pelvis")
                          .revolute("hinge", {0, 1, 0})
                          .with(properties::mass, 1.0)
                          .with(properties::inertia, ball_inertia);
  EXPECT_TRUE(says(refusal<ArticulatedDynamics>(chain), {"base 'pelvis'", "give it mass and inertia"}));
}

TEST(ArticulatedLevel, RefusesAnUnknownOrImpossibleServo) {
  const auto with_servo = [](const Servo& servo) {
    return refusal<ArticulatedDynamics>(empty_hinge().with(properties::servo, servo));
  };
  EXPECT_TRUE(says(with_servo({.type = "mx", .law = "dc_moter"}), {"servo 'mx'", "did you mean 'dc_motor'?"}));
  EXPECT_TRUE(says(with_servo({.type = "mx"}), {"servo 'mx'", "positive stall_torque and no_load_speed"}));
}

TEST(Levels, RefuseAnEmptyRange) {
  EXPECT_TRUE(
      says(fixtures::error_of([] {
             Model("odd", Chain{}.base().revolute("hinge", {0, 1, 0}).with(properties::joint_range, {1, -1, 0}));
           }),
           {"joint 'hinge'", "range from 1 to -1 is empty"}));
}

TEST(Levels, RefuseInATakeOverWhatTheyRefuseAtTheStart) {
  test::Rig rig;
  Entity& robot = rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()), {.position = {0, 0, 2}});
  rig.attach_dynamics(robot,
                      {.level = "articulated_dynamics", .law = test::law_named("kelvin_voigt"), .on_ground = false});
  rig.simulation.step();
  catalog::LevelOptions options;
  options.reference.kind = ReferenceKind::linear;
  options.tree.integrator = Integrator::rk4;
  for (const std::string level : {"simplified_dynamics", "full_dynamics"}) {
    EXPECT_TRUE(says(fixtures::error_of([&] { rig.exchange(robot, level, options); }),
                     {"'rk4' needs the joint reference 'filter'"}));
  }
}

TEST(Levels, RefuseStepsOfStagesWhereRatesJump) {
  catalog::LevelOptions options;
  options.reference.kind = ReferenceKind::linear;
  for (const std::string level : {"simplified_dynamics", "full_dynamics"}) {
    test::Rig rig;
    Entity& robot = rig.add("robot", std::make_shared<const Model>(fixtures::two_legged()), {.position = {0, 0, 2}});
    rig.attach_dynamics(robot, {.level = level,
                                .law = test::law_named("kelvin_voigt"),
                                .on_ground = false,
                                .options = options,
                                .tree = {.integrator = Integrator::rk4}});
    EXPECT_TRUE(
        says(fixtures::error_of([&] { rig.simulation.initialize(); }), {"'rk4' needs the joint reference 'filter'"}));
  }
}

/// Whether a level starts without dampings although some stood in the column; nothing else writes them here.
template <class Level>
bool forgets_dampings() {
  Simulation simulation;
  Entity& robot = simulation.world().add("robot", std::make_shared<const Model>(fixtures::two_legged()));
  simulation.attach<Level>("level", robot, 1000);
  Sym6d old;
  old.M = diagonal(5.0);
  auto& dampings = robot.column(properties::external_damping).values;
  std::ranges::fill(dampings, old);
  simulation.initialize();
  return std::ranges::all_of(dampings, [](const Sym6d& damping) { return is_zero(damping); });
}

TEST(Levels, StartWithoutLoads) {
  EXPECT_TRUE(forgets_dampings<SimplifiedDynamics>());
  EXPECT_TRUE(forgets_dampings<FullDynamics>());
  EXPECT_TRUE(forgets_dampings<ArticulatedDynamics>());
}

// Rule: what a level writes, it starts, whatever stands in the columns before; inputs have start values of their own. Not all
// objects have a place or are joints, and not all levels remember the base.
TEST(Levels, StartWhatTheyWrite) {
  const std::set<std::string> of_some{"position", "orientation", "joint_position", "written_position",
                                      "written_velocity"};
  for (const std::string& level : test::all_levels()) {
    test::Rig rig;
    Entity& robot = rig.add("robot", test::kid21());
    rig.attach_motion(robot, {.level = level});
    for (const auto& [name, column] : robot.columns()) {
      for (std::size_t row = 0; row < column->rows(); ++row) {
        for (std::size_t i = 0; i < column->numbers(); ++i) column->set(row, i, std::nan(""));
      }
      column->restart();
    }
    rig.simulation.initialize();
    for (const auto& [name, column] : robot.columns()) {
      if (!of_some.contains(name)) {
        EXPECT_EQ(column->not_finite(), 0U) << level << ": " << name;
      }
    }
  }
}

}  // namespace
}  // namespace murosimf::dynamics
