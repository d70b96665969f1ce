// Contacts of an island on bodies of few numbers: the cone, unsymmetric masses, contacts of an entity with itself.
#include "murosimf/collision/contact_laws/island_solver.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/collision/law_fixtures.h"

namespace murosimf::collision {
namespace {

/// A point mass: three numbers, one for each axis of the world.
struct Point final : ImpulseResponse {
  Point(double its_mass, const Vec3d& v) : mass(its_mass), velocity(v) {}
  bool free_pass(double) noexcept override { return true; }
  [[nodiscard]] std::size_t coordinates() const noexcept override { return 3; }
  [[nodiscard]] Vec3d free_velocity(int, const Vec3d&, const Vec3d&) const noexcept override { return velocity; }
  void respond(int, const Vec3d&, const Mat3d& directions, ResponseRows& y) const noexcept override {
    const double s = 1 / std::sqrt(mass);
    const auto& [a, b, c] = directions;
    y.add(0, s * Vec3d{a.x, b.x, c.x});
    y.add(1, s * Vec3d{a.y, b.y, c.y});
    y.add(2, s * Vec3d{a.z, b.z, c.z});
  }
  void apply(std::span<const double> z) noexcept override {
    velocity += (1 / std::sqrt(mass)) * Vec3d{z[0], z[1], z[2]};
  }
  double mass;
  Vec3d velocity;  // [m/s] after the step
};

/// Two masses on a vertical rail; the second slides in the first. Number 0 moves both, number 1 the second alone.
struct Telescope final : ImpulseResponse {
  bool free_pass(double) noexcept override { return true; }
  [[nodiscard]] std::size_t coordinates() const noexcept override { return 2; }
  [[nodiscard]] Vec3d free_velocity(int object, const Vec3d&, const Vec3d&) const noexcept override {
    return {0, 0, v[static_cast<std::size_t>(object)]};
  }
  void respond(int object, const Vec3d&, const Mat3d& directions, ResponseRows& y) const noexcept override {
    const Vec3d up{directions.x.z, directions.y.z, directions.z.z};
    y.add(0, (1 / std::sqrt(both)) * up);
    if (object == 1) y.add(1, (1 / std::sqrt(inner)) * up);
  }
  void apply(std::span<const double> z) noexcept override {
    v[0] += z[0] / std::sqrt(both);
    v[1] += z[0] / std::sqrt(both) + z[1] / std::sqrt(inner);
  }
  double both = 5, inner = 0.8;        // [kg]
  std::array<double, 2> v{0.3, -0.6};  // [m/s] after the step
};

/// Moves more easily one way than the other, neither of them an axis of the world.
struct Sledge final : ImpulseResponse {
  bool free_pass(double) noexcept override { return true; }
  [[nodiscard]] std::size_t coordinates() const noexcept override { return 3; }
  [[nodiscard]] Vec3d free_velocity(int, const Vec3d&, const Vec3d&) const noexcept override { return velocity; }
  void respond(int, const Vec3d&, const Mat3d& directions, ResponseRows& y) const noexcept override {
    const auto& [a, b, c] = directions;
    for (int k = 0; k < 3; ++k) y.add(k, Vec3d{dot(a, ways[k]), dot(b, ways[k]), dot(c, ways[k])});
  }
  void apply(std::span<const double> z) noexcept override {
    for (std::size_t k = 0; k < 3; ++k) velocity += z[k] * ways[k];
  }
  const double runner = 0.6;  // [rad] from x
  const std::array<Vec3d, 3> ways{(1 / std::sqrt(0.5)) * Vec3d{std::cos(runner), std::sin(runner), 0},
                                  (1 / std::sqrt(6.0)) * Vec3d{-std::sin(runner), std::cos(runner), 0},
                                  (1 / std::sqrt(2.0)) * Vec3d{0, 0, 1}};  // of 0.5 kg, 6 kg and 2 kg
  Vec3d velocity{0.003, -0.002, -0.05};                                    // [m/s] after the step
};

ContactPoint touching(const Vec3d& normal, double depth) {
  ContactPoint point;
  point.normal = normal;
  point.depth = depth;
  return point;
}

/// [N] normal force of the compliant contact for its velocity after the step.
double normal_force(const ContactParameters& p, double depth, double v) {
  return p.stiffness * (depth - p.theta * dt * v) - p.damping * v;
}

// Rule: friction is mu times the normal force straight against the motion, in every direction, also across the axes of
// the contact's frame.
TEST(IslandSolver, SlidingFrictionIsThatOfACone) {
  for (int k = 0; k < 16; ++k) {
    const double angle = 0.1 + k * pi / 8;
    const Vec3d along{std::cos(angle), std::sin(angle), 0};
    Point body(2.0, 3.0 * along + Vec3d{0, 0, -0.05});
    ContactPoint point = touching({0, 0, 1}, 2e-3);
    const ContactParameters p = parameters();
    IslandSolver solver;
    solver.start(dt);
    const int member = solver.add(body);
    solver.add(point, p, {member, 0, {}}, {});
    solver.sweep(200);
    solver.finish();
    const double f_n = normal_force(p, 2e-3, body.velocity.z);
    EXPECT_NEAR(point.force.z, f_n, 1e-6) << angle;
    EXPECT_EQ(point.state, ContactState::slip);
    EXPECT_LT(difference(point.force - Vec3d{0, 0, f_n}, -p.friction * f_n * along), 1e-5) << angle;
    EXPECT_LT(difference(point.slip_direction, along), 1e-6);
    EXPECT_NEAR(body.velocity.z + 0.05, dt / 2.0 * f_n, 1e-9);
    EXPECT_LT(difference(point.stretch,
                         (1 / p.tangent_stiffness) * (p.friction * f_n * along -
                                                      p.tangent_damping * Vec3d{body.velocity.x, body.velocity.y, 0})),
              1e-8);
  }
}

// A point that sticks keeps the force of its spring and damper: f = -kt (s + h v) - ct v.
TEST(IslandSolver, StickingForceIsThatOfItsSpring) {
  Point body(2.0, {0.003, -0.001, -0.05});
  ContactPoint point = touching({0, 0, 1}, 2e-3);
  point.stretch = {1e-4, 2e-4, 0};
  const ContactParameters p = parameters();
  IslandSolver solver;
  solver.start(dt);
  solver.add(point, p, {solver.add(body), 0, {}}, {});
  solver.sweep(200);
  solver.finish();
  ASSERT_EQ(point.state, ContactState::stick);
  const Vec3d v{body.velocity.x, body.velocity.y, 0};
  const Vec3d stretched = Vec3d{1e-4, 2e-4, 0} + dt * v;
  EXPECT_LT(difference(point.stretch, stretched), 1e-12);
  EXPECT_LT(difference(point.force - Vec3d{0, 0, point.force.z},
                       -p.tangent_stiffness * stretched - p.tangent_damping * v),
            1e-6);
}

// Where a push along one tangent also moves along the other, both are solved together: at once, as normal forces are.
TEST(IslandSolver, SticksWhateverWayTheBodyYields) {
  Sledge body;
  ContactPoint point = touching({0, 0, 1}, 2e-3);
  const ContactParameters p = parameters();
  IslandSolver solver;
  solver.start(dt);
  solver.add(point, p, {solver.add(body), 0, {}}, {});
  EXPECT_EQ(solver.sweep(50), 2) << "the second one sees that nothing moves";
  solver.finish();
  ASSERT_EQ(point.state, ContactState::stick);
  const Vec3d v{body.velocity.x, body.velocity.y, 0};
  EXPECT_LT(difference(point.force, Vec3d{0, 0, normal_force(p, 2e-3, body.velocity.z)} -
                                        (p.tangent_stiffness * dt + p.tangent_damping) * v),
            1e-9);
}

// Two unequal masses pushed together obliquely; momentum is kept, and what holds between them is the contact's law.
TEST(IslandSolver, TwoBodiesFeelEqualAndOppositeForces) {
  const Vec3d n = (1 / std::sqrt(0.36 + 0.16 + 0.48)) * Vec3d{0.6, -0.4, std::sqrt(0.48)};
  Point light(0.5, {-0.4, 0.1, 0}), heavy(3.0, {0.2, 0, 0.3});
  ContactPoint point = touching(n, 1e-3);
  ContactParameters p = parameters();
  p.friction = 0;
  IslandSolver solver;
  solver.start(dt);
  const int a = solver.add(light), b = solver.add(heavy);
  solver.add(point, p, {a, 0, {}}, {b, 0, {}});
  EXPECT_EQ(solver.sweep(200), 2) << "a number is solved at once, and another sweep sees that nothing moves";
  EXPECT_EQ(solver.sweep(200), 1);
  solver.finish();
  EXPECT_LT(difference(0.5 * light.velocity + 3.0 * heavy.velocity, {-0.2 + 0.6, 0.05, 0.9}), 1e-12);
  const double v_n = dot(n, light.velocity - heavy.velocity);
  EXPECT_NEAR(dot(n, point.force), normal_force(p, 1e-3, v_n), 1e-6);
  EXPECT_LT(norm(tangential(point.force, n)), 1e-9);
  EXPECT_LT(difference(light.velocity, Vec3d{-0.4, 0.1, 0} + (dt / 0.5) * point.force), 1e-12);
}

// What cannot give way has a velocity of its own.
TEST(IslandSolver, MovingWallPushes) {
  Point body(2.0, {0, 0, 0});
  ContactPoint point = touching({0, 0, 1}, 1e-3);
  const ContactParameters p = parameters();
  IslandSolver solver;
  solver.start(dt);
  solver.add(point, p, {solver.add(body), 0, {}}, {-1, 0, {0, 0, 0.7}});
  solver.sweep(200);
  solver.finish();
  EXPECT_NEAR(point.force.z, normal_force(p, 1e-3, body.velocity.z - 0.7), 1e-6);
}

// Both sides belong to one entity: number 0 moves both and cancels out, so the inner mass alone feels the contact.
TEST(IslandSolver, ContactOfAnEntityWithItselfCountsSharedNumbersOnce) {
  for (const bool inner_first : {true, false}) {
    Telescope body;
    ContactPoint point = touching({0, 0, inner_first ? 1.0 : -1.0}, 1e-3);
    const ContactParameters p = parameters();
    IslandSolver solver;
    solver.start(dt);
    const int member = solver.add(body);
    solver.add(point, p, {member, inner_first ? 1 : 0, {}}, {member, inner_first ? 0 : 1, {}});
    EXPECT_LE(solver.sweep(50), 3) << "one contact with the right masses is solved at once";
    solver.finish();
    EXPECT_NEAR(body.v[0], 0.3, 1e-12) << "forces inside do not move the whole";
    const double v = body.v[1] - body.v[0], f = norm(point.force);
    EXPECT_NEAR(f, normal_force(p, 1e-3, v), 1e-6);
    EXPECT_NEAR(v, -0.9 + dt / 0.8 * f, 1e-9);
  }
}

TEST(IslandSolver, PointThatPartsHasNoForce) {
  Point body(2.0, {0.2, 0, 5});
  ContactPoint point = touching({0, 0, 1}, 1e-3);
  point.stretch = {1e-4, 0, 0};
  point.last_normal_force = 4;
  const ContactParameters p = parameters();
  IslandSolver solver;
  solver.start(dt);
  solver.add(point, p, {solver.add(body), 0, {}}, {});
  solver.sweep(50);
  solver.finish();
  EXPECT_EQ(point.state, ContactState::open);
  EXPECT_EQ(norm(point.force), 0);
  EXPECT_EQ(norm(point.stretch), 0);
  EXPECT_LT(difference(body.velocity, {0.2, 0, 5}), 1e-12);
}

// Rule: whether it sticks is about the present step, not about the one before.
TEST(IslandSolver, PointThatSlidOrWasOpenSticksAgain) {
  for (const ContactState before : {ContactState::slip, ContactState::open}) {
    Point body(2.0, {0.003, -0.001, -0.05});
    ContactPoint point = touching({0, 0, 1}, 2e-3);
    point.state = before;
    const ContactParameters p = parameters();
    IslandSolver solver;
    solver.start(dt);
    solver.add(point, p, {solver.add(body), 0, {}}, {});
    solver.sweep(200);
    solver.finish();
    EXPECT_EQ(point.state, ContactState::stick);
    EXPECT_LT(difference(point.stretch, dt * Vec3d{body.velocity.x, body.velocity.y, 0}), 1e-12);
  }
}

TEST(IslandSolver, GrainMakesFrictionDependOnTheDirection) {
  ContactParameters p = parameters();
  p.friction_direction = {0.2, 0, 0};
  for (const auto& [v, share] : {std::pair{Vec3d{3, 0, 0}, 0.8}, {Vec3d{-3, 0, 0}, 1.2}, {Vec3d{0, 3, 0}, 1.0}}) {
    Point body(2.0, v + Vec3d{0, 0, -0.05});
    ContactPoint point = touching({0, 0, 1}, 2e-3);
    IslandSolver solver;
    solver.start(dt);
    solver.add(point, p, {solver.add(body), 0, {}}, {});
    solver.sweep(200);
    solver.finish();
    const double size = std::hypot(point.force.x, point.force.y);
    EXPECT_NEAR(size / point.force.z, share * p.friction, 1e-6) << v.x;
  }
}

// A block of 2 kg at rest on a springy floor, pushed askew: the forces of the step before hold it, so that one sweep
// moves nothing.
TEST(IslandSolver, StartsFromTheStepBefore) {
  const ContactParameters p = parameters();
  const Vec3d push{3, -5, -20};  // [N]
  Point body(2.0, (dt / 2.0) * push);
  ContactPoint point = touching({0, 0, 1}, 20 / p.stiffness);
  point.stretch = (1 / p.tangent_stiffness) * Vec3d{push.x, push.y, 0};
  point.last_normal_force = 20;
  IslandSolver solver;
  solver.start(dt);
  solver.add(point, p, {solver.add(body), 0, {}}, {});
  EXPECT_EQ(solver.sweep(50), 1);
  solver.finish();
  EXPECT_LT(difference(point.force, -push), 1e-6);
  EXPECT_LT(norm(body.velocity), 1e-9);
}

// What was solved before leaves nothing behind.
TEST(IslandSolver, BeginsAnewInEveryStep) {
  const ContactParameters p = parameters();
  const auto solve = [&](IslandSolver& solver, double mass) {
    Point body(mass, {0.1, 0.3, -0.05});
    ContactPoint point = touching({0, 0, 1}, 2e-3);
    solver.start(dt);
    solver.add(point, p, {solver.add(body), 0, {}}, {});
    solver.sweep(200);
    solver.finish();
    return body.velocity;
  };
  IslandSolver used, fresh;
  (void)solve(used, 0.7);
  const Vec3d again = solve(used, 2.0);
  EXPECT_EQ(difference(again, solve(fresh, 2.0)), 0);
}

// Rule: a spring without a damper counts as damped with 1e-6 N s/m, so little that only great speeds show it.
TEST(IslandSolver, SpringWithoutADamperHasNextToNone) {
  ContactParameters p = parameters();
  p.damping = p.theta = 0;
  Point body(2.0, {0, 0, 1e3});
  ContactPoint point = touching({0, 0, 1}, 2e-3);
  IslandSolver solver;
  solver.start(dt);
  solver.add(point, p, {solver.add(body), 0, {}}, {});
  solver.sweep(50);
  solver.finish();
  EXPECT_NEAR(point.force.z, p.stiffness * 2e-3 - 1e-6 * body.velocity.z, 1e-7);
}

}  // namespace
}  // namespace murosimf::collision
