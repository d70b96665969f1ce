/// dice.h - the random draws of one picture: a pure function of seed, purpose and number of the picture, in any order and thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/random.h"

namespace murosimf::dataset {

/// Numbers from low to high; one number if both are equal.
struct Range {
  double low = 0, high = 0;
};

class Dice {
 public:
  /// Other purposes ("light", "ball") have independent draws.
  Dice(std::uint64_t seed, std::string_view purpose, std::uint64_t picture)
      : stream_(seed, fmt::format("dataset/{}/{}", purpose, picture)) {}

  [[nodiscard]] double uniform() { return stream_.uniform(next_++); }
  [[nodiscard]] double in(const Range& range) { return range.low + uniform() * (range.high - range.low); }
  [[nodiscard]] bool chance(double share) { return uniform() < share; }
  /// 0 to count - 1.
  [[nodiscard]] std::size_t one_of(std::size_t count) {
    MUROSIMF_ASSERT(count > 0);
    return static_cast<std::size_t>(uniform() * static_cast<double>(count));
  }

 private:
  RandomStream stream_;
  std::uint64_t next_ = 0;
};

}  // namespace murosimf::dataset
