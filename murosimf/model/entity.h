/// entity.h - one robot, ball or environment in a simulation: a name, a model, and columns of variable properties.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/model/column.h"
#include "murosimf/model/model.h"
#include "murosimf/model/shape.h"

namespace murosimf {

class Entity;

/// A value read by name: its numbers and what they mean.
struct Quantity {
  std::vector<double> numbers;
  std::string_view unit;
};

/// One object of one entity, for people and protocols: simulation -> entity -> object -> property.
/// Every call looks names up; never use it in a loop. All throw SetupError on unknown names, with the nearest one.
class ObjectAccess {
 public:
  ObjectAccess(Entity& entity, int object) : entity_(&entity), object_(object) {}

  [[nodiscard]] const std::string& name() const;

  template <class T>
  [[nodiscard]] T get(const Property<T>& property) const;
  template <class T>
  void set(const Property<T>& property, const std::type_identity_t<T>& value);

  /// By name: variable properties, and constant ones of the model.
  [[nodiscard]] Quantity get(std::string_view property) const;
  /// By name: variable properties only. Numbers must be finite and as many as the property has.
  void set(std::string_view property, std::span<const double> numbers);
  /// Names of all properties that get() can show for this object.
  [[nodiscard]] std::vector<std::string_view> properties() const;

 private:
  [[nodiscard]] std::size_t row(const ColumnBase& column) const;
  [[nodiscard]] std::string where() const;

  Entity* entity_;
  int object_;
};

/// How an entity takes part in collision detection (collision/compound.h).
struct CollisionOptions {
  std::string volume = "sphere";                           ///< bounding volumes of its tree, by name
  bool self_collision = false;                             ///< its own limbs may touch each other
  std::vector<std::pair<std::string, std::string>> never;  ///< objects of it that never touch each other
};

/// How an entity is placed and shown; the scene decides.
struct EntityOptions {
  Vec3d position;      ///< [m] of the base on the ground plane: z is added to what the level finds
  double heading = 0;  ///< [rad] about the vertical
  Mat3d attitude;      ///< turns the level robot before it gets its heading; ignored by kinematic_walking
  std::string team;    ///< empty for none
  Color color;         ///< of the team or of the thing
  CollisionOptions collision;
};

class Entity {
 public:
  /// Throws SetupError if the name is empty or has characters other than letters, digits, '_' and '-'.
  Entity(std::string name, ModelPtr model, EntityOptions options = {});

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const ModelPtr& model_ptr() const { return model_; }
  [[nodiscard]] const EntityOptions& options() const { return options_; }

  /// The column of a property, created if need be. Throws SetupError if the columns are frozen, or if another
  /// property of the same name has another type.
  template <class T>
  Column<T>& column(const Property<T>& property);
  /// Null if nobody asked for the property while setting up.
  template <class T>
  [[nodiscard]] const Column<T>* find(const Property<T>& property) const;
  [[nodiscard]] ColumnBase* find(std::string_view property) const;
  [[nodiscard]] const auto& columns() const { return columns_; }

  /// Counts the properties that were set by name; levels that keep working memory look whether it is still right.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  void count_change() { ++revision_; }

  /// From now on no column can be added; spans stay valid for good.
  void freeze_columns() { columns_frozen_ = true; }
  /// Columns can be added again, as before freeze_columns().
  void thaw_columns() { columns_frozen_ = false; }
  /// Removes columns for which unused(column) is true: nobody may have spans of them any more.
  template <class Unused>
  void drop_columns(const Unused& unused) {
    std::erase_if(columns_, [&](const auto& item) { return unused(item.second.get()); });
  }

  [[nodiscard]] ObjectAccess object(std::string_view name);
  /// The first object; it carries the properties that the whole entity has once.
  [[nodiscard]] ObjectAccess base() { return {*this, 0}; }

  /// Takes an entity whose numbers went bad out of the simulation; it stays where it is. Called while stepping.
  void freeze(std::string reason) noexcept;
  [[nodiscard]] bool frozen() const { return frozen_reason_.has_value(); }
  [[nodiscard]] const std::optional<std::string>& frozen_reason() const { return frozen_reason_; }

  /// What levels of detail and laws move this entity, for reports. Set by whoever attaches them.
  std::string level, contact, controller;

  void append_to(Hasher& hasher) const;

  /// Works out pose and velocity of a structural object from those of its link, as far as there are columns of them.
  /// Does nothing to other objects, whose rows their level keeps.
  void update_structural(int object) const;

 private:
  [[noreturn]] void refuse_column(const PropertyInfo& info) const;
  [[noreturn]] void refuse_type(const PropertyInfo& info) const;

  std::string name_;
  ModelPtr model_;
  EntityOptions options_;
  std::map<std::string, std::unique_ptr<ColumnBase>, std::less<>> columns_;
  bool columns_frozen_ = false;
  std::uint64_t revision_ = 0;
  std::optional<std::string> frozen_reason_;
};

// ---- definitions ----

template <class T>
Column<T>& Entity::column(const Property<T>& property) {
  auto found = columns_.find(property.name);
  if (found == columns_.end()) {
    if (columns_frozen_) refuse_column(property);
    const std::size_t rows = property.scope == Scope::object ? static_cast<std::size_t>(model_->size()) : 1;
    found = columns_.emplace(std::string(property.name), nullptr).first;
    Property<T> own = property;
    own.name = found->first;  // a name that was put together for the call may end with it
    found->second = std::make_unique<Column<T>>(own, rows);
  }
  if (found->second->type() != typeid(T)) refuse_type(property);
  return static_cast<Column<T>&>(*found->second);
}

template <class T>
const Column<T>* Entity::find(const Property<T>& property) const {
  const auto found = columns_.find(property.name);
  if (found == columns_.end() || found->second->type() != typeid(T)) return nullptr;
  return static_cast<const Column<T>*>(found->second.get());
}

template <class T>
T ObjectAccess::get(const Property<T>& property) const {
  entity_->update_structural(object_);
  if (const auto* column = entity_->find(property)) return column->values[row(*column)];
  if (const T* constant = entity_->model().find(property, object_)) return *constant;
  throw SetupError(where() + " has no '" + std::string(property.name) + "': no attached algorithm uses it");
}

template <class T>
void ObjectAccess::set(const Property<T>& property, const std::type_identity_t<T>& value) {
  if (!entity_->find(property)) {
    throw SetupError(where() + " has no '" + std::string(property.name) + "': no attached algorithm uses it");
  }
  auto& column = entity_->column(property);
  column.values[row(column)] = value;
  entity_->count_change();
}

}  // namespace murosimf
