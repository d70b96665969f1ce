/// object_access.h - one object of one entity, for interactive use and protocols: its properties by name, one value at a time.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/model/model.h"
#include "murosimf/world/column_store.h"
#include "murosimf/world/structural_objects.h"

namespace murosimf {

class Entity;

/// A value read by name: its numbers and what they mean.
struct Quantity {
  std::vector<double> numbers;
  std::string_view unit;
};

/// Simulation -> entity -> object -> property.
/// Every call looks up names; never use it in a loop. All throw SetupError on unknown names, with the nearest one.
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
  /// Names of all properties that get() can return for this object.
  [[nodiscard]] std::vector<std::string_view> properties() const;

 private:
  [[nodiscard]] const Model& model() const;
  [[nodiscard]] ColumnStore& columns() const;
  [[nodiscard]] std::size_t row(const ColumnBase& column) const;
  [[nodiscard]] std::vector<double> structural_numbers(std::string_view property) const;
  [[nodiscard]] std::string where() const;
  [[noreturn]] void refuse_unused(const PropertyInfo& info) const;

  Entity* entity_;
  int object_;
};

// ---- definitions ----

template <class T>
T ObjectAccess::get(const Property<T>& property) const {
  if (const auto value = structural_value(model(), columns(), property, object_)) return *value;
  if (const auto* column = columns().find(property)) return column->values[row(*column)];
  if (const T* constant = model().find(property, object_)) return *constant;
  refuse_unused(property);
}

template <class T>
void ObjectAccess::set(const Property<T>& property, const std::type_identity_t<T>& value) {
  if (!columns().find(property)) refuse_unused(property);
  auto& column = columns().column(property);
  MUROSIMF_ASSERT(row(column) < column.values.size());
  column.values[row(column)] = value;
}

}  // namespace murosimf
