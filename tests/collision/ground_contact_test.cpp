// One entity on its ground, without a level: velocities of points, loads, memory, pushes of users, hands off.
#include "murosimf/collision/ground_contact.h"

#include <chrono>

#include <gtest/gtest.h>

#include "murosimf/collision/contact_laws/contact_parameters.h"
#include "murosimf/collision/contact_laws/implicit_stick_law.h"
#include "murosimf/collision/contact_laws/kelvin_voigt_law.h"
#include "tests/collision/movers.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;
using fixtures::placed;

/// Two plates on legs of one body each, 0.4 m apart along y, that stand on their corners; the trunk between has no shape.
ModelPtr two_plates() {
  const auto leg = [](const std::string& name, double y) {
    return Chain{}
        .translation({0, y, 0})
        .revolute(name, {1, 0, 0})
        .with(properties::mass, 0.5)
        .with(properties::inertia, diagonal(1e-3))
        .with(properties::shapes, Shapes{placed(Box{{0.1, 0.05, 0.02}}, {0, 0, -0.3})});
  };
  return std::make_shared<const Model>("plates", Chain{}
                                                     .base("trunk")
                                                     .with(properties::mass, 1.0)
                                                     .with(properties::inertia, diagonal(1e-2))
                                                     .fork(leg("left", 0.2), leg("right", -0.2)));
}

/// An entity whose columns the test moves, above a plane and, 5 m away, a step of 0.1 m.
struct Standing {
  explicit Standing(std::shared_ptr<const ContactLaw> law = std::make_shared<ImplicitStick>(), double grain = 0) {
    PlacedShape plane = placed(Plane{}, {}, rotation_z(pi / 2));
    plane.surface = {"carpet", 0.8, {0, -3, 1}};
    materials.set("carpet", "", {.friction = 0.6, .friction_anisotropy = grain, .rolling_anisotropy = 2 * grain});
    field = &world.add("field", std::make_shared<const Model>("field", Chain{}
                                                                           .base("ground")
                                                                           .with(properties::shapes, Shapes{plane})
                                                                           .translation({5, 0, 0.05}, "step")
                                                                           .with(properties::shapes,
                                                                                 Shapes{placed(Box{{1, 1, 0.05}})})));
    entity = &world.add("plates", two_plates());
    Setup setup(world, *entity, access);
    contact = std::make_unique<GroundContact>(setup, field, std::move(law), materials);
    for (std::size_t i = 0; i < rows(); ++i) {
      velocity()[i] = turning()[i] = {};
      push()[i] = {};
      force()[i] = {{9, 9, 9}, {9, 9, 9}};
      damping()[i].J = diagonal(9.0);
    }
    lift(1);
    contact->initialize();
  }
  [[nodiscard]] std::size_t rows() const { return static_cast<std::size_t>(entity->model().size()); }
  std::vector<Vec3d>& velocity() { return entity->column(properties::linear_velocity).values; }
  std::vector<Vec3d>& turning() { return entity->column(properties::angular_velocity).values; }
  std::vector<Wrenchd>& push() { return entity->column(properties::applied_force).values; }
  std::vector<Wrenchd>& force() { return entity->column(properties::external_force).values; }
  std::vector<Sym6d>& damping() { return entity->column(properties::external_damping).values; }
  ContactSet& set() { return entity->column(contacts).values[0]; }
  ContactInterface& interface() { return entity->column(contact_interface).values[0]; }
  [[nodiscard]] int body(const char* name) const { return entity->model().object_index(name); }

  /// The plates' lower sides at height z [m], rolled by `roll` [rad].
  void lift(double z, double roll = 0, double x = 0) {
    auto& r = entity->column(properties::position).values;
    auto& R = entity->column(properties::orientation).values;
    r[0] = {x, 0, z + 0.32};
    R[0] = rotation_x(roll);
    const std::vector<double> q(rows());
    multibody::poses<double>(entity->model().tree(), q, std::span<Vec3d>(r), std::span<Mat3d>(R));
  }
  void step() { contact->step({{}, std::chrono::milliseconds(1)}); }

  World world;
  AccessSet access;
  MaterialTable materials;
  Entity *field = nullptr, *entity = nullptr;
  std::unique_ptr<GroundContact> contact;
};

TEST(GroundContact, BeginsWithNothing) {
  Standing standing;
  EXPECT_EQ(standing.set().environment, 0);
  EXPECT_EQ(standing.set().rest_force.size(), standing.rows());
  EXPECT_EQ(standing.interface().terms.dt, 1e-3);
  EXPECT_NE(standing.interface().law, nullptr);
  for (const Wrenchd& force : standing.force()) EXPECT_EQ(norm(force.f) + norm(force.n), 0);
  for (const Sym6d& damping : standing.damping()) EXPECT_EQ(damping.J.xx, 0);
}

// Constants and bodies of the environment, by surface: first the plane's, then the step's. Both plates have the same.
TEST(GroundContact, KnowsEveryPairOfSurfaces) {
  Standing standing(std::make_shared<ImplicitStick>(), 0.25);
  const auto& parameters = standing.interface().terms.parameters;
  ASSERT_EQ(parameters.size(), 2U);
  EXPECT_EQ(standing.set().environment_objects, (std::vector<int>{0, standing.field->model().object_index("step")}));
  EXPECT_EQ(parameters[0].friction, 0.6);
  EXPECT_EQ(parameters[1].friction, 0.8);
  EXPECT_LT(difference(parameters[0].friction_direction, {0.25, 0, 0}), 1e-12) << "turned with the plane, in it, unit";
  EXPECT_LT(difference(parameters[0].rolling_direction, {0.5, 0, 0}), 1e-12);
  EXPECT_EQ(norm(parameters[1].friction_direction) + norm(parameters[1].rolling_direction), 0);
  const PairSurface pair = standing.materials.find({"carpet"}, {});
  // no level, so joints do not give way
  EXPECT_EQ(parameters[0].stiffness,
            contact_parameters(standing.entity->model(), pair, {.implicit_law = false}).stiffness);
}

// Velocity is that of the material point, also where a body turns.
TEST(GroundContact, PointsMoveWithTheirBody) {
  Standing standing;
  standing.lift(-1e-3);
  const int left = standing.body("left"), right = standing.body("right");
  standing.velocity()[left] = {0.1, 0.2, -0.3};
  standing.turning()[left] = {1, -2, 3};
  standing.velocity()[right] = {0.5, 0, 0};
  standing.step();
  const ContactSet& set = standing.set();
  ASSERT_EQ(set.points.size(), 8U);
  for (const ContactPoint& c : set.points) {
    const bool is_left = c.object == left;
    EXPECT_EQ(c.point.y > 0, is_left);
    const Vec3d arm = c.point - Vec3d{0, is_left ? 0.2 : -0.2, 0.319};
    EXPECT_LT(difference(c.velocity, is_left ? Vec3d{0.1, 0.2, -0.3} + cross(Vec3d{1, -2, 3}, arm) : Vec3d{0.5, 0, 0}),
              1e-12);
    EXPECT_EQ(difference(c.angular_velocity, is_left ? Vec3d{1, -2, 3} : Vec3d{}), 0);
    EXPECT_NEAR(c.depth, 1e-3, 1e-12);
  }
  EXPECT_EQ(set.loaded, (std::vector<int>{left, right})) << "each body once";
  standing.step();
  EXPECT_EQ(set.tests.volumes, 2) << "no repeated test whether the step is near";
}

// What users push is the load of every body without contacts; where there are some, they come on top.
TEST(GroundContact, PushesOfUsersAreTheRest) {
  Standing standing;
  const int left = standing.body("left"), right = standing.body("right");
  standing.push()[left] = {{1, 2, 3}, {4, 5, 6}};
  standing.push()[0] = {{0, 0, 1}, {2, 0, 0}};
  standing.step();
  for (const int body : {0, left, right}) {
    EXPECT_EQ(difference(standing.force()[body].f, standing.push()[body].f), 0);
    EXPECT_EQ(difference(standing.force()[body].n, standing.push()[body].n), 0);
  }
  standing.lift(-1e-3);
  standing.step();
  EXPECT_EQ(difference(standing.set().rest_force[left].f, {4, 5, 6}), 0);
  EXPECT_EQ(difference(standing.force()[0].f, {2, 0, 0}), 0);
  const ContactParameters& p = standing.interface().terms.parameters[0];
  EXPECT_NEAR(standing.force()[left].f.z, 6 + 4 * p.stiffness * 1e-3, 1e-9);
  EXPECT_NEAR(standing.force()[right].f.z, 4 * p.stiffness * 1e-3, 1e-9);
  standing.push()[left] = {};
  standing.step();
  EXPECT_NEAR(standing.force()[left].f.z, 4 * p.stiffness * 1e-3, 1e-9) << "not added up";
}

// Rule: a body that has left the ground is damped by nothing, also not by what others added there.
TEST(GroundContact, LoadsOfTheStepBeforeAreTakenAway) {
  Standing standing;
  standing.lift(-1e-3);
  standing.step();
  const int left = standing.body("left"), right = standing.body("right");
  EXPECT_GT(standing.damping()[left].M.zz, 0);
  standing.damping()[0].J = diagonal(3.0);
  standing.set().rest_damping.push_back({0, standing.damping()[0]});
  standing.lift(1e-3, 0.1);
  standing.step();
  EXPECT_EQ(standing.set().loaded, (std::vector<int>{right})) << "rolled to the right";
  EXPECT_EQ(standing.damping()[left].M.zz, 0);
  EXPECT_GT(standing.damping()[right].M.zz, 0);
  EXPECT_EQ(standing.damping()[0].J.xx, 0);
  EXPECT_TRUE(standing.set().rest_damping.empty());
  standing.damping()[left].J = standing.damping()[0].J = diagonal(3.0);
  standing.set().rest_damping.push_back({left, standing.damping()[left]});
  standing.step();
  EXPECT_EQ(standing.damping()[left].J.xx, 0);
  EXPECT_EQ(standing.damping()[0].J.xx, 3) << "whose addition is not recorded";
}

// Rule: a point keeps its memory while its feature touches, and what comes back begins anew.
TEST(GroundContact, MemoryGoesOnWithTheFeature) {
  Standing standing;
  standing.lift(-1e-3);
  standing.step();
  const auto mark = [&] {
    for (std::size_t i = 0; i < standing.set().points.size(); ++i)
      standing.set().points[i].stretch = {1e-6 * static_cast<double>(i + 1), 0, 0};
  };
  mark();
  const std::vector<ContactPoint> all = standing.set().points;
  standing.step();
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(standing.set().points[i].stretch.x, 1e-6 * (i + 1.0), 1e-12);
  // rolled to the right, where the outer corners stay
  standing.lift(0.018, 0.08);
  standing.step();
  const std::vector<ContactPoint> some = standing.set().points;
  ASSERT_EQ(some.size(), 2U);
  for (const ContactPoint& c : some) {
    const auto before = std::ranges::find(all, c.feature, &ContactPoint::feature);
    ASSERT_NE(before, all.end());
    EXPECT_NEAR(c.stretch.x, before->stretch.x, 1e-9);
  }
  standing.lift(-1e-3);
  standing.step();
  int remembered = 0;
  for (const ContactPoint& c : standing.set().points) remembered += std::abs(c.stretch.x) > 1e-8 ? 1 : 0;
  EXPECT_EQ(remembered, 2);
}

// What forces do not move has no contacts and no load, once; what others write then stays.
TEST(GroundContact, TakesItsHandsOffWhatForcesDoNotMove) {
  Standing standing;
  standing.lift(-1e-3);
  standing.push()[0] = {{0, 0, 1}, {2, 0, 0}};
  standing.step();
  standing.set().rest_damping.push_back({0, Sym6d{}});
  standing.damping()[0].J = diagonal(3.0);
  standing.entity->column(properties::dynamic).values[0] = 0;
  standing.step();
  EXPECT_TRUE(standing.set().points.empty());
  EXPECT_TRUE(standing.set().loaded.empty());
  EXPECT_TRUE(standing.set().rest_damping.empty());
  for (const int body : standing.entity->model().bodies()) {
    EXPECT_EQ(norm(standing.force()[body].f), 0);
    EXPECT_EQ(norm(standing.set().rest_force[body].f), 0);
    EXPECT_EQ(standing.damping()[body].M.zz, 0);
    EXPECT_EQ(standing.damping()[body].J.xx, 0);
  }
  standing.force()[0].f = {1, 0, 0};
  standing.step();
  EXPECT_EQ(standing.force()[0].f.x, 1);
  standing.entity->column(properties::dynamic).values[0] = 1;
  standing.step();
  EXPECT_EQ(standing.set().points.size(), 8U);
  EXPECT_EQ(standing.force()[0].f.x, 2);
}

TEST(GroundContact, StepsOfTheFieldCarry) {
  Standing standing;
  standing.lift(0.099, 0, 5);
  standing.step();
  const ContactSet& set = standing.set();
  ASSERT_EQ(set.points.size(), 8U);
  for (const ContactPoint& c : set.points) {
    EXPECT_EQ(set.environment_objects[c.surface], standing.field->model().object_index("step"));
    EXPECT_NEAR(c.depth, 1e-3, 1e-9);
  }
  EXPECT_GT(set.tests.objects, 0);
}

TEST(GroundContact, LawsAreExchanged) {
  Standing standing;
  const auto law = std::make_shared<KelvinVoigt>();
  standing.lift(-1e-3);
  standing.step();
  standing.contact->exchange_law(law);
  EXPECT_EQ(standing.interface().law, law.get());
  EXPECT_TRUE(standing.set().points.empty()) << "another memory";
  standing.step();
  EXPECT_EQ(standing.set().points.size(), 8U);
  EXPECT_EQ(standing.set().points[0].normal_damping, 0) << "it is explicit";
}

// Rule: a simulation that begins again knows nothing of the one before.
TEST(GroundContact, BeginsAgainWithNothing) {
  Standing standing;
  standing.lift(-1e-3);
  standing.step();
  ContactSet& set = standing.set();
  set.rest_damping.push_back({0, Sym6d{}});
  set.solved = set.island_stands = true;
  set.rest_force[0].f.x = 7;
  ASSERT_FALSE(set.points.empty());
  standing.contact->initialize();
  EXPECT_TRUE(set.points.empty());
  EXPECT_TRUE(set.loaded.empty());
  EXPECT_TRUE(set.rest_damping.empty());
  EXPECT_FALSE(set.solved || set.island_stands);
  EXPECT_EQ(set.tests.volumes, 0);
  EXPECT_EQ(norm(set.rest_force[0].f), 0);
}

// Also if its points are gone already, with the memory of another law.
TEST(GroundContact, TakesItsHandsOffAfterAnExchange) {
  Standing standing;
  standing.lift(-1e-3);
  standing.step();
  const int left = standing.body("left");
  ASSERT_GT(standing.force()[left].f.z, 0);
  standing.contact->exchange_law(std::make_shared<KelvinVoigt>());
  standing.entity->column(properties::dynamic).values[0] = 0;
  standing.step();
  EXPECT_EQ(norm(standing.force()[left].f), 0);
  EXPECT_EQ(standing.damping()[left].M.zz, 0);
  EXPECT_TRUE(standing.set().loaded.empty());
}

TEST(GroundContact, OfNothingIsFreeFlight) {
  World world;
  AccessSet access;
  Entity& entity = world.add("plates", two_plates());
  murosimf::Setup setup(world, entity, access);
  const auto law = std::make_shared<ImplicitStick>();
  GroundContact contact(setup, nullptr, law, {});
  for (const auto& property : {properties::position, properties::linear_velocity, properties::angular_velocity})
    std::ranges::fill(entity.column(property).values, Vec3d{});
  std::ranges::fill(entity.column(properties::orientation).values, Mat3d{});
  contact.initialize();
  EXPECT_EQ(entity.column(contacts).values[0].environment, -1);
  contact.step({Duration{}, std::chrono::milliseconds(1)});
  EXPECT_TRUE(entity.column(contacts).values[0].points.empty());
}

}  // namespace
}  // namespace murosimf::collision
