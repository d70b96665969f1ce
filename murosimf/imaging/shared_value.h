/// shared_value.h - what equal cameras of a process have in common: worked out once, and kept as long as somebody uses it.
#pragma once

#include <map>
#include <memory>
#include <mutex>

namespace murosimf::imaging {

/// What make() returns, which must follow from `key`: the same object for equal keys while somebody holds it. Each T and Key
/// have keys of their own. Whoever asks meanwhile waits.
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
