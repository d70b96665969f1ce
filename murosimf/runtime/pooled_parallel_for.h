/// pooled_parallel_for.h - the threads of a pool as ParallelFor of an algorithm that runs alone in its wave.
#pragma once

#include <utility>
#include <vector>

#include "murosimf/model/parallel_for.h"
#include "murosimf/runtime/thread_affinity.h"
#include "murosimf/runtime/thread_pool.h"

namespace murosimf {

class PooledParallelFor final : public ParallelFor {
 public:
  /// The pool outlives it.
  explicit PooledParallelFor(ThreadPool& pool)
      : pool_(pool), thread_affinity_(static_cast<std::size_t>(pool.threads())) {}

  /// Where the entities are at home from now on.
  void use(ThreadAffinity thread_affinity) { thread_affinity_ = std::move(thread_affinity); }
  [[nodiscard]] const ThreadAffinity& thread_affinity() const { return thread_affinity_; }

 private:
  void share_out(std::span<const Entity* const> entities, Call call, void* context) noexcept override;

  ThreadPool& pool_;
  ThreadAffinity thread_affinity_;
  std::vector<std::size_t> order_, ends_;  // of the present call: entities by threads, and where these end
};

}  // namespace murosimf
