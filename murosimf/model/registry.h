/// registry.h - entries with a name that may grow while the program runs: what comes with the library, then what plug-ins add.
///
/// The owner of a registry adds the library's own entries by plain calls: entries that add themselves before `main` would be
/// missing wherever the linker drops their file as unused. An entry is a struct with a member `std::string name`; it owns all its
/// data (std::string, std::function), since it may come from a library that was loaded later.
#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <iterator>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf {

/// References to entries stay valid as long as the registry. Any number of threads may read while one adds: they see the new
/// entry or not, and need no lock.
template <class Entry>
class Registry {
  struct Node {
    Entry entry;
    std::atomic<const Node*> next = nullptr;
    explicit Node(Entry what) : entry(std::move(what)) {}
  };

 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Entry;
    using difference_type = std::ptrdiff_t;
    using pointer = const Entry*;
    using reference = const Entry&;

    Iterator() = default;
    explicit Iterator(const Node* node) : node_(node) {}
    reference operator*() const {
      MUROSIMF_ASSERT(node_);
      return node_->entry;
    }
    pointer operator->() const {
      MUROSIMF_ASSERT(node_);
      return &node_->entry;
    }
    Iterator& operator++() {
      MUROSIMF_ASSERT(node_);
      node_ = node_->next.load(std::memory_order_acquire);
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator&) const = default;

   private:
    const Node* node_ = nullptr;
  };

  /// `kind` is what messages call an entry: "level". Throws as `add` does.
  explicit Registry(std::string kind, std::vector<Entry> entries = {}) : kind_(std::move(kind)) {
    for (Entry& entry : entries) add(std::move(entry));
  }
  Registry(const Registry&) = delete;
  Registry& operator=(const Registry&) = delete;

  /// Appends an entry. Throws SetupError, and adds nothing, if the name is empty or in use.
  const Entry& add(Entry entry) {
    const std::lock_guard lock(adding_);
    if (entry.name.empty()) throw SetupError("a " + kind_ + " without a name cannot be added");
    if (look_for(entry.name))
      throw SetupError("there is a " + kind_ + " '" + entry.name + "' already; choose another name");
    const Node& added = nodes_.emplace_back(std::move(entry));
    // release: a reader that sees the node sees its entry
    (last_ ? last_->next : first_).store(&added, std::memory_order_release);
    last_ = &nodes_.back();
    return added.entry;
  }

  /// Null if there is none of that name.
  [[nodiscard]] const Entry* look_for(std::string_view name) const {
    for (const Entry& entry : *this) {
      if (entry.name == name) return &entry;
    }
    return nullptr;
  }

  /// Throws SetupError with the nearest name if there is none of that name.
  [[nodiscard]] const Entry& find(std::string_view name) const {
    if (const Entry* entry = look_for(name)) return *entry;
    throw SetupError(unknown_name(kind_, name, names()));
  }

  /// Of all entries, in the order in which they were added; valid as long as the registry.
  [[nodiscard]] std::vector<std::string_view> names() const {
    std::vector<std::string_view> all;
    for (const Entry& entry : *this) all.push_back(entry.name);
    return all;
  }

  [[nodiscard]] Iterator begin() const { return Iterator(first_.load(std::memory_order_acquire)); }
  [[nodiscard]] Iterator end() const { return Iterator(); }

 private:
  std::string kind_;
  std::mutex adding_;
  std::deque<Node> nodes_;  // never moves its elements
  std::atomic<const Node*> first_ = nullptr;
  Node* last_ = nullptr;
};

/// Registry::names, for lists of either kind (find_entry.h).
template <class Entry>
[[nodiscard]] std::vector<std::string_view> entry_names(const Registry<Entry>& registry) {
  return registry.names();
}

/// Registry::find with another word for the kind in its message.
template <class Entry>
[[nodiscard]] const Entry& find_entry(const Registry<Entry>& registry, std::string_view kind, std::string_view name) {
  if (const Entry* entry = registry.look_for(name)) return *entry;
  throw SetupError(unknown_name(kind, name, registry.names()));
}

}  // namespace murosimf
