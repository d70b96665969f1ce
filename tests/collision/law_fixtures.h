/// law_fixtures.h - what tests of contact laws share: one point on the ground, and a block that stands on it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "murosimf/collision/contact_laws/contact_law.h"
#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::collision {

using fixtures::Dice;
using fixtures::difference;

inline constexpr double dt = 1e-3;

inline ContactParameters parameters() {
  ContactParameters p;
  p.stiffness = 1e4;
  p.damping = 50;
  p.tangent_stiffness = 8e3;
  p.tangent_damping = 25;
  p.friction = 0.5;
  p.theta = 1;
  return p;
}

/// One row about a contact law alone, without bodies of the simulation.
inline void expect_law(const std::string& level, const std::string& law, const std::string& source,
                       const law::Measured& error, double limit, const std::string& unit) {
  law::expect_below({.law = law, .level = level, .source = source}, error, limit, unit);
}

/// Velocity [m/s] of a point that is pressed with 10 N on ground with mu = 0.5 and friction_direction 0.2 along x, and its friction
/// [N]: mu (1 - friction_direction . d) f_n against the motion.
inline const std::pair<Vec3d, Vec3d> friction_direction_cases[] = {{{1, 0, 0}, {-4, 0, 0}},
                                                                   {{0, 1, 0}, {0, -5, 0}},
                                                                   {{-1, 0, 0}, {6, 0, 0}}};

/// What a law is handed, without an entity.
struct LawCase {
  std::vector<ContactPoint> points;
  ContactTerms terms;
  std::vector<Vec3d> next_velocity;  ///< [m/s] of every point

  void prepare(const ContactLaw& law) { law.prepare(points, terms); }
  [[nodiscard]] bool accepted_by(const ContactLaw& law) { return law.accept(points, terms, next_velocity); }
  void commit(const ContactLaw& law) { law.commit(points, terms, next_velocity); }
};

/// One point on flat ground.
inline LawCase one_point(double depth, const Vec3d& velocity = {}, const ContactParameters& p = parameters()) {
  LawCase set;
  set.terms = {{p}, dt};
  set.points.resize(1);
  set.points[0].normal = {0, 0, 1};
  set.points[0].depth = depth;
  set.points[0].velocity = velocity;
  set.next_velocity.resize(1);
  return set;
}

/// One point of a round body of 5 cm that rolls with 10 rad/s about y, on ground with rolling resistance 0.03.
inline LawCase rolling_point(const Vec3d& velocity = {}) {
  ContactParameters p = parameters();
  p.rolling = 0.03;
  LawCase set = one_point(1e-3, velocity, p);
  set.points[0].radius = 0.05;
  set.points[0].angular_velocity = {0, 10, 0};
  return set;
}

/// A vector by its parts along the normal, along the sliding direction (only while slipping) and across both.
struct Parts {
  Vec3d normal, sliding, across;

  Parts(const ContactPoint& c, const Vec3d& v) {
    normal = dot(v, c.normal) * c.normal;
    if (c.state == ContactState::slip) sliding = dot(v, c.slip_direction) * c.slip_direction;
    across = v - normal - sliding;
  }
};

/// What the interface says (contact.h): the force on A if the velocity after the step is `next`.
inline Vec3d force_after(const ContactPoint& c, const Vec3d& next) {
  const Parts change(c, next - c.velocity);
  return c.force - c.normal_damping * change.normal - c.tangent_damping * change.across;
}

/// A block of `mass` with one point on the ground z = 0, stepped as a motion algorithm does: prepare, trial steps until
/// the law accepts, commit. The linear problem of one trial is diagonal in the parts above.
struct Block {
  double mass = 1;
  Vec3d position, velocity, push;  // push: all other forces
  LawCase set;
  Vec3d contact_force;
  int passes = 0;

  explicit Block(const ContactParameters& p) : set(one_point(0, {}, p)) {}

  [[nodiscard]] ContactPoint& point() { return set.points[0]; }

  void step(const ContactLaw& law) {
    ContactPoint& c = point();
    c.depth = -position.z;
    c.velocity = velocity;
    if (c.depth > 0) {
      set.prepare(law);
    } else {
      c.force = {};
      c.normal_damping = c.tangent_damping = 0;
    }
    for (passes = 1;; ++passes) {
      const Parts f(c, push + c.force);
      set.next_velocity[0] = velocity + (dt / (mass + dt * c.normal_damping)) * f.normal + (dt / mass) * f.sliding +
                             (dt / (mass + dt * c.tangent_damping)) * f.across;
      if (c.depth <= 0 || set.accepted_by(law) || passes == max_passes) break;
    }
    contact_force = force_after(c, set.next_velocity[0]);
    if (c.depth > 0) set.commit(law);
    velocity = set.next_velocity[0];
    position += dt * velocity;
  }
};

inline Block resting_block(const Vec3d& sideways) {
  const ContactParameters p = parameters();
  Block block(p);
  block.push = Vec3d{0, 0, -10} + sideways;
  block.position.z = -10 / p.stiffness;  // the static sink
  return block;
}

}  // namespace murosimf::collision
