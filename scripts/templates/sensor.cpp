#include "murosimf/sensors/new_name.h"

namespace murosimf::sensors {

// An output is a name, its unit and labels if it is more than one number: {"velocity", "m/s", {"x", "y", "z"}}. Numbers that
// a file may set come from checked_number (numbers.h); sensor_types.cpp names their keys.
NewName::NewName(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {{"height", "m", {}}}), mounting_(setup, spec) {}

// Other properties than the sensor's own place are columns that the constructor takes: setup.read(properties::...).
void NewName::measure(std::span<double> values) noexcept { values[0] = mounting_.position().z; }

}  // namespace murosimf::sensors
