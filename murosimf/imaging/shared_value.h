/// shared_value.h - common data of equal cameras of a process: computed once, and kept as long as they are in use.
#pragma once

#include <map>
#include <memory>
#include <mutex>

namespace murosimf::imaging {

/// Result of make(), which must depend on `key` only: the same object for equal keys while it is in use. Each T and Key
/// have keys of their own. Concurrent calls wait.
template <class T, class Key, class Make>
[[nodiscard]] std::shared_ptr<const T> shared_value(const Key& key, const Make& make) {
  static std::mutex mutex;
  static std::map<Key, std::weak_ptr<const T>> known;
  const std::scoped_lock lock(mutex);
  if (const auto found = known.find(key); found != known.end()) {
    if (auto there = found->second.lock()) return there;
  }
  std::erase_if(known, [](const auto& item) { return item.second.expired(); });
  auto made = std::make_shared<const T>(make());
  known[key] = made;
  return made;
}

}  // namespace murosimf::imaging
