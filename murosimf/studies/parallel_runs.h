/// parallel_runs.h - many independent runs, some at a time.
#pragma once

#include <cstddef>
#include <functional>

namespace murosimf::studies {

/// Calls run(i) for all i below `count` from up to `threads` threads, in their order as far as threads are free. Rethrows the first
/// exception when all have come to rest; then, and once `stop` returns true, no new ones begin.
void run_in_parallel(std::size_t count, int threads, const std::function<bool()>& stop,
                     const std::function<void(std::size_t)>& run);

}  // namespace murosimf::studies
