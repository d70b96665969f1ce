// The model doctor's look at sensors: what a simulation would say of them.
#include "murosimf/check/robot_doctor.h"
#include "murosimf/scene/scene_spec.h"
#include "murosimf/components/sensor_types.h"
#include "murosimf/model/error.h"

namespace murosimf::io {
std::vector<Finding> examine_sensors(const RobotFile& robot) {
  std::vector<Finding> findings;
  Simulation simulation;
  Entity& entity = simulation.world().add("robot", robot.model, {});
  const sensors::SensorSurroundings surroundings{.movers = {&entity}};
  for (const sensors::SensorSpec& spec : robot.sensors) {
    try {
      attach_sensor(simulation, entity, spec, surroundings, usual_step_rate);
    } catch (const SetupError& error) {
      findings.push_back(make_finding(Severity::error, error.what()));
    }
  }
  return findings;
}

}  // namespace murosimf::io
