#include "murosimf/collision/static_compound.h"

namespace murosimf::collision {
namespace {

Compound make_compound(const Entity* environment) {
  if (!environment) return Compound(Model("nothing", Chain{}.base()));
  return compound_of(*environment, {.volume = environment->options().collision.volume, .structured = false});
}

}  // namespace

StaticCompound::StaticCompound(const Entity* environment) : compound_(make_compound(environment)) {
  if (!environment) return;
  const Model& model = environment->model();
  std::vector<Vec3d> r;
  std::vector<Mat3d> R;
  for (int i = 0; i < model.size(); ++i) {
    const FixedObject place = model.placement(i);
    r.push_back(place.offset);
    R.push_back(place.turn);
  }
  compound_.refit(r, R);
  for (int i = 0; i < static_cast<int>(compound_.shapes().size()); ++i) places_.push_back(compound_.pose(i, r, R));
}

bool StaticCompound::is_near(const Vec3d& center, double radius, std::int64_t& tests) const noexcept {
  bool found = false;
  const geometry::BoundingSphere sphere{center, radius};
  const auto stop = [&](int) {
    found = true;
    return false;
  };
  const auto wanted = [&](const auto& volume) { return overlap(volume, sphere); };
  tests += std::visit([&](const auto& tree) { return geometry::for_leaves(tree, wanted, stop); }, compound_.tree());
  return found;
}

}  // namespace murosimf::collision
