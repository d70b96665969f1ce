/// entity.h - one robot, ball or environment in a simulation: a name, a model, and columns of variable properties.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "murosimf/model/column_store.h"
#include "murosimf/model/entity_options.h"
#include "murosimf/model/model.h"
#include "murosimf/model/object_access.h"

namespace murosimf {

class Entity {
 public:
  /// Throws SetupError if the name is empty or has characters other than letters, digits, '_' and '-'.
  Entity(std::string name, ModelPtr model, EntityOptions options = {});

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const ModelPtr& model_ptr() const { return model_; }
  [[nodiscard]] const EntityOptions& options() const { return options_; }

  [[nodiscard]] ColumnStore& columns() { return columns_; }
  [[nodiscard]] const ColumnStore& columns() const { return columns_; }
  /// As of its columns (column_store.h).
  template <class T>
  Column<T>& column(const Property<T>& property) {
    return columns_.column(property);
  }
  /// Null if nobody asked for the property while setting up.
  template <class T>
  [[nodiscard]] const Column<T>* find(const Property<T>& property) const {
    return columns_.find(property);
  }
  [[nodiscard]] ColumnBase* find(std::string_view property) const { return columns_.find(property); }

  /// Counts the properties that were set by name; levels that keep working memory look whether it is still right.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  void count_change() { ++revision_; }

  [[nodiscard]] ObjectAccess object(std::string_view name);
  /// The first object; it carries the properties that the whole entity has once.
  [[nodiscard]] ObjectAccess base() { return {*this, 0}; }

  /// Takes an entity whose numbers went bad out of the simulation; it stays where it is. Called while stepping.
  void freeze(std::string reason) noexcept;
  [[nodiscard]] bool frozen() const { return frozen_reason_.has_value(); }
  [[nodiscard]] const std::optional<std::string>& frozen_reason() const { return frozen_reason_; }

  /// Saves or loads what is in no column.
  void state(StateArchive& archive);

  /// What levels of detail and laws move this entity, for reports. Set by whoever attaches them.
  std::string level, contact, controller;

 private:
  std::string name_;
  ModelPtr model_;
  EntityOptions options_;
  ColumnStore columns_;
  std::uint64_t revision_ = 0;
  std::optional<std::string> frozen_reason_;
};

}  // namespace murosimf
