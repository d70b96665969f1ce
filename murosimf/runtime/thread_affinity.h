/// thread_affinity.h - which thread does what of which entity: always the same one, so that what the algorithms of an entity touch stays in
/// its caches.
#pragma once

#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

namespace murosimf {

class Entity;

class ThreadAffinity {
 public:
  explicit ThreadAffinity(std::size_t threads) : load_(threads) {}

  /// Entities that take equally long: shares of neighbors, as equal as possible, the larger ones to the threads with the least so far.
  void share_out(std::span<const Entity* const> alike);

  /// The number of the thread. 0, the calling one, of entities that were not shared out.
  [[nodiscard]] std::size_t of(const Entity& entity) const;

 private:
  std::vector<std::size_t> load_;  // entities of each thread
  std::unordered_map<const Entity*, std::size_t> home_;
};

}  // namespace murosimf
