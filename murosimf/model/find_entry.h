/// find_entry.h - looking an entry of a list up by its name.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "murosimf/model/error.h"

namespace murosimf {

/// Names of all entries, in their order.
template <class Entry>
[[nodiscard]] std::vector<std::string_view> entry_names(std::span<const Entry> entries) {
  std::vector<std::string_view> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}

/// The entry with this name, or SetupError with the nearest name. `kind` ("level") is for the message.
template <class Entry>
[[nodiscard]] const Entry& find_entry(std::span<const Entry> entries, std::string_view kind, std::string_view name) {
  for (const Entry& entry : entries) {
    if (entry.name == name) return entry;
  }
  throw SetupError(unknown_name(kind, name, entry_names(entries)));
}

}  // namespace murosimf
