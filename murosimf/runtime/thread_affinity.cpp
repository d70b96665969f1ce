#include "murosimf/runtime/thread_affinity.h"

#include <algorithm>
#include <numeric>

#include "murosimf/math/assert.h"

namespace murosimf {

void ThreadAffinity::share_out(std::span<const Entity* const> alike) {
  MUROSIMF_ASSERT(!load_.empty());
  std::vector<std::size_t> by_load(load_.size());
  std::iota(by_load.begin(), by_load.end(), std::size_t{0});
  std::stable_sort(by_load.begin(), by_load.end(), [&](std::size_t a, std::size_t b) { return load_[a] < load_[b]; });

  const std::size_t each = alike.size() / load_.size(), more = alike.size() % load_.size();
  std::vector<std::size_t> shares(load_.size(), each);
  for (std::size_t i = 0; i < more; ++i) ++shares[by_load[i]];
  std::size_t next = 0;
  for (std::size_t thread = 0; thread < shares.size(); ++thread) {
    load_[thread] += shares[thread];
    for (std::size_t i = 0; i < shares[thread]; ++i) home_[alike[next++]] = thread;
  }
  MUROSIMF_ASSERT(next == alike.size());
}

std::size_t ThreadAffinity::of(const Entity& entity) const {
  const auto found = home_.find(&entity);
  return found == home_.end() ? 0 : found->second;
}

}  // namespace murosimf
