/// mjcf_actuator.h - actuators of an MJCF file as servos.
///
/// A position actuator with gain kp and gear g at joint angle q pulls with g kp (u - g q), so its gain about the
/// joint is g^2 kp and its limits are g times `forcerange`. MJCF has no speed limit: no_load_rate stays 0, "unknown".
/// Source: MuJoCo documentation, "Actuation model" and "Actuator shortcuts".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/io/mjcf_frame.h"
#include "murosimf/io/mjcf_names.h"
#include "murosimf/model/servo.h"

namespace murosimf::io {

/// Servos by joint name. Several actuators at one joint add what the others lack. Throws SetupError for an unknown
/// joint; an actuator without a joint is refused unless `lenient`, then a line in `warnings`.
[[nodiscard]] std::map<std::string, Servo> read_actuators(const XmlElement& root, const MjcfDefaults& defaults,
                                                          const MjcfCompiler& compiler, const MjcfNames& names,
                                                          bool lenient, std::vector<std::string>& warnings);

}  // namespace murosimf::io
