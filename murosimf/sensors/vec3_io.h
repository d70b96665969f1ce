/// vec3_io.h - vectors as rows of numbers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "murosimf/math/vec3.h"

namespace murosimf::sensors {

/// Labels of a vector's numbers.
inline std::vector<std::string> xyz() { return {"x", "y", "z"}; }

inline void write(const Vec3d& v, std::span<double> values) noexcept {
  values[0] = v.x;
  values[1] = v.y;
  values[2] = v.z;
}

inline Vec3d vector_of(std::span<const double> values) noexcept { return {values[0], values[1], values[2]}; }

}  // namespace murosimf::sensors
