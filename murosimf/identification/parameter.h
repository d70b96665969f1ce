/// parameter.h - the numbers of a servo that a fit determines, and the friction models that use them.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "murosimf/multibody/servo/servo_pendulum.h"

namespace murosimf::identification {

/// One number of a servo. Search bounds are wide: they only exclude impossible servos.
struct Parameter {
  std::string_view name;  ///< as in servo files where there is one
  std::string_view unit;
  double low, high;
  bool by_ratio;  ///< searched by ratios, not by differences: a positive number of unknown size
  void (*set)(multibody::BenchServo&, double);
  double (*get)(const multibody::BenchServo&);
};

/// Friction model M1 to M6 (multibody/servo/gear_friction.h) and its parameters, those of the motor first.
struct FrictionModel {
  std::string_view name, meaning;
  std::vector<const Parameter*> parameters;
};

[[nodiscard]] std::span<const FrictionModel> friction_models();

/// The model called "m1" to "m6". Throws SetupError.
[[nodiscard]] const FrictionModel& friction_model(std::string_view name);

/// All parameters of all models. Load friction of M3 and M4 is one parameter for motor and load.
[[nodiscard]] std::span<const Parameter> parameters();

/// Place of a parameter's value between its bounds, 0 to 1, and back.
[[nodiscard]] double place_of(const Parameter& parameter, double value);
[[nodiscard]] double value_at(const Parameter& parameter, double place);

}  // namespace murosimf::identification
