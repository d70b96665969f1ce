/// servo_description.h - a servo while it is read from TOML: the numbers of a ready-made one, then those of a robot.
///
/// Only for .cpp files: it brings toml++ in. The keys are those of docs/robots.md, "Servos"; a table [fit] (fitted_servo.h) is skipped.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/files/toml_reader.h"
#include "murosimf/model/servo.h"

namespace murosimf::component_files {

class ServoDescription {
 public:
  /// A servo without numbers; `type` becomes Servo::type.
  explicit ServoDescription(std::string type) { servo_.type = std::move(type); }
  /// A complete servo, to be changed.
  explicit ServoDescription(const Servo& servo);

  /// Applies the law and the numbers of `table`, which replace earlier ones. If it changes the voltage of earlier
  /// numbers, then stall torque, no-load rate and position gain follow in proportion, because a duty cycle is a share
  /// of the supply. Keys in `others` are the caller's. Throws SetupError with file:line:column for unknown keys and
  /// laws, impossible numbers, and keys without meaning for the law.
  void take(const toml::table& table, const std::vector<std::string_view>& others = {});

  /// The servo; torque_limit = current_limit voltage / no_load_speed. Throws SetupError at `source`, where the servo
  /// called `name` stands, if it lacks a number that its law needs, or cannot move.
  [[nodiscard]] Servo finish(std::string_view name, const toml::source_region& source) const;

 private:
  void take_law(const toml::table& table);
  void take_number(const toml::key& key, const toml::node& node);
  void scale_to(double voltage, const toml::source_region& source);

  Servo servo_;
  std::optional<double> current_limit_;       ///< [A]
  std::set<std::string, std::less<>> given_;  ///< keys so far
};

/// The description of a ready-made servo: the file `<type>.toml` in `beside` or in servos/, which must be complete. Throws
/// SetupError: with the nearest name if there is no such file, with file:line:column if something is wrong in it.
[[nodiscard]] ServoDescription read_servo_description(std::string_view type, const std::filesystem::path& beside);

}  // namespace murosimf::component_files
