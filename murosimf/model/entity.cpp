#include "murosimf/model/entity.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/properties.h"

namespace murosimf {

Entity::Entity(std::string name, ModelPtr model, EntityOptions options)
    : name_(std::move(name)), model_(std::move(model)), options_(std::move(options)) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  if (name_.empty() || !std::all_of(name_.begin(), name_.end(), allowed)) {
    throw SetupError(fmt::format("entity name '{}': use letters, digits, '_' and '-'", name_));
  }
  const Vec3d& p = options_.position;
  if (!std::isfinite(p.x + p.y + p.z + options_.heading)) {
    throw SetupError(fmt::format("entity '{}': position and heading must be finite numbers", name_));
  }
}

ColumnBase* Entity::find(std::string_view property) const {
  const auto found = columns_.find(property);
  return found == columns_.end() ? nullptr : found->second.get();
}

ObjectAccess Entity::object(std::string_view name) {
  const auto found = model_->find_object(name);
  if (!found)
    throw SetupError(fmt::format("entity '{}': {}", name_, unknown_name("object", name, model_->object_names())));
  return {*this, *found};
}

void Entity::freeze(std::string reason) noexcept {
  if (!frozen_reason_) frozen_reason_ = std::move(reason);
}

void Entity::append_to(Hasher& hasher) const {
  hasher.add(std::string_view(name_));
  hasher.add(std::uint64_t{frozen() ? 1u : 0u});
  for (int i = 0; i < model_->size(); ++i) update_structural(i);
  for (const auto& [name, column] : columns_) {
    if (column->info().scope == Scope::sensor) continue;
    hasher.add(std::string_view(name));
    column->append_to(hasher);
  }
}

void Entity::update_structural(int object) const {
  if (!model_->objects()[object].structural) return;
  const auto rows = [&]<class T>(const Property<T>& property) -> std::vector<T>* {
    ColumnBase* column = find(property.name);
    return column ? &static_cast<Column<T>*>(column)->values : nullptr;
  };
  auto* r = rows(properties::position);
  auto* R = rows(properties::orientation);
  if (!r || !R) return;
  const FixedObject place = model_->placement(object);
  const int link = model_->tree().links[place.link].object;
  (*r)[object] = (*r)[link] + (*R)[link] * place.offset;
  (*R)[object] = place.turned ? (*R)[link] * place.turn : (*R)[link];
  auto* v = rows(properties::linear_velocity);
  auto* w = rows(properties::angular_velocity);
  if (!v || !w) return;
  (*w)[object] = (*w)[link];
  (*v)[object] = (*v)[link] + cross((*w)[link], (*r)[object] - (*r)[link]);
}

void Entity::refuse_column(const PropertyInfo& info) const {
  throw SetupError(
      fmt::format("entity '{}': property '{}' is asked for after the columns were frozen; ask while setting up", name_,
                  info.name));
}

void Entity::refuse_type(const PropertyInfo& info) const {
  throw SetupError(fmt::format("entity '{}': two properties of different type are called '{}'", name_, info.name));
}

const std::string& ObjectAccess::name() const { return entity_->model().objects()[object_].name; }

std::string ObjectAccess::where() const { return fmt::format("entity '{}', object '{}'", entity_->name(), name()); }

std::size_t ObjectAccess::row(const ColumnBase& column) const {
  if (column.info().scope == Scope::object) return static_cast<std::size_t>(object_);
  if (object_ != 0) {
    throw SetupError(fmt::format("{} has no '{}': only the base '{}' has it", where(), column.info().name,
                                 entity_->model().objects()[0].name));
  }
  return 0;
}

Quantity ObjectAccess::get(std::string_view property) const {
  entity_->update_structural(object_);
  if (const ColumnBase* column = entity_->find(property); column && column->numbers() > 0) {
    Quantity quantity{{}, column->info().unit};
    for (std::size_t i = 0; i < column->numbers(); ++i) quantity.numbers.push_back(column->get(row(*column), i));
    return quantity;
  }
  const auto& constants = entity_->model().constants().columns();
  if (const auto found = constants.find(property); found != constants.end()) {
    auto numbers = found->second->numbers(object_);
    if (!numbers.empty()) return {std::move(numbers), found->second->info().unit};
  }
  throw SetupError(fmt::format("{}: {}", where(), unknown_name("property", property, properties())));
}

void ObjectAccess::set(std::string_view property, std::span<const double> numbers) {
  ColumnBase* column = entity_->find(property);
  if (!column || column->numbers() == 0) {
    if (entity_->model().constants().columns().contains(property)) {
      throw SetupError(fmt::format("{}: '{}' is a constant of the model", where(), property));
    }
    throw SetupError(fmt::format("{}: {}", where(), unknown_name("property", property, properties())));
  }
  if (entity_->model().objects()[object_].structural && column->info().scope == Scope::object) {
    throw SetupError(
        fmt::format("{} cannot be set: it only gives the tree its shape and follows '{}'", where(),
                    entity_->model()
                        .objects()[entity_->model().tree().links[entity_->model().tree().link_of[object_]].object]
                        .name));
  }
  if (numbers.size() != column->numbers()) {
    throw SetupError(fmt::format("{}: '{}' takes {} number{}, not {}", where(), property, column->numbers(),
                                 column->numbers() == 1 ? "" : "s", numbers.size()));
  }
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw SetupError(fmt::format("{}: '{}' cannot be {}", where(), property, number));
  }
  const std::size_t target = row(*column);
  for (std::size_t i = 0; i < numbers.size(); ++i) column->set(target, i, numbers[i]);
  entity_->count_change();
}

std::vector<std::string_view> ObjectAccess::properties() const {
  std::vector<std::string_view> names;
  for (const auto& [name, column] : entity_->columns()) {
    if (column->numbers() > 0 && (object_ == 0 || column->info().scope == Scope::object)) names.push_back(name);
  }
  for (const auto& [name, column] : entity_->model().constants().columns()) {
    if (!column->numbers(object_).empty()) names.push_back(name);
  }
  return names;
}

}  // namespace murosimf
