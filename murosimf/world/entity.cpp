#include "murosimf/world/entity.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf {

Entity::Entity(std::string name, ModelPtr model, EntityOptions options)
    : name_(std::move(name)),
      model_(std::move(model)),
      options_(std::move(options)),
      columns_(name_, static_cast<std::size_t>(model_->size())),
      present_(options_.present) {
  // names are parts of file names, stream names and paths of messages
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  if (name_.empty() || !std::all_of(name_.begin(), name_.end(), allowed)) {
    throw SetupError(fmt::format("entity name '{}': use letters, digits, '_' and '-'", name_));
  }
  check_place();
}

void Entity::check_place() const {
  const Vec3d& p = options_.position;
  if (!std::isfinite(p.x + p.y + p.z + options_.heading)) {
    throw SetupError(fmt::format("entity '{}': position and heading must be finite numbers", name_));
  }
}

void Entity::place(const Vec3d& position, double heading, const Mat3d& attitude) {
  options_.position = position;
  options_.heading = heading;
  options_.attitude = attitude;
  check_place();
}

void Entity::exchange_model(ModelPtr model) {
  MUROSIMF_ASSERT(model);
  const auto same = [](const Object& a, const Object& b) {
    return a.name == b.name && a.kind == b.kind && a.parent == b.parent;
  };
  if (!std::ranges::equal(model_->objects(), model->objects(), same)) {
    throw SetupError(
        fmt::format("entity '{}': model '{}' has other objects than '{}'", name_, model->name(), model_->name()));
  }
  model_ = std::move(model);
}

ObjectAccess Entity::object(std::string_view name) {
  const auto found = model_->find_object(name);
  if (!found)
    throw SetupError(fmt::format("entity '{}': {}", name_, unknown_name("object", name, model_->object_names())));
  return {*this, *found};
}

std::shared_ptr<ColumnBase> Entity::numbers_of(std::string_view property) const {
  auto column = columns_.share(property);
  if (column && column->numbers() > 0) return column;
  std::vector<std::string_view> names;
  for (const auto& [name, other] : columns_) {
    if (other->numbers() > 0) names.push_back(name);
  }
  throw SetupError(fmt::format("entity '{}': {}", name_, unknown_name("property", property, names)));
}

ColumnView Entity::view(std::string_view property) { return ColumnView(numbers_of(property)); }

ConstColumnView Entity::view(std::string_view property) const { return ConstColumnView(numbers_of(property)); }

void Entity::state(StateArchive& archive) { archive(frozen_reason_, present_, level, contact, controller); }

void Entity::freeze(std::string reason) noexcept {
  // the first reason is the cause, later ones are its consequences
  if (!frozen_reason_) frozen_reason_ = std::move(reason);
}

}  // namespace murosimf
