#include "murosimf/sensors/range.h"

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::sensors {

const Range& checked(const Range& range) {
  // user input: rejected with a message
  if (range.min < range.max) return range;
  throw SetupError(fmt::format("range_min is {} and range_max {}: nothing is between them", range.min, range.max));
}

}  // namespace murosimf::sensors
