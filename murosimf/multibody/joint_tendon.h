/// joint_tendon.h - a tendon over several joints of a robot: a slider at the base that moves nothing of its own and stands at the tendon's
/// length
///
///     q = sum c_i q_i
///
/// so that what acts along the tendon (spring, damper, friction, rotor, range, servo) is what acts in that joint: a force F there is a
/// torque c_i F at joint i, by the row of coupling_forces.h between them.
/// Source: MuJoCo documentation, "Tendon", fixed tendons.
#pragma once

#include <string>
#include <vector>

#include "murosimf/model/property.h"

namespace murosimf {

struct JointTendon {
  struct Part {
    std::string joint;       ///< name of a joint of the same model
    double coefficient = 1;  ///< [m/rad | 1] c_i; not 0
  };
  std::vector<Part> parts;
};

}  // namespace murosimf

namespace murosimf::properties {

inline constexpr Property<JointTendon> joint_tendon{
    {"joint_tendon", "-", "joint", "the joints whose weighted sum this one stands at"}};

}  // namespace murosimf::properties
