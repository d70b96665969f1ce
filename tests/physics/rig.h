/// rig.h - small worlds for tests of physical laws.
#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "murosimf/collision/ball_contact.h"
#include "murosimf/collision/ground_contact.h"
#include "murosimf/collision/implicit_stick.h"
#include "murosimf/collision/paper_law.h"
#include "murosimf/control/walk_engine.h"
#include "murosimf/io/ball.h"
#include "murosimf/io/mjcf_reader.h"
#include "murosimf/motion/kinematic_walking.h"
#include "murosimf/motion/odometer.h"
#include "murosimf/motion/simplified_dynamics.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf::test {

inline constexpr double g = 9.81;  // [m/s^2]

/// A world with a ground plane whose friction is `friction`, and gravity turned by `slope` [rad] about y, so that
/// things slide towards +x.
struct Rig {
  explicit Rig(double friction = 0.8, double slope = 0, double rate_hz = 1000, int threads = 1)
      : simulation(threads), rate(rate_hz) {
    simulation.world().gravity = {g * std::sin(slope), 0, -g * std::cos(slope)};
    PlacedShape plane;
    plane.shape = Plane{};
    plane.surface.friction = friction;
    auto model =
        std::make_shared<const Model>("ground", Chain{}.base("ground").with(properties::shapes, Shapes{plane}));
    ground = &simulation.world().add("ground", model);
  }

  Entity& add(const std::string& name, ModelPtr model, const EntityOptions& options = {}) {
    return simulation.world().add(name, std::move(model), options);
  }

  template <class Law = collision::ImplicitStick>
  void attach_dynamics(Entity& entity, const motion::SimplifiedDynamicsOptions& options = {}, bool on_ground = true,
                       std::shared_ptr<const collision::ContactLaw> law = std::make_shared<Law>()) {
    simulation.attach<collision::GroundContact>("ground_contact", entity, rate, on_ground ? ground : nullptr,
                                                std::move(law), materials);
    simulation.attach<motion::SimplifiedDynamics>("simplified_dynamics", entity, rate, options);
  }

  void run(double s) { simulation.run(from_seconds(s)); }

  /// Sets the velocity [m/s] of the center of mass and the angular velocity [rad/s], world frame.
  static void launch(Entity& entity, const Vec3d& v, const Vec3d& w = {}) {
    const Vec3d change = v - entity.base().get(properties::common_center_of_mass_velocity);
    entity.base().set(properties::linear_velocity, entity.base().get(properties::linear_velocity) + change);
    entity.base().set(properties::angular_velocity, w);
  }
  static Vec3d place(Entity& entity) { return entity.base().get(properties::position); }
  static Vec3d velocity(Entity& entity) { return entity.base().get(properties::common_center_of_mass_velocity); }

  Simulation simulation;
  MaterialTable materials;
  Entity* ground = nullptr;
  double rate;
};

/// A box of 4.3 kg, 0.30 x 0.20 x 0.10 m.
inline ModelPtr box_model(double friction = 0.8) {
  const double m = 4.3;
  const Vec3d h{0.15, 0.10, 0.05};
  PlacedShape box;
  box.shape = Box{h};
  box.surface.friction = friction;
  const SymMat3d inertia{
      m / 3 * (h.y * h.y + h.z * h.z), m / 3 * (h.x * h.x + h.z * h.z), m / 3 * (h.x * h.x + h.y * h.y), 0, 0, 0};
  return std::make_shared<const Model>("box", Chain{}
                                                  .base("box")
                                                  .with(properties::mass, m)
                                                  .with(properties::inertia, inertia)
                                                  .with(properties::shapes, Shapes{box}));
}

inline ModelPtr kid21() {
  static const ModelPtr model = io::read_mjcf(std::string(MUROSIMF_SOURCE_DIR) + "/models/kid21.xml").model;
  return model;
}

}  // namespace murosimf::test
