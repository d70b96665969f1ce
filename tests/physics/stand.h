/// stand.h - what every robot with legs must do: stand for 10 s, and walk 2 m on kinematic feet.
#pragma once

#include "tests/physics/walk.h"

namespace murosimf::test {

/// After the first two seconds of ten, which are left for settling.
struct StandStill {
  double moved = 0;   ///< [mm] largest way of the base
  double leaned = 0;  ///< [deg] largest change of its lean
};

/// Controlled by the walk engine, or by `Controller`, with command 0.
template <class Controller = locomotion::WalkEngine>
StandStill stand_still(const ModelPtr& model, const std::string& level) {
  Rig rig;
  rig.materials.set("rubber", "", {.friction = 0.8});
  Entity& robot = rig.add("robot", model);
  rig.simulation.attach<Controller>("controller", robot, Controller::rate_hz);
  rig.attach_motion(robot, {.level = level});
  rig.run(2.0);
  const auto up = [&] { return transposed_times(robot.base().get(properties::orientation), Vec3d{0, 0, 1}); };
  const Vec3d place = Rig::place(robot), upright = up();
  StandStill result;
  for (int i = 0; i < 8000; ++i) {
    rig.simulation.step();
    result.moved = std::max(result.moved, 1e3 * norm(Rig::place(robot) - place));
    result.leaned = std::max(result.leaned, norm(up() - upright) / degree);
  }
  return result;
}

/// Stands, as a row of docs/validation.md.
inline void expect_still(const std::string& name, const std::string& level, const StandStill& stand) {
  const std::string source = "none";
  law::expect_below({.law = name + " stands for 10 s: way of the base after two seconds",
                     .level = level,
                     .source = source},
                    stand.moved, 3, "mm");
  law::expect_below({.law = name + " stands for 10 s: change of lean after two seconds",
                     .level = level,
                     .source = source},
                    stand.leaned, 1, "deg");
}

/// Kinematic walking with 0.15 m/s for 15 s: 2 m and a quarter, less the start.
inline Walk walk_two_meters(const ModelPtr& model) {
  return walk({.dynamics = {.level = "kinematic_walking"}, .command = {0.15, 0, 0}, .seconds = 15, .model = model});
}

}  // namespace murosimf::test
