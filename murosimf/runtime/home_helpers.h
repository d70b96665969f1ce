/// home_helpers.h - the threads of a simulation as helpers of one algorithm that runs alone in its wave.
#pragma once

#include <utility>
#include <vector>

#include "murosimf/model/helpers.h"
#include "murosimf/runtime/homes.h"
#include "murosimf/runtime/thread_pool.h"

namespace murosimf {

class HomeHelpers final : public Helpers {
 public:
  /// The pool outlives it.
  explicit HomeHelpers(ThreadPool& pool) : pool_(pool), homes_(static_cast<std::size_t>(pool.threads())) {}

  /// Where the entities are at home from now on.
  void use(Homes homes) { homes_ = std::move(homes); }
  [[nodiscard]] const Homes& homes() const { return homes_; }

 private:
  void share_out(std::span<const Entity* const> entities, Call call, void* context) noexcept override;

  ThreadPool& pool_;
  Homes homes_;
  std::vector<std::size_t> order_, ends_;  // of the present call: entities by threads, and where these end
};

}  // namespace murosimf
