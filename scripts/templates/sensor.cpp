#include "murosimf/sensors/new_name.h"

namespace murosimf::sensors {

// An output is a name, its unit and labels if it is more than one number: {"velocity", "m/s", {"x", "y", "z"}}. What a file may
// set is an OptionTable (sensor_options.h), whose infos() are the last item of the line in sensor_types.cpp.
NewName::NewName(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {{"height", "m", {}}}), mounting_(setup, spec) {}

// Other properties than the sensor's own place are columns that the constructor takes: setup.read(properties::...).
void NewName::measure(std::span<double> values) noexcept { values[0] = mounting_.position().z; }

}  // namespace murosimf::sensors
