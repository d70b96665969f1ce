#include "murosimf/collision/contact.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_laws/implicit_stick_law.h"
#include "tests/collision/law_fixtures.h"

namespace murosimf::collision {
namespace {

// external_force - external_damping * (change of the body's motion) is the sum of what every point says for the
// change of its own velocity, at the body's origin, plus the force without contacts. Tolerance: rounding of 1e3 N.
TEST(ContactLoads, SumOfPoints) {
  Dice dice("loads");
  law::Worst force_error, moment_error;
  const ImplicitStick law;
  for (int i = 0; i < 50; ++i) {
    ContactParameters p = parameters();
    p.rolling = 0.1;
    LawCase set = one_point(0, {}, p);
    set.points.resize(3, set.points[0]);
    std::vector<Vec3d> r{dice.vector(1), dice.vector(1)};
    std::vector<Wrenchd> force(2), rest{{dice.vector(1), dice.vector(1)}, {dice.vector(1), dice.vector(1)}};
    std::vector<Sym6d> damping(2);
    for (ContactPoint& c : set.points) {
      c.object = 1;
      c.normal = dice.unit();
      c.depth = 1e-3;
      c.radius = 0.2;
      c.point = r[1] + dice.vector(0.3);
      c.velocity = dice.vector(1);
      c.angular_velocity = dice.vector(1);
    }
    set.points[2].state = ContactState::slip;
    set.prepare(law);
    ContactSet loads{.points = set.points, .rest_force = rest, .loaded = {1}};
    force[0] = rest[0];
    // twice: loads are written, not added up
    write_loads(loads, r, force, damping);
    write_loads(loads, r, force, damping);

    const Twistd change{dice.vector(1), dice.vector(1)};
    const Wrenchd given = force[1] - damping[1] * change;
    Vec3d f = rest[1].f, n = rest[1].n;
    for (const ContactPoint& c : set.points) {
      const Vec3d arm = c.point - r[1];
      const Vec3d at_point = force_after(c, c.velocity + change.v + cross(change.w, arm));
      f += at_point;
      n += cross(arm, at_point) + c.moment - angular_damping_matrix(c) * change.w;
    }
    force_error.see(difference(given.f, f), "set", i);
    moment_error.see(difference(given.n, n), "set", i);
    EXPECT_EQ(difference(force[0].f, rest[0].f), 0);  // objects without contacts keep what they have
    EXPECT_EQ(difference(damping[0].M, SymMat3d{}), 0);
  }
  const std::string source = "sum of what its points say for the change of their velocities";
  expect_law("implicit_stick", "load of a body for any change of its motion: error of the force", source, force_error,
             1e-12, "N");
  expect_law("implicit_stick", "load of a body for any change of its motion: error of the moment", source, moment_error,
             1e-12, "N m");
}

// Rule: the law's memory is part of the state: all that a point remembers (contact_point.h, recall) enters the hash.
TEST(ContactLoads, MemoryEntersTheStateHash) {
  const auto hash = [](const ContactSet& set) {
    Hasher hasher;
    append_hash(hasher, set);
    return hasher.value();
  };
  const ContactSet set{.points = one_point(1e-3).points};
  ContactSet other = set;
  EXPECT_EQ(hash(set), hash(other));
  other.points[0].stretch.y = 5e-324;
  EXPECT_NE(hash(set), hash(other));
  other = set;
  other.points[0].state = ContactState::slip;
  EXPECT_NE(hash(set), hash(other));
  other = set;
  other.points[0].last_normal_force = 1e-300;
  EXPECT_NE(hash(set), hash(other));
  other = set;
  other.points[0].slip_direction.z = 1;
  EXPECT_NE(hash(set), hash(other));
  other = set;
  other.points[0].feature = 1;
  EXPECT_NE(hash(set), hash(other));
  other = set;
  other.points.push_back(set.points[0]);
  EXPECT_NE(hash(set), hash(other));
}

// Two entities one after the other: a point of the first is not one of the second.
TEST(ContactLoads, HashKnowsWhosePointsTheyAre) {
  ContactSet one, none;
  one.points.resize(1);
  const auto hash = [](const ContactSet& first, const ContactSet& second) {
    Hasher hasher;
    append_hash(hasher, first);
    append_hash(hasher, second);
    return hasher.value();
  };
  EXPECT_NE(hash(one, none), hash(none, one));
}

}  // namespace
}  // namespace murosimf::collision
