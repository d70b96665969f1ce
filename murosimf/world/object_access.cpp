#include "murosimf/world/object_access.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/entity.h"

namespace murosimf {

const Model& ObjectAccess::model() const { return entity_->model(); }

ColumnStore& ObjectAccess::columns() const { return entity_->columns(); }

void ObjectAccess::refuse_unused(const PropertyInfo& info) const {
  throw SetupError(fmt::format("{} has no '{}': no attached algorithm uses it", where(), info.name));
}

const std::string& ObjectAccess::name() const { return model().objects()[object_].name; }

std::string ObjectAccess::where() const { return fmt::format("entity '{}', object '{}'", entity_->name(), name()); }

std::size_t ObjectAccess::row(const ColumnBase& column) const {
  MUROSIMF_ASSERT(object_ >= 0 && object_ < model().size());
  if (of_every_object(column.info().scope)) return static_cast<std::size_t>(object_);
  if (object_ != 0) {
    throw SetupError(fmt::format("{} has no '{}': only the base '{}' has it", where(), column.info().name,
                                 model().objects()[0].name));
  }
  return 0;
}

/// Of a structural object; empty where its row or a constant of the model has the value.
std::vector<double> ObjectAccess::structural_numbers(std::string_view property) const {
  const auto numbers = [&]<class T>(const Property<T>& wanted) {
    std::vector<double> all;
    if (property != wanted.name) return all;
    const auto value = structural_value(model(), columns(), wanted, object_);
    for (std::size_t i = 0; value && i < ValueTraits<T>::numbers; ++i) all.push_back(ValueTraits<T>::get(*value, i));
    return all;
  };
  for (const auto& wanted : {properties::position, properties::linear_velocity, properties::angular_velocity,
                             properties::linear_acceleration, properties::angular_acceleration}) {
    if (auto all = numbers(wanted); !all.empty()) return all;
  }
  return numbers(properties::orientation);
}

Quantity ObjectAccess::get(std::string_view property) const {
  if (auto numbers = structural_numbers(property); !numbers.empty()) {
    return {std::move(numbers), columns().find(property)->info().unit};
  }
  if (const ColumnBase* column = columns().find(property); column && column->numbers() > 0) {
    Quantity quantity{{}, column->info().unit};
    for (std::size_t i = 0; i < column->numbers(); ++i) quantity.numbers.push_back(column->get(row(*column), i));
    return quantity;
  }
  const auto& constants = model().constants().columns();
  if (const auto found = constants.find(property); found != constants.end()) {
    auto numbers = found->second->numbers(object_);
    if (!numbers.empty()) return {std::move(numbers), found->second->info().unit};
  }
  throw SetupError(fmt::format("{}: {}", where(), unknown_name("property", property, properties())));
}

void ObjectAccess::set(std::string_view property, std::span<const double> numbers) {
  ColumnBase* column = columns().find(property);
  if (!column || column->numbers() == 0) {
    if (model().constants().columns().contains(property)) {
      throw SetupError(fmt::format("{}: '{}' is a constant of the model", where(), property));
    }
    throw SetupError(fmt::format("{}: {}", where(), unknown_name("property", property, properties())));
  }
  if (model().objects()[object_].structural && of_every_object(column->info().scope)) {
    throw SetupError(fmt::format("{} cannot be set: it only gives the tree its shape and follows '{}'", where(),
                                 model().objects()[model().tree().links[model().tree().link_of[object_]].object].name));
  }
  if (numbers.size() != column->numbers()) {
    throw SetupError(fmt::format("{}: '{}' takes {} number{}, not {}", where(), property, column->numbers(),
                                 column->numbers() == 1 ? "" : "s", numbers.size()));
  }
  // rejected here: a NaN would freeze the entity one step later, without a hint at its origin
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw SetupError(fmt::format("{}: '{}' cannot be {}", where(), property, number));
  }
  MUROSIMF_ASSERT(may_write(*column) && "a column that the algorithm has not declared as written");
  const std::size_t target = row(*column);
  MUROSIMF_ASSERT(target < column->rows());
  for (std::size_t i = 0; i < numbers.size(); ++i) column->set(target, i, numbers[i]);
}

std::vector<std::string_view> ObjectAccess::properties() const {
  std::vector<std::string_view> names;
  for (const auto& [name, column] : columns()) {
    if (column->numbers() > 0 && (object_ == 0 || of_every_object(column->info().scope))) names.push_back(name);
  }
  for (const auto& [name, column] : model().constants().columns()) {
    if (!column->numbers(object_).empty()) names.push_back(name);
  }
  return names;
}

}  // namespace murosimf
