// A robot from the seven basic objects, without any file: a slide with two arms, moved by hand.
#include <cstdio>

#include <murosimf/collision/contact_laws/implicit_stick_law.h>
#include <murosimf/collision/contact_properties.h>
#include <murosimf/collision/ground_contact.h>
#include <murosimf/dynamics/simplified_dynamics.h>
#include <murosimf/runtime/simulation.h>

using namespace murosimf;

namespace {

/// An arm of two links; side +1 is left.
Chain arm(double side) {
  const std::string name = side > 0 ? "left" : "right";
  PlacedShape rod;
  rod.shape = Capsule{0.02, 0.08};
  rod.position = {0, 0, -0.1};
  return Chain{}
      .translation({0, 0.12 * side, 0.2})
      .revolute(name + "_shoulder", {0, 1, 0})
      .with(properties::mass, 0.3)
      .with(properties::center_of_mass, {0, 0, -0.1})
      .with(properties::inertia, diagonal(1e-3))
      .with(properties::shapes, Shapes{rod})
      .translation({0, 0, -0.2})
      .endpoint(name + "_hand");
}

}  // namespace

int main() {
  PlacedShape body;
  body.shape = Box{{0.1, 0.1, 0.1}};
  const auto model = std::make_shared<const Model>("slide", Chain{}
                                                                .base("body")
                                                                .with(properties::mass, 2.0)
                                                                .with(properties::inertia, diagonal(0.02))
                                                                .with(properties::shapes, Shapes{body})
                                                                .fork(arm(+1), arm(-1)));
  PlacedShape plane;
  plane.shape = Plane{};
  const auto ground =
      std::make_shared<const Model>("ground", Chain{}.base("ground").with(properties::shapes, Shapes{plane}));

  Simulation simulation;
  Entity& floor = simulation.world().add("floor", ground);
  Entity& robot = simulation.world().add("robot", model);
  simulation.attach<collision::GroundContact>("ground_contact", robot, 1000, &floor,
                                              std::make_shared<collision::ImplicitStick>(), MaterialTable::standard());
  simulation.attach<dynamics::SimplifiedDynamics>("simplified_dynamics", robot, 1000);
  simulation.initialize();

  robot.object("left_shoulder").set(properties::joint_target, -1.0);       // lift an arm
  robot.base().set(properties::applied_force, Wrenchd{{}, {30.0, 0, 0}});  // and push with 30 N
  simulation.run(std::chrono::seconds(1));

  const Vec3d r = robot.base().get(properties::position);
  const Vec3d hand = robot.object("left_hand").get(properties::position);
  std::printf("body at (%.3f, %.3f, %.3f) m, left hand at (%.3f, %.3f, %.3f) m\n", r.x, r.y, r.z, hand.x, hand.y,
              hand.z);
  return r.x > 0.5 ? 0 : 1;  // 30 N overcome the friction of 0.8 * 2.6 kg * 9.81 m/s^2 = 20 N
}
