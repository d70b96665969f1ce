/// signal_vector.h - the first three numbers of a signal as a vector.
#pragma once

#include "murosimf/control_software/robot_port.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/vec3.h"

namespace murosimf::dds {

[[nodiscard]] inline Vec3d vector_of(const murosimf_signal& signal) {
  MUROSIMF_ASSERT(signal.count >= 3);
  return {signal.values[0], signal.values[1], signal.values[2]};
}

}  // namespace murosimf::dds
