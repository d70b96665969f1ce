#include "murosimf/model/model.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf {

Model::Model(std::string name, Chain chain)
    : name_(std::move(name)), objects_(chain.objects()), constants_(chain.constants()) {
  check_structure();
  name_all_objects();
  index_names(chain.aliases());
  use_constants();
  MUROSIMF_ASSERT(tree_.link_of.size() == objects_.size());
}

Model Model::with(ConstantTable constants) const {
  Model changed = *this;
  changed.constants_ = std::move(constants);
  changed.use_constants();
  return changed;
}

/// Works out what follows from objects and constants.
void Model::use_constants() {
  // before the tree: it divides by masses
  check_masses();
  MUROSIMF_ASSERT(!objects_.empty());
  joints_.clear();
  bodies_.clear();
  tree_ = Tree(objects_, constants_);
  for (int i = 0; i < size(); ++i) {
    if (objects_[i].is_joint()) joints_.push_back(i);
    if (find(properties::mass, i) || find(properties::shapes, i)) bodies_.push_back(i);
  }
  MUROSIMF_ASSERT(tree_.links.size() == joints_.size() + 1 && "the base and one link for each joint");
}

int Model::object_index(std::string_view name) const {
  if (const auto found = find_object(name)) return *found;
  throw SetupError(fmt::format("model '{}': {}", name_, unknown_name("object", name, object_names())));
}

std::optional<int> Model::find_object(std::string_view name) const {
  const auto found = index_.find(name);
  return found == index_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string_view> Model::object_names() const {
  std::vector<std::string_view> names;
  for (const auto& [name, object] : index_) names.push_back(name);
  return names;
}

FixedObject Model::placement(int object) const {
  MUROSIMF_ASSERT(object >= 0 && object < size());
  for (const FixedObject& fixed : tree_.fixed) {
    if (fixed.object == object) return fixed;
  }
  return {object, tree_.link_of[object], {}, {}, false};
}

void Model::check_structure() const {
  if (objects_.empty() || objects_.front().kind != Kind::base) {
    throw SetupError(fmt::format("model '{}' must begin with a base", name_));
  }
  for (int i = 0; i < size(); ++i) {
    const Vec3d& v = objects_[i].vector;
    const Mat3d& R = objects_[i].turn;
    if (!std::isfinite(v.x + v.y + v.z + norm(R.x) + norm(R.y) + norm(R.z))) {
      throw SetupError(fmt::format("model '{}', object '{}': its place is not finite", name_, objects_[i].name));
    }
  }
  for (int i = 1; i < size(); ++i) {
    if (objects_[i].kind == Kind::base) {
      throw SetupError(fmt::format("model '{}' has a second base, '{}'", name_, objects_[i].name));
    }
  }
}

void Model::name_all_objects() {
  for (int i = 0; i < size(); ++i) {
    if (objects_[i].name.empty()) objects_[i].name = fmt::format("{}_{}", kind_name(objects_[i].kind), i);
  }
}

void Model::index_names(const std::vector<std::pair<std::string, int>>& aliases) {
  const auto add = [this](const std::string& name, int object) {
    // an alias may repeat the name of its own object
    const auto [place, fresh] = index_.emplace(name, object);
    if (!fresh && place->second != object) {
      throw SetupError(fmt::format("model '{}': two objects are called '{}'", name_, name));
    }
  };
  for (int i = 0; i < size(); ++i) add(objects_[i].name, i);
  for (const auto& [name, object] : aliases) add(name, object);
}

void Model::check_masses() const {
  for (int i = 0; i < size(); ++i) {
    const double* mass = find(properties::mass, i);
    if (mass && !(*mass > 0 && std::isfinite(*mass))) {
      throw SetupError(
          fmt::format("model '{}', object '{}': mass {} kg is not positive", name_, objects_[i].name, *mass));
    }
    const Vec3d* center = find(properties::center_of_mass, i);
    if (center && !std::isfinite(center->x + center->y + center->z)) {
      throw SetupError(fmt::format("model '{}', object '{}': center of mass is not finite", name_, objects_[i].name));
    }
    if (!mass && (center || find(properties::inertia, i))) {
      throw SetupError(fmt::format("model '{}', object '{}' has a center of mass or an inertia but no mass", name_,
                                   objects_[i].name));
    }
    const Vec3d* range = find(properties::joint_range, i);
    if (range && !(range->x <= range->y)) {
      throw SetupError(fmt::format("model '{}', joint '{}': its range from {} to {} is empty", name_, objects_[i].name,
                                   range->x, range->y));
    }
    const SymMat3d* I = find(properties::inertia, i);
    if (!I) continue;
    if (!is_positive_definite(*I)) {
      throw SetupError(
          fmt::format("model '{}', object '{}': inertia is not positive definite", name_, objects_[i].name));
    }
  }
}

}  // namespace murosimf
