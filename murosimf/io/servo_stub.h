/// servo_stub.h - the TOML file to begin with beside a robot file: its servos, as far as the file knows them.
#pragma once

#include <string>

#include "murosimf/io/robot_draft.h"

namespace murosimf::io {

/// A section [servos.NAME] for each kind of drive, with the joints that have it. A drive with actuators is complete: law
/// ideal_pd with the numbers of actuator and joint. Of one without, the file knows at most limits of effort and rate, and
/// friction: such a section is commented out as a whole, with dots for what has to be filled in, so that the file can be
/// read as it is. Joints that follow others, and those of which nothing is known, have no servo. Soles are listed as a
/// comment where box sites could be some.
[[nodiscard]] std::string servo_stub(const RobotDraft& draft);

}  // namespace murosimf::io
