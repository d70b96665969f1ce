#include "murosimf/world/column.h"

#include <cmath>
#include <cstring>

#include "murosimf/math/assert.h"

namespace murosimf {

template class Column<double>;
template class Column<Vec3d>;
template class Column<Mat3d>;

std::size_t count_not_finite(const void* doubles, std::size_t count) noexcept {
  std::size_t found = 0;
  MUROSIMF_ASSERT(doubles || count == 0);
  for (std::size_t i = 0; i < count; ++i) {
    // by memcpy: the rows are of another type
    double number = 0;
    std::memcpy(&number, static_cast<const unsigned char*>(doubles) + i * sizeof(double), sizeof(double));
    if (!std::isfinite(number)) ++found;
  }
  return found;
}

}  // namespace murosimf
