/// ball_contact.h - algorithm: a ball against the bodies of the robots around it.
///
/// One sphere against every colliding shape of every robot, in closed form; the force is explicit (a ball is light
/// and soft: dt^2 k / m < 0.25 at 1 ms), equal and opposite on both sides:
///
///     f_n = max(0, k depth - d v_n)       f_t = -min(mu f_n, ct |v_t|) v_t / |v_t|
///
/// Source: a damped spring that cannot pull (contact_parameters.h) and Coulomb friction, regularized by ct.
/// An entity that cannot be pushed (`pushable` 0: kinematic walking) feels nothing; what it should have felt is added
/// to its ledger `absorbed_impulse`, so that the momentum of ball and ledger together is constant. The speed of such a
/// partner's point counts up to 3 m/s only, so that a change of its standing foot cannot shoot the ball.
/// General collision detection between all bodies takes this file's place when it comes.
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/ground_points.h"
#include "murosimf/model/algorithm.h"
#include "murosimf/model/material.h"
#include "murosimf/model/setup.h"

namespace murosimf::collision {

class BallContact final : public Algorithm {
 public:
  /// `setup` is that of an entity that never freezes (the field), so that a frozen ball stops pushing. Throws SetupError
  /// if the ball's model is not one sphere, or if the steps are too long for its stiffness.
  BallContact(Setup& setup, Entity& ball, const std::vector<Entity*>& robots, const MaterialTable& materials);

  void initialize() override;
  void step(const Instant& instant) noexcept override;

 private:
  /// One robot near the ball.
  struct Partner {
    Partner(Setup setup, const MaterialTable& materials, const Model& ball, const Surface& ball_surface, double gravity,
            double dt);

    std::vector<GroundShape> shapes;
    std::vector<ContactParameters> parameters;  // by shape
    double reach = 0;                           // [m] no shape is further from the base's origin
    std::span<const Vec3d> r, v, w;
    std::span<const Mat3d> R;
    std::span<const double> pushable;
    std::span<Forced> force;
    std::span<Forced> ledger;
    std::vector<int> loaded;  // objects with a force that the next step must take away
  };

  void touch(Partner& partner, double dt) noexcept;
  void push(Partner& partner, const GroundShape& shape, const ContactParameters& parameters, double dt) noexcept;

  const Entity& ball_;
  double radius_ = 0;
  std::span<const Vec3d> r_, v_, w_;  // of the ball, world frame; row 0 is its base
  std::span<Forced> force_;
  std::vector<Partner> partners_;
};

}  // namespace murosimf::collision
