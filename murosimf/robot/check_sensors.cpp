// Sensors: errors that a simulation would report.
#include "murosimf/component_files/sensor_types.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/robot_checks.h"
#include "murosimf/world/time.h"

namespace murosimf::robot {
std::vector<Finding> examine_sensors(const robot::RobotFile& robot) {
  std::vector<Finding> findings;
  Simulation simulation;
  Entity& entity = simulation.world().add("robot", robot.model, {});
  const sensors::SensorSurroundings surroundings{.moving_entities = {&entity}};
  for (const sensors::SensorSpec& spec : robot.sensors) {
    try {
      component_files::attach_sensor(simulation, entity, spec, surroundings, usual_step_rate);
    } catch (const SetupError& error) {
      findings.push_back(make_finding(Severity::error, error.what()));
    }
  }
  return findings;
}

}  // namespace murosimf::robot
