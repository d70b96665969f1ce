/// foreign_code.h - code that the program has loaded while it runs (plug-ins), and calls of its algorithms, which may crash.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstring>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <utility>

#include "murosimf/world/algorithm.h"

namespace murosimf {

struct ForeignCode {
  /// Makes a call that belongs to this code; `what` is for messages: "circle of walker".
  using Caller = void (*)(const ForeignCode& code, const std::string& what, const std::function<void()>& call);

  std::string name{};                   ///< "plug-in 'own_plugin.so'"
  std::span<const std::byte> memory{};  ///< where it lies, tables of virtual functions included
  Caller caller = nullptr;
  const ForeignCode* next = nullptr;  ///< the code that was loaded earlier

  /// Adds code until the end of the program. Any thread.
  static void add(ForeignCode code) {
    static std::mutex adding;
    const std::lock_guard lock(adding);
    code.next = newest.load();
    newest.store(new ForeignCode(std::move(code)));
  }
  /// The code to which an address belongs; null: none. May be called in signal handlers.
  [[nodiscard]] static const ForeignCode* at(const void* address) noexcept {
    const auto* const place = static_cast<const std::byte*>(address);
    for (const ForeignCode* code = newest.load(); code; code = code->next) {
      if (place >= code->memory.data() && place < code->memory.data() + code->memory.size()) return code;
    }
    return nullptr;
  }
  /// The code that has the algorithm's class; null: the program. By the table of virtual functions, with which objects begin.
  [[nodiscard]] static const ForeignCode* of(const Algorithm& algorithm) noexcept {
    if (!newest.load(std::memory_order_relaxed)) return nullptr;
    const void* table = nullptr;
    std::memcpy(&table, static_cast<const void*>(&algorithm), sizeof table);
    return at(table);
  }

  static inline std::atomic<const ForeignCode*> newest{nullptr};
};

}  // namespace murosimf
