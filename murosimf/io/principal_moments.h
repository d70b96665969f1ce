/// principal_moments.h - whether numbers are the inertia of a solid body.
#pragma once

#include <array>

#include "murosimf/math/mat3.h"

namespace murosimf::io {

/// Principal moments in rising order [kg m^2].
[[nodiscard]] std::array<double, 3> principal_moments(const SymMat3d& inertia);

/// True if the two smaller moments together are less than the largest, by more than files round: no solid body has that.
[[nodiscard]] bool breaks_triangle_inequality(const std::array<double, 3>& moments);

}  // namespace murosimf::io
