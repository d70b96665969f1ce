#include "murosimf/studies/parallel_runs.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "murosimf/math/assert.h"

namespace murosimf::studies {

void run_in_parallel(std::size_t count, int threads, const std::function<bool()>& stop,
                     const std::function<void(std::size_t)>& run) {
  MUROSIMF_ASSERT(static_cast<bool>(run));
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex mutex;
  std::exception_ptr first;
  const auto work = [&] {
    while (!failed && !(stop && stop())) {
      const std::size_t i = next++;
      if (i >= count) return;
      try {
        run(i);
      } catch (...) {
        // The others often follow from the first failure.
        const std::lock_guard lock(mutex);
        if (!first) first = std::current_exception();
        failed = true;
      }
    }
  };
  // This thread works, too.
  std::vector<std::thread> others;
  const std::size_t wanted = std::min(count, static_cast<std::size_t>(std::max(threads, 1)));
  try {
    while (others.size() + 1 < wanted) others.emplace_back(work);
  } catch (const std::system_error&) {  // as many as the system gives
  }
  work();
  for (std::thread& other : others) other.join();
  if (first) std::rethrow_exception(first);
}

}  // namespace murosimf::studies
