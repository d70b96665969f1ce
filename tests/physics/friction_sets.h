/// friction_sets.h - one servo with every model of gear friction.
#pragma once

#include <string>
#include <vector>

#include "murosimf/model/servo.h"

namespace murosimf::test {

struct FrictionSet {
  std::string name;
  Servo servo;
};

/// M6 of an XL-330, with every term; its motor is in friction_sets.
inline constexpr GearFriction published_m6{.coulomb = 0.00477,
                                           .viscous = 0.00536,
                                           .stribeck = 0.00468,
                                           .stribeck_rate = 2.890,
                                           .stribeck_exponent = 8.683,
                                           .motor_load = 0.2668,
                                           .external_load = 9e-6,
                                           .stribeck_motor_load = 1e-5,
                                           .stribeck_external_load = 0.0808,
                                           .quadratic_motor_load = 0.00997,
                                           .quadratic_external_load = 0.00490};

/// An XL-330 at 7.5 V with P gain 400. M1, M4 and M6 are published together with their motors (Duclusaud et al., ICRA 2025,
/// parameter files of github.com/Rhoban/bam); the others leave away what their model does not have.
inline std::vector<FrictionSet> friction_sets() {
  const auto servo = [](double k_t, double R, double J, const GearFriction& friction) {
    const double V = 7.5, stall = k_t * V / R;
    return Servo{.type = "xl330",
                 .voltage = V,
                 .stall_torque = stall,
                 .no_load_speed = V / k_t,
                 .position_gain = 0.002877 * 400 * stall,
                 .firmware_gain = 400,
                 .rotor_inertia = J,
                 .friction = friction};
  };
  const GearFriction m1{.coulomb = 0.01283, .viscous = 0.00366};
  const GearFriction m4{.coulomb = 0.00876,
                        .viscous = 0.00462,
                        .stribeck = 8e-17,
                        .stribeck_rate = 2.558,
                        .stribeck_exponent = 0.760,
                        .motor_load = 0.0680,
                        .external_load = 0.0680,
                        .stribeck_motor_load = 0.0738,
                        .stribeck_external_load = 0.0738};
  GearFriction m2 = m1, m3 = m1, m5 = published_m6;
  m2.stribeck = 0.00468;
  m2.stribeck_rate = 2.890;
  m2.stribeck_exponent = 8.683;
  m3.motor_load = m3.external_load = 0.0680;
  m5.quadratic_motor_load = m5.quadratic_external_load = 0;
  return {{"M1", servo(0.3867, 4.017, 0.001814, m1)}, {"M2", servo(0.3867, 4.017, 0.001814, m2)},
          {"M3", servo(0.3867, 4.017, 0.001814, m3)}, {"M4", servo(0.3862, 3.403, 0.001895, m4)},
          {"M5", servo(0.3660, 2.811, 0.001808, m5)}, {"M6", servo(0.3660, 2.811, 0.001808, published_m6)}};
}

}  // namespace murosimf::test
