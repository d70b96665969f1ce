#include "murosimf/runtime/pooled_parallel_for.h"

#include <array>
#include <cstdint>

#include "murosimf/math/assert.h"

namespace murosimf {

void PooledParallelFor::share_out(std::span<const Entity* const> entities, Call call, void* context) noexcept {
  const auto kind = reinterpret_cast<std::uintptr_t>(call) + entities.size();
  if (!pool_.shares()) {
    const std::array<std::size_t, 2> ends{entities.size() / 2,
                                          entities.size()};  // as if two of them were at home elsewhere
    return pool_.alone(std::span<const std::size_t>(ends), kind, [&] {
      for (std::size_t i = 0; i < entities.size(); ++i) call(context, i);
    });
  }
  order_.clear();
  ends_.clear();
  for (std::size_t thread = 0; thread < static_cast<std::size_t>(pool_.threads()); ++thread) {
    for (std::size_t i = 0; i < entities.size(); ++i) {
      if (thread_affinity_.of(*entities[i]) == thread) order_.push_back(i);
    }
    ends_.push_back(order_.size());
  }
  MUROSIMF_ASSERT(order_.size() == entities.size() && "every entity is at home at one thread");
  pool_.for_each(std::span<const std::size_t>(ends_), kind, [&](std::size_t i) { call(context, order_[i]); });
}

}  // namespace murosimf
