// TOML files beside a robot; servos in them come from servo tables, sensors from parts.
#include "murosimf/robot/robot_config.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".toml", [](const auto& file) {
    const robot::RobotConfig table = robot::read_robot_config(file);
    std::vector<sensors::SensorSpec> sensors;
    component_files::change_sensors(sensors, table.sensors, {});
  });
  return 0;
}
