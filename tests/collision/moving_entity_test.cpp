// What contact between bodies does to entities besides their level: pushes on those that stand, ways apart, laws exchanged.
#include "murosimf/collision/moving_entity.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"

#include <gtest/gtest.h>

#include "tests/collision/movers.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::collision {
namespace {

using test::g;
using test::Rig;

Vec3d ground_force(Entity& entity) {
  Vec3d sum;
  for (const ContactPoint& c : entity.find(contacts)->values[0].points) sum += c.force;
  return sum;
}

// A ball lies on a box that stands under a law of its own: the ground carries both, whatever law is between them.
TEST(MovingEntity, PushGoesThroughToTheGround) {
  for (const std::string law : {"kelvin_voigt", "carry"}) {
    for (const std::string ground : {"implicit_stick", "kelvin_voigt"}) {
      if (law == "carry" && ground == "kelvin_voigt") continue;  // damping that this one cannot answer
      Rig rig;
      rig.materials = MaterialTable::standard();
      Entity& box = rig.add("box", test::box_model({"plastic"}));
      Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = {0.02, 0.01, 0.1}});
      const test::Dynamics dynamics{.law = test::law_named(ground)};
      rig.attach_together({{&box, dynamics}, {&ball, dynamics}}, law);
      rig.run(2.5);
      double sum = 0, felt = 0;
      for (int i = 0; i < 500; ++i) {
        rig.simulation.step();
        sum += ground_force(box).z / 500;
        felt += box.base().get(properties::external_force).f.z / 500;
      }
      const double weight = g * (4.3 + ball.base().get(properties::total_mass));
      EXPECT_NEAR(sum, weight, 2e-3 * weight) << ground;
      EXPECT_NEAR(felt, 4.3 * g, 2e-3 * weight) << "ground and ball together carry the box alone";
    }
  }
}

// What was pushed in a step is not pushed in the next one: of its own body, and of the loads only where no ground begins them anew.
TEST(MovingEntity, APushLastsForOneStep) {
  for (const bool on_ground : {false, true}) {
    Movers movers;
    MovingEntity& robot = movers.add("robot", std::make_shared<const Model>(fixtures::two_legged()), {0.5, -0.3, 1});
    const Request law(IslandUse::never);
    if (on_ground) robot.interface.law = &law;
    const int foot = robot.model().object_index("left_foot"), knee = robot.model().object_index("left_knee");
    robot.external_force[knee] = {{1, 2, 3}, {4, 5, 6}};
    const Vec3d arm{0.1, 0.2, 0.3}, force{3, -1, 2};
    robot.push(foot, robot.r[foot] + arm, force, 1e-3);
    robot.push(foot, robot.r[foot] + arm, force, 1e-3);
    robot.damp(foot, robot.r[foot], diagonal(7.0));
    for (const auto& felt : {robot.interaction_force, robot.external_force}) {
      EXPECT_LT(fixtures::difference(felt[foot].f, 2 * force), 1e-12);
      EXPECT_LT(fixtures::difference(felt[foot].n, 2 * cross(arm, force)), 1e-12);
    }
    EXPECT_EQ(norm(robot.contacts.rest_force[foot].f), on_ground ? 2 * norm(force) : 0);
    EXPECT_EQ(robot.contacts.rest_damping.size(), on_ground ? 1U : 0U);
    robot.start_step();
    EXPECT_EQ(norm(robot.interaction_force[foot].f), 0);
    EXPECT_EQ(norm(robot.external_force[foot].f) > 0, on_ground) << "the ground begins it anew";
    EXPECT_EQ(robot.external_damping[foot].M.xx > 0, on_ground);
    EXPECT_EQ(robot.external_force[knee].f.x, 4) << "no push there";
    robot.external_force[foot].f = {1, 0, 0};
    robot.start_step();
    EXPECT_EQ(robot.external_force[foot].f.x, 1);
  }
}

// Rule: where a shape is, is worked out once in a step.
TEST(MovingEntity, PosesAreThoseOfTheFirstAsking) {
  Movers movers;
  MovingEntity& mover = movers.add("ball", ball(0.1, 1, {}, {0.02, 0, 0}), {1, 2, 3});
  mover.start_step();
  EXPECT_LT(fixtures::difference(mover.pose(0).position, {1.02, 2, 3}), 1e-12);
  Movers::place(mover, {4, 5, 6}, rotation_z(pi / 2));
  EXPECT_LT(fixtures::difference(mover.pose(0).position, {1.02, 2, 3}), 1e-12);
  mover.start_step();
  EXPECT_LT(fixtures::difference(mover.pose(0).position, {4, 5.02, 6}), 1e-12);
  EXPECT_LT(fixtures::difference(mover.sphere(0).center, {4, 5.02, 6}), 1e-12);
}

/// Two robots at kinematic_walking beside each other, whose feet overlap by `overlap` [m] along y.
struct Neighbors {
  explicit Neighbors(double overlap) {
    const auto model = std::make_shared<const Model>(fixtures::two_legged());
    // the left foot of `a` goes to y = 0.08, the right one of `b` from its own -0.08 on
    a = &rig.add("a", model);
    b = &rig.add("b", model, {.position = {0.01, 0.16 - overlap, 0}});
    rig.attach_together({{a, {.level = "kinematic_walking"}}, {b, {.level = "kinematic_walking"}}});
    rig.simulation.initialize();
  }
  [[nodiscard]] static Vec3d separation(Entity* entity) { return entity->base().get(properties::separation); }
  Rig rig;
  Entity *a = nullptr, *b = nullptr;
};

// Rule: each goes half of the way, along the ground, and at most 1 mm in a step.
TEST(KeepApart, EachGoesHalfOfTheWay) {
  for (const double overlap : {0.4e-3, 1.2e-3, 5e-3}) {
    Neighbors neighbors(overlap);
    neighbors.rig.simulation.step();
    const double way = std::min(0.5 * overlap, 1e-3);
    EXPECT_LT(fixtures::difference(Neighbors::separation(neighbors.a), {0, -way, 0}), 1e-9) << overlap;
    EXPECT_LT(fixtures::difference(Neighbors::separation(neighbors.b), {0, way, 0}), 1e-9) << overlap;
  }
}

TEST(KeepApart, AfterwardsNobodyGoesOn) {
  Neighbors neighbors(3e-3);
  const Vec3d a = Rig::place(*neighbors.a), b = Rig::place(*neighbors.b);
  neighbors.rig.run(0.2);
  EXPECT_NEAR(Rig::place(*neighbors.a).y, a.y - 1.5e-3, 1e-6);
  EXPECT_NEAR(Rig::place(*neighbors.b).y, b.y + 1.5e-3, 1e-6);
  EXPECT_EQ(norm(Neighbors::separation(neighbors.a)), 0);
}

// Laws that settle the whole step share their memory; what a law that does not would make of it is another thing.
TEST(GroundContactExchange, MemoryStaysBetweenLawsThatShareIt) {
  const auto points_after = [](const std::string& first, const std::string& second) {
    Rig rig(0.8, 5 * test::degree);
    Entity& box = rig.add("box", test::box_model());
    auto& contact = rig.simulation.attach<GroundContact>("ground_contact", box, 1000, rig.ground,
                                                         test::law_named(first), rig.materials);
    rig.simulation.attach<BodyContact>("body_contact", 1000, rig.ground, std::vector<Entity*>{&box}, rig.materials,
                                       test::body_law_named("island_gauss_seidel"));
    rig.simulation.attach<dynamics::SimplifiedDynamics>("simplified_dynamics", box, 1000);
    rig.run(0.5);
    EXPECT_EQ(box.find(contacts)->values[0].points.size(), 4U);
    contact.exchange_law(test::law_named(second));
    return box.find(contacts)->values[0].points;
  };
  EXPECT_TRUE(points_after("implicit_stick", "kelvin_voigt").empty());
  EXPECT_TRUE(points_after("kelvin_voigt", "implicit_stick").empty());
  EXPECT_TRUE(points_after("kelvin_voigt", "paper").empty());
  for (const auto& [first, second] :
       {std::pair{"implicit_stick", "island_gauss_seidel"}, {"island_gauss_seidel", "implicit_stick"}}) {
    const auto points = points_after(first, second);
    ASSERT_EQ(points.size(), 4U) << first;
    for (const ContactPoint& point : points) EXPECT_GT(norm(point.stretch), 1e-7) << "it leans on its springs";
  }
}

}  // namespace
}  // namespace murosimf::collision
