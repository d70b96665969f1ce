/// shard.h - a part of the runs of an experiment: every n-th one.
#pragma once

#include <cstddef>
#include <string>

namespace murosimf::studies {

/// The runs k - 1, k - 1 + n, k - 1 + 2 n, ...: neighboring runs, which take similar times, are in different shards.
struct Shard {
  std::size_t number = 1;  ///< k, from 1; 0: any that no other process works on
  std::size_t of = 1;      ///< n

  [[nodiscard]] bool has(std::size_t run) const { return run % of == number - 1; }
};

/// "3/8", or "any/8"; n up to 1 000 000. Throws SetupError.
[[nodiscard]] Shard parse_shard(const std::string& text);

}  // namespace murosimf::studies
