/// synthetic.h - recordings of a servo of known numbers, made by simulation in fine steps.
#pragma once

#include <cmath>
#include <functional>

#include "murosimf/identification/servo_log.h"
#include "murosimf/math/scalar.h"
#include "murosimf/multibody/servo/servo_pendulum.h"

namespace murosimf::synthetic {

inline constexpr double duty_per_gain = 0.002877;  ///< [1/rad] of an XL-330

struct Course {
  std::string name;
  std::function<double(double)> goal;   ///< [rad] at a time [s]
  std::function<bool(double)> enabled;  ///< at a time [s]
};

inline bool always(double /*t*/) { return true; }

/// The bench's courses: two sines, up and down, a chirp; and a swing with the torque switched off on both sides.
inline Course two_sines() {
  return {"sin_sin", [](double t) { return pi / 2 * std::sin(t) + 0.5 * std::sin(5 * t) * std::sin(2 * t); }, always};
}
inline Course up_and_down() {
  return {"up_and_down",
          [](double t) {
            return t < 3 ? pi / 2 * (t * t * (9 - 2 * t) / 27) : pi / 2 * (1 - 0.2 * std::sin((t - 3) / 2));
          },
          always};
}
inline Course chirp() {
  return {"sin_time_square", [](double t) { return std::sin(t * t); }, always};
}
inline Course drops() {
  return {"lift_and_drop", [](double t) { return t < 3 ? 1.2 : -1.2; },
          [](double t) { return std::fmod(t, 3.0) < 1.5; }};
}

struct Setting {
  double gain = 400, voltage = 7.4, duration = 6, period = 5e-3, mass = 0.49;
};

/// The record of a perfect encoder, every `period`, or every 5 to 8 ms if that is 0. With each entry the driver sends goal and
/// torque switch, which the servo holds until the next.
inline identification::ServoLog record(const multibody::BenchServo& servo, const Course& course,
                                       const Setting& setting = {}) {
  constexpr double fine = 2.5e-4, length = 0.1;
  identification::ServoLog log{.name = course.name,
                               .motor = "xl330",
                               .trajectory = course.name,
                               .mass = setting.mass,
                               .length = length,
                               .arm_mass = 0,
                               .firmware_gain = setting.gain,
                               .samples = {}};
  const multibody::Bench<double> bench{.inertia = setting.mass * length * length,
                                       .weight = setting.mass * 9.80665 * length,
                                       .gain = duty_per_gain * setting.gain};
  multibody::BenchState<double> state;
  multibody::BenchInput<double> input{.goal = 0, .voltage = setting.voltage, .enabled = 1};
  double next = 0;
  for (int k = 0; k * fine <= setting.duration; ++k) {
    const double t = k * fine;
    if (t >= next - 1e-9) {
      const bool on = course.enabled(t);
      input.goal = course.goal(t);
      input.enabled = on ? 1 : 0;
      log.samples.push_back({t, state.position, state.rate, setting.voltage, input.goal, on});
      next = t + (setting.period > 0 ? setting.period : 5e-3 + 1e-3 * static_cast<double>(log.samples.size() % 4));
    }
    multibody::advance(servo, bench, input, fine, state);
  }
  return log;
}

}  // namespace murosimf::synthetic
