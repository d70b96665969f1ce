/// entity.h - one robot, ball or environment in a simulation: a name, a model, and columns of variable properties.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "murosimf/model/model.h"
#include "murosimf/world/column_store.h"
#include "murosimf/world/column_view.h"
#include "murosimf/world/entity_options.h"
#include "murosimf/world/object_access.h"

namespace murosimf {

class Entity {
 public:
  /// Throws SetupError if the name is empty or has characters other than letters, digits, '_' and '-'.
  Entity(std::string name, ModelPtr model, EntityOptions options = {});

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const ModelPtr& model_ptr() const { return model_; }
  [[nodiscard]] const EntityOptions& options() const { return options_; }

  /// Exchanges the model for one with the same objects. Called by Simulation::exchange_model, which updates the algorithms. Throws
  /// SetupError, and changes nothing, if the objects differ.
  void exchange_model(ModelPtr model);
  /// For pictures; these read it on request (scene/section_changes.h).
  void recolor(const Color& color) { options_.color = color; }

  /// Sets the place of the next start; checked as by the constructor.
  void place(const Vec3d& position, double heading, const Mat3d& attitude);

  [[nodiscard]] ColumnStore& columns() { return columns_; }
  [[nodiscard]] const ColumnStore& columns() const { return columns_; }
  /// As of its columns (column_store.h).
  template <class T>
  Column<T>& column(const Property<T>& property) {
    return columns_.column(property);
  }
  /// Null if the property was not requested while setting up.
  template <class T>
  [[nodiscard]] const Column<T>* find(const Property<T>& property) const {
    return columns_.find(property);
  }
  [[nodiscard]] ColumnBase* find(std::string_view property) const { return columns_.find(property); }

  /// All rows of a property at once. Throws SetupError if no algorithm uses it, or if it is no row of numbers.
  [[nodiscard]] ColumnView view(std::string_view property);
  [[nodiscard]] ConstColumnView view(std::string_view property) const;

  [[nodiscard]] ObjectAccess object(std::string_view name);
  /// The first object; it carries the properties that the whole entity has once.
  [[nodiscard]] ObjectAccess base() { return {*this, 0}; }

  /// Takes an entity whose numbers are not sane out of the simulation; it keeps its place. Called while stepping.
  void freeze(std::string reason) noexcept;
  /// For a new start.
  void unfreeze() { frozen_reason_.reset(); }
  [[nodiscard]] bool frozen() const { return frozen_reason_.has_value(); }
  [[nodiscard]] const std::optional<std::string>& frozen_reason() const { return frozen_reason_; }

  /// An absent entity keeps its name, its place among the entities and its columns, but nothing moves, touches, senses or
  /// draws it.
  [[nodiscard]] bool present() const { return present_; }
  /// Called by Simulation::enter and leave, which update the algorithms.
  void set_present(bool present) { present_ = present; }
  /// Nothing executes its algorithms, and nothing touches it.
  [[nodiscard]] bool idle() const { return frozen() || !present(); }

  /// Saves or loads what is in no column.
  void state(StateArchive& archive);

  /// Names of the levels of detail and laws that move this entity, for reports. Set by the code that attaches them.
  std::string level, contact, controller;

 private:
  void check_place() const;
  [[nodiscard]] std::shared_ptr<ColumnBase> numbers_of(std::string_view property) const;

  std::string name_;
  ModelPtr model_;
  EntityOptions options_;
  ColumnStore columns_;
  std::optional<std::string> frozen_reason_;
  bool present_;
};

}  // namespace murosimf
