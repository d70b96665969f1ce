/// bolted.h - mechanisms on a base that is bolted to the world.
#pragma once

#include "tests/physics/rig.h"

namespace murosimf::test {

/// At articulated_dynamics, without ground.
struct Bolted {
  explicit Bolted(Chain chain, dynamics::Integrator integrator = dynamics::Integrator::semi_implicit_euler) {
    robot = &rig.add("robot", std::make_shared<const Model>("robot", std::move(chain)));
    rig.attach_dynamics(*robot, {.level = "articulated_dynamics",
                                 .law = law_named("kelvin_voigt"),
                                 .on_ground = false,
                                 .tree = {.integrator = integrator, .fixed_base = true}});
    rig.simulation.initialize();
  }
  ObjectAccess joint(const std::string& name) { return robot->object(name); }

  Rig rig;
  Entity* robot;
};

}  // namespace murosimf::test
