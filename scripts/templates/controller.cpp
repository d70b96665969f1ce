#include "murosimf/soccer/new_name.h"

#include "murosimf/locomotion/gait_properties.h"

namespace murosimf::soccer {

// Sensors are read here: sensors::read_output(setup, "imu.gyroscope") (sensors/reading.h).
NewName::NewName(Setup& setup, const NewNameOptions& options)
    : options_(options), command_(setup.write(properties::walk_command)[0]) {}

void NewName::initialize() { command_ = {}; }

// Decides anew in every step. State is a property of its own (behavior_properties.h), not a member.
void NewName::step(const Instant&) noexcept { command_ = options_.velocity; }

}  // namespace murosimf::soccer
