#include "murosimf/scene_file/level_options.h"

namespace murosimf::scene_file {

catalog::LevelOptions level_options(const RobotSpec& robot) {
  catalog::LevelOptions options;
  options.base_rigid = robot.base_rigid;
  options.servo_law = robot.servo_law;
  options.tree.integrator = robot.integrator;
  options.tree.fixed_base = robot.fixed_base;
  options.reference.kind = find_entry(dynamics::joint_references(), "joint reference", robot.joint_reference).kind;
  options.own = robot.level_options;
  return options;
}

}  // namespace murosimf::scene_file
