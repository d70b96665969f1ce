#include "murosimf/model/column_store.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf {

ColumnBase* ColumnStore::find(std::string_view property) const {
  const auto found = columns_.find(property);
  if (found == columns_.end()) return nullptr;
  assert(may_read(*found->second) && "a column that the algorithm has not declared");
  return found->second.get();
}

bool ColumnStore::has(const ColumnBase* column) const {
  return std::ranges::any_of(columns_, [&](const auto& item) { return item.second.get() == column; });
}

void ColumnStore::drop(const ColumnBase* column) {
  std::erase_if(columns_, [&](const auto& item) { return item.second.get() == column; });
}

void ColumnStore::refuse_new(const PropertyInfo& info) const {
  throw SetupError(
      fmt::format("entity '{}': property '{}' is asked for after the columns were frozen; ask while setting up", owner_,
                  info.name));
}

void ColumnStore::refuse_type(const PropertyInfo& info) const {
  throw SetupError(fmt::format("entity '{}': two properties of different type are called '{}'", owner_, info.name));
}

}  // namespace murosimf
