/// mjcf_idle.h - what an MJCF file says that would change the motion and does not act here: one warning each.
///
/// Tendons with a spring, a damper, friction, a rotor or a limit; equalities that hold bodies or tendons together, so that loops of the
/// mechanism are open here; gravity that is taken from a body. A tendon without all that only measures a length and is a line in `unused`.
#pragma once

#include "murosimf/description/robot_description.h"
#include "murosimf/formats/mjcf/mjcf_defaults.h"
#include "murosimf/formats/mjcf/mjcf_frame.h"

namespace murosimf::formats::mjcf {

void name_idle_relations(const files::XmlElement& root, const MjcfDefaults& defaults, const MjcfCompiler& compiler,
                         description::RobotDescription& description);

}  // namespace murosimf::formats::mjcf
