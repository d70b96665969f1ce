/// mechanics.h - momentum and energy of a robot as sums over its bodies, from the columns that every level writes.
#pragma once

#include <vector>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/entity.h"

namespace murosimf::test {

/// A link as a rigid body in motion.
struct MovingBody {
  double mass = 0;
  SymMat3d inertia;        // [kg m^2] at the center of mass, world axes
  Vec3d center, velocity;  // [m], [m/s] of the center of mass
  Vec3d angular_velocity;  // [rad/s]
};

inline std::vector<MovingBody> moving_bodies(Entity& entity) {
  std::vector<MovingBody> bodies;
  for (const Link& link : entity.model().tree().links) {
    const auto i = static_cast<std::size_t>(link.object);
    const Mat3d& R = entity.find(properties::orientation)->values[i];
    const Vec3d& w = entity.find(properties::angular_velocity)->values[i];
    const Vec3d arm = R * link.com;
    bodies.push_back({link.mass, rotated(R, link.inertia), entity.find(properties::position)->values[i] + arm,
                      entity.find(properties::linear_velocity)->values[i] + cross(w, arm), w});
  }
  return bodies;
}

/// [kg m^2/s, N s] moment of momentum about the common center of mass, and momentum.
inline Wrenchd momentum(Entity& entity) {
  const Vec3d c = entity.base().get(properties::common_center_of_mass);
  Wrenchd sum;
  for (const MovingBody& body : moving_bodies(entity)) {
    const Vec3d p = body.mass * body.velocity;
    sum += Wrenchd{cross(body.center - c, p) + body.inertia * body.angular_velocity, p};
  }
  return sum;
}

/// [J]
inline double kinetic_energy(Entity& entity) {
  double sum = 0;
  for (const auto& [mass, inertia, center, velocity, w] : moving_bodies(entity)) {
    sum += 0.5 * (mass * dot(velocity, velocity) + dot(w, inertia * w));
  }
  return sum;
}

}  // namespace murosimf::test
