#include "murosimf/model/chain.h"

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf {
namespace {

Vec3d unit_axis(const Vec3d& axis, const std::string& name) {
  const double length = norm(axis);
  if (!(length > 1e-9) || !std::isfinite(length)) {
    throw SetupError(fmt::format("object '{}': axis ({} {} {}) has no direction", name, axis.x, axis.y, axis.z));
  }
  return (1.0 / length) * axis;
}

}  // namespace

Chain& Chain::base(std::string name) { return add(Kind::base, std::move(name)); }

Chain& Chain::translation(const Vec3d& offset, std::string name) {
  return add(Kind::translation, std::move(name), offset);
}

Chain& Chain::rotation(const Vec3d& axis, double angle, std::string name) {
  const Vec3d unit = unit_axis(axis, name.empty() ? "rotation" : name);
  return add(Kind::rotation, std::move(name), {}, murosimf::rotation(unit, angle));
}

Chain& Chain::rotation(const Mat3d& turn, std::string name) { return add(Kind::rotation, std::move(name), {}, turn); }

Chain& Chain::revolute(std::string name, const Vec3d& axis) {
  const Vec3d unit = unit_axis(axis, name);
  return add(Kind::revolute, std::move(name), unit);
}

Chain& Chain::prismatic(std::string name, const Vec3d& axis) {
  const Vec3d unit = unit_axis(axis, name);
  return add(Kind::prismatic, std::move(name), unit);
}

Chain& Chain::endpoint(std::string name) {
  add(Kind::endpoint, std::move(name));
  closed_ = true;
  return *this;
}

Chain& Chain::fork(const std::vector<Chain>& branches) {
  if (branches.empty()) return endpoint();
  // three and more branches become a row of forks, since the paper's fork has two
  for (std::size_t i = 0; i < branches.size(); ++i) {
    if (i + 1 < branches.size()) add(Kind::fork, {});
    append(branches[i], tail_);
  }
  closed_ = true;
  return *this;
}

Chain& Chain::structural() {
  objects_[static_cast<std::size_t>(last_object())].structural = true;
  return *this;
}

Chain& Chain::alias(std::string name) {
  aliases_.emplace_back(std::move(name), last_object());
  return *this;
}

Chain& Chain::add(Kind kind, std::string name, const Vec3d& vector, const Mat3d& turn) {
  if (closed_) {
    throw SetupError(fmt::format("{} '{}' cannot follow a fork or an endpoint", kind_name(kind), name));
  }
  const int index = static_cast<int>(objects_.size());
  // they carry nothing, so their poses need not be updated in every step
  const bool structural = kind == Kind::fork || (kind == Kind::endpoint && name.empty());
  MUROSIMF_ASSERT(tail_ < index);
  // parents come first: kernels rely on this order
  objects_.push_back({kind, tail_, vector, turn, std::move(name), structural});
  tail_ = index;
  return *this;
}

void Chain::append(const Chain& branch, int parent) {
  if (branch.empty()) throw SetupError("a fork has an empty branch");
  const int offset = static_cast<int>(objects_.size());
  MUROSIMF_ASSERT(parent < offset);
  for (Object object : branch.objects_) {
    // the branch has its own numbers; its root follows the fork
    object.parent = object.parent < 0 ? parent : object.parent + offset;
    objects_.push_back(std::move(object));
  }
  constants_.append(branch.constants_, offset);
  MUROSIMF_ASSERT(objects_.size() == static_cast<std::size_t>(offset) + branch.objects_.size());
  for (const auto& [name, object] : branch.aliases_) aliases_.emplace_back(name, object + offset);
}

int Chain::last_object() const {
  if (objects_.empty()) throw SetupError("a property is set before the first object");
  return static_cast<int>(objects_.size()) - 1;
}

}  // namespace murosimf
