/// stand.h - what every robot with legs must do: stand for 10 s, and walk 2 m on kinematic feet.
#pragma once

#include "tests/physics/walk.h"

namespace murosimf::test {

/// Controlled by the walk engine, or by `Controller`, with command 0; two seconds are left for settling.
template <class Controller = control::WalkEngine>
void expect_stands(const std::string& name, const ModelPtr& model, const std::string& level) {
  Rig rig;
  rig.materials.set("rubber", "", {.friction = 0.8});
  Entity& robot = rig.add("robot", model);
  rig.simulation.attach<Controller>("controller", robot, Controller::rate_hz);
  rig.attach_motion(robot, {.level = level});
  rig.run(2.0);
  const Vec3d place = Rig::place(robot);
  const Vec3d up = transposed_times(robot.base().get(properties::orientation), Vec3d{0, 0, 1});
  law::Worst moved, lean;
  for (int i = 0; i < 8000; ++i) {
    rig.simulation.step();
    moved.see(1e3 * norm(Rig::place(robot) - place), "step", i);
    const Vec3d now = transposed_times(robot.base().get(properties::orientation), Vec3d{0, 0, 1});
    lean.see(norm(now - up) / degree, "step", i);
  }
  law::expect_below({.law = name + " stands for 10 s: way of the base after two seconds",
                     .level = level,
                     .source = "none"},
                    moved, 3, "mm");
  law::expect_below({.law = name + " stands for 10 s: change of lean after two seconds",
                     .level = level,
                     .source = "none"},
                    lean, 1, "deg");
}

/// Kinematic walking forward with 0.15 m/s.
inline void expect_walks_two_meters(const std::string& name, const ModelPtr& model) {
  const double seconds = 15;
  const Walk result =
      walk({.dynamics = {.level = "kinematic_walking"}, .command = {0.15, 0, 0}, .seconds = seconds, .model = model});
  law::expect_between({.law = name + " walks forward with 0.15 m/s: way in 15 s",
                       .level = "kinematic_walking",
                       .source = "the commanded way, less the start"},
                      result.moved.x, 2.0, 0.15 * seconds, "m");
  law::expect_below({.law = name + " walks forward with 0.15 m/s: aberration sideways on 2 m",
                     .level = "kinematic_walking",
                     .source = "none"},
                    std::abs(result.moved.y), 0.1, "m");
  law::expect_below({.law = name + " walks forward: slip of the standing sole",
                     .level = "kinematic_walking",
                     .source = "it is fixed to the plane"},
                    result.slip, 1e-9, "m");
}

}  // namespace murosimf::test
