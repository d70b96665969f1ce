#include "murosimf/robot/robot_checks.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/locomotion/leg.h"
#include "murosimf/model/properties.h"

namespace murosimf::robot {
namespace {

bool has_wheels(const Model& model) {
  return std::ranges::any_of(model.having(properties::servo),
                             [&](int joint) { return dynamics::follows_rate(*model.find(properties::servo, joint)); });
}

void append(std::vector<Finding>& all, std::vector<Finding> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<Finding> examine(const robot::RobotFile& robot) {
  std::vector<Finding> findings;
  for (const std::string& note : robot.notes) findings.push_back(make_finding(Severity::note, note));
  for (const std::string& warning : robot.warnings) findings.push_back(make_finding(Severity::warning, warning));
  append(findings, examine_sensors(robot));
  append(findings, examine_masses(robot.description));
  append(findings, examine_joints(robot.description, *robot.model));
  append(findings, examine_symmetry(robot.description));
  append(findings, examine_shapes(robot.description));
  append(findings, examine_legs(robot.description, *robot.model));
  append(findings, examine_gait(robot.description, *robot.model));
  return findings;
}

std::vector<Finding> examine_legs(const robot_formats::RobotDescription& description, const Model& model) {
  const std::size_t soles = model.having(properties::sole).size();
  if (has_wheels(model) || description.fixed_base) return {};
  const std::string& where = description.bodies[0].where;
  if (soles != 2 && soles != 4) {
    return {{Severity::warning, where, fmt::format("{} soles; a biped needs 2, a quadruped 4", soles),
             "name the feet in [soles] of the TOML file beside the robot"}};
  }
  try {
    (void)(soles == 2 ? locomotion::find_legs(model)[0] : locomotion::find_four_legs(model)[0]);
  } catch (const SetupError& error) {
    return {{Severity::warning, where, error.what(), "without legs the walk engine cannot move it"}};
  }
  return {};
}

}  // namespace murosimf::robot
