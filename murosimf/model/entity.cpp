#include "murosimf/model/entity.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf {

Entity::Entity(std::string name, ModelPtr model, EntityOptions options)
    : name_(std::move(name)),
      model_(std::move(model)),
      options_(std::move(options)),
      columns_(name_, static_cast<std::size_t>(model_->size())) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  if (name_.empty() || !std::all_of(name_.begin(), name_.end(), allowed)) {
    throw SetupError(fmt::format("entity name '{}': use letters, digits, '_' and '-'", name_));
  }
  const Vec3d& p = options_.position;
  if (!std::isfinite(p.x + p.y + p.z + options_.heading)) {
    throw SetupError(fmt::format("entity '{}': position and heading must be finite numbers", name_));
  }
}

ObjectAccess Entity::object(std::string_view name) {
  const auto found = model_->find_object(name);
  if (!found)
    throw SetupError(fmt::format("entity '{}': {}", name_, unknown_name("object", name, model_->object_names())));
  return {*this, *found};
}

void Entity::state(StateArchive& archive) { archive(frozen_reason_, level, contact, controller); }

void Entity::freeze(std::string reason) noexcept {
  if (!frozen_reason_) frozen_reason_ = std::move(reason);
}

}  // namespace murosimf
