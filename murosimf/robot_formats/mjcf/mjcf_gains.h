/// mjcf_gains.h - the force of an actuator of an MJCF file by its control, as in MuJoCo.
///
///     force = gainprm[0] u + biasprm . (1, length, velocity)
///
/// `general` gives these numbers, the shortcuts `position`, `velocity` and `motor` set them. All of them share the default actuator
/// of a class, so settings are applied one after another, in the order of the file.
/// Source: MuJoCo documentation, "Actuator shortcuts" and "default".
#pragma once

#include <array>
#include <string>
#include <vector>

#include "murosimf/files/xml_element.h"

namespace murosimf::robot_formats::mjcf {

struct MjcfGains {
  double gain = 1;               ///< [N m per unit of the control | N] gainprm[0]
  std::array<double, 3> bias{};  ///< [N m, N m/rad, N m s/rad] biasprm; none unless biastype is affine
  double time_constant = 0;      ///< [s] of the filter between control and force; 0: none
  double damping_ratio = 0;      ///< [1] of a position actuator, instead of bias[2]; 0: none
  double inherited_range = 0;    ///< [1] share of the joint's range that bounds the control; 0: ctrlrange holds
  bool integrates = false;       ///< the control is the rate of the input of the force
  std::string obstacle;          ///< why it is not simulated; empty: it is
};

/// `settings`: of the default classes, outermost first; then the actuator itself. Throws SetupError for impossible numbers.
[[nodiscard]] MjcfGains read_gains(const std::vector<files::XmlElement>& settings, const files::XmlElement& actuator);

}  // namespace murosimf::robot_formats::mjcf
