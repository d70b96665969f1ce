#include "murosimf/world/column_store.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf {

ColumnBase* ColumnStore::find(std::string_view property) const {
  const auto found = columns_.find(property);
  if (found == columns_.end()) return nullptr;
  MUROSIMF_ASSERT(may_read(*found->second) && "a column that the algorithm has not declared");
  return found->second.get();
}

bool ColumnStore::has(const ColumnBase* column) const {
  return std::ranges::any_of(columns_, [&](const auto& item) { return item.second.get() == column; });
}

std::shared_ptr<ColumnBase> ColumnStore::share(std::string_view property) const {
  const auto found = columns_.find(property);
  return found == columns_.end() ? nullptr : found->second;
}

void ColumnStore::drop(const ColumnBase* column) {
  std::erase_if(dropped_, [](const auto& one) { return one.expired(); });
  // a shared column survives: a later request for the property returns the same column, so views stay valid
  std::erase_if(columns_, [&](const auto& item) {
    if (item.second.get() != column) return false;
    if (item.second.use_count() > 1) dropped_.push_back(item.second);
    return true;
  });
}

/// The dropped column of this property that is still shared, with new values. Null if there is none.
std::shared_ptr<ColumnBase> ColumnStore::dropped(const PropertyInfo& info, std::type_index type) {
  for (const auto& one : dropped_) {
    auto column = one.lock();
    if (!column || column->info().name != info.name || column->type() != type) continue;
    column->renew();
    std::erase_if(dropped_, [&](const auto& other) { return other.lock() == column; });
    return column;
  }
  return nullptr;
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
