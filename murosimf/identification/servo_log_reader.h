/// servo_log_reader.h - reader of recordings of a servo with a pendulum, in the JSON format of github.com/Rhoban/bam.
///
/// One object with mass [kg], length [m], kp (the P gain in the servo's register), and optionally arm_mass [kg], motor
/// and trajectory (names); and the list `entries`, each with timestamp [s], position [rad], speed [rad/s],
/// input_volts [V], goal_position [rad] and torque_enable. Other fields are skipped. Time stamps need not be on a grid.
#pragma once

#include <filesystem>
#include <vector>

#include "murosimf/identification/servo_log.h"

namespace murosimf::identification {

/// Throws SetupError with file (and line or entry): no JSON, missing field, wrong type, number that is not finite or
/// impossible, fewer than two entries, time stamps that do not grow.
[[nodiscard]] identification::ServoLog read_servo_log(const std::filesystem::path& file);

/// The logs of `names`, in this order: a file is itself, a folder all its *.json in alphabetical order. Throws
/// SetupError for missing files, a folder without logs, and as above.
[[nodiscard]] std::vector<identification::ServoLog> read_servo_logs(const std::vector<std::string>& names);

}  // namespace murosimf::identification
