/// column_store.h - the columns of one entity, by the names of their properties.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "murosimf/math/assert.h"
#include "murosimf/world/access_guard.h"
#include "murosimf/world/column.h"

namespace murosimf {

class ColumnStore {
 public:
  /// `owner` is the entity's name, for messages; `objects` are the rows of a column that every object has.
  ColumnStore(std::string owner, std::size_t objects) : owner_(std::move(owner)), objects_(objects) {}

  /// The column of a property, created if need be. Throws SetupError if the columns are frozen, or if another
  /// property of the same name has another type.
  template <class T>
  Column<T>& column(const Property<T>& property);
  /// Null if there is none, or one of another type.
  template <class T>
  [[nodiscard]] const Column<T>* find(const Property<T>& property) const;
  [[nodiscard]] ColumnBase* find(std::string_view property) const;

  /// Shared ownership: the column lives as long as it has owners, also if it is dropped here. Null if there is none.
  [[nodiscard]] std::shared_ptr<ColumnBase> share(std::string_view property) const;

  [[nodiscard]] bool has(const ColumnBase* column) const;

  /// In the order of their names: pairs of name and column.
  [[nodiscard]] auto begin() const { return columns_.begin(); }
  [[nodiscard]] auto end() const { return columns_.end(); }
  [[nodiscard]] std::size_t size() const { return columns_.size(); }
  [[nodiscard]] bool empty() const { return columns_.empty(); }

  /// Allows no more columns; spans stay valid for good.
  void freeze() { frozen_ = live_ = true; }
  /// Columns can be added again, as before freeze().
  void thaw() { frozen_ = false; }
  /// Whether they have ever been frozen: the values are those of a run.
  [[nodiscard]] bool live() const { return live_; }
  /// Removes a column, to which no spans may exist. Does nothing if it is not one of these. A shared column becomes
  /// the same column again, with new values, when its property is requested again.
  void drop(const ColumnBase* column);

 private:
  [[nodiscard]] std::shared_ptr<ColumnBase> dropped(const PropertyInfo& info, std::type_index type);
  [[noreturn]] void refuse_new(const PropertyInfo& info) const;
  [[noreturn]] void refuse_type(const PropertyInfo& info) const;

  std::string owner_;
  std::size_t objects_;
  std::map<std::string, std::shared_ptr<ColumnBase>, std::less<>> columns_;
  std::vector<std::weak_ptr<ColumnBase>> dropped_;  // those that were shared then
  bool frozen_ = false, live_ = false;
};

// ---- definitions ----

template <class T>
Column<T>& ColumnStore::column(const Property<T>& property) {
  auto found = columns_.find(property.name);
  if (found == columns_.end()) {
    if (frozen_) refuse_new(property);
    const std::size_t rows = of_every_object(property.scope) ? objects_ : 1;
    auto created = dropped(property, typeid(T));
    if (!created) created = Column<T>::make(property, rows);
    found = columns_.emplace(std::string(property.name), std::move(created)).first;
  }
  if (found->second->type() != typeid(T)) refuse_type(property);
  MUROSIMF_ASSERT(may_write(*found->second) && "a column that the algorithm has not declared as written");
  MUROSIMF_ASSERT(found->second->rows() == (of_every_object(property.scope) ? objects_ : 1));
  return static_cast<Column<T>&>(*found->second);
}

template <class T>
const Column<T>* ColumnStore::find(const Property<T>& property) const {
  const ColumnBase* found = find(property.name);
  return found && found->type() == typeid(T) ? static_cast<const Column<T>*>(found) : nullptr;
}

}  // namespace murosimf
