/// meeting.h - two unequal bodies in empty space that meet off their centers and slide past each other.
#pragma once

#include <memory>
#include <string>

#include "murosimf/collision/body_pairs.h"
#include "tests/fixtures.h"
#include "tests/physics/mechanics.h"
#include "tests/physics/rig.h"

namespace murosimf::collision {

inline ModelPtr rough_ball(double radius, double mass, double friction) {
  PlacedShape sphere;
  sphere.shape = Sphere{radius};
  sphere.surface = {"", friction};
  sphere.position = {0.02, 0, 0.01};
  return std::make_shared<const Model>("ball", Chain{}
                                                   .base("ball")
                                                   .with(properties::mass, mass)
                                                   .with(properties::inertia, diagonal(0.4 * mass * radius * radius))
                                                   .with(properties::shapes, Shapes{sphere}));
}

/// They overlap by a millimeter or so along a slanted normal from the second one to the first one.
struct Meeting {
  explicit Meeting(const std::string& law, const Vec3d& velocity = {0.3, -0.5, -0.4},
                   const std::string& level = "simplified_dynamics") {
    rig.simulation.world().gravity = {};
    const Vec3d n{0.48, 0.6, 0.64};
    small = &rig.add("small", rough_ball(0.05, 0.3, 0.4), {.position = (0.05 + 0.12 - 1e-3) * n + Vec3d{0, 0, 3}});
    big = &rig.add("big", rough_ball(0.12, 2.0, 0.6), {.position = {0, 0, 3.07}});
    rig.attach_together({{small, {.level = level, .on_ground = false}}, {big, {.level = level, .on_ground = false}}},
                        law);
    rig.simulation.initialize();
    test::Rig::launch(*small, velocity, {1, 2, -3});
    test::Rig::launch(*big, {0, 0.1, 0.2}, {-1, 0.5, 2});
    place(*small, (0.05 + 0.12 - 1e-3) * n);
    place(*big, {});
  }
  /// The center of its sphere.
  static void place(Entity& entity, const Vec3d& center) {
    entity.base().set(properties::position, center - Vec3d{0.02, 0, 0.01});
  }
  [[nodiscard]] const PairSet& set() const { return rig.simulation.world().common().find(pair_contacts)->values[0]; }
  [[nodiscard]] Wrenchd total() {
    Wrenchd sum;
    for (Entity* entity : {small, big}) {
      for (const auto& body : test::moving_bodies(*entity)) {
        const Vec3d p = body.mass * body.velocity;
        sum += Wrenchd{cross(body.center, p) + body.inertia * body.angular_velocity, p};
      }
    }
    return sum;
  }
  test::Rig rig;
  Entity *small = nullptr, *big = nullptr;
};

}  // namespace murosimf::collision
