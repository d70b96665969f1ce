#include "murosimf/collision/static_compound.h"

#include <algorithm>

#include "murosimf/collision/interpenetration.h"
#include "murosimf/geometry/sphere_contact.h"

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
  for (int i = 0; i < static_cast<int>(compound_.shapes().size()); ++i) {
    places_.push_back(compound_.pose(i, r, R));
    const CollidingShape& own = shape(i);
    const ReliefPtr* relief = model.find(properties::relief, own.object);
    if (relief && own.index == 0) grounds_.push_back({*relief, {r[own.object], R[own.object]}, own.object, i});
    thicknesses_.push_back(relief ? (*relief)->thickness() : collision::thickness(own.placed.shape));
  }
}

const StaticCompound::Ground* StaticCompound::ground_of(int i) const noexcept {
  const auto found = std::ranges::find_if(grounds_, [&](const Ground& ground) { return ground.has(i); });
  return found == grounds_.end() ? nullptr : &*found;
}

std::shared_ptr<const StaticCompound> static_compound_of(const Entity* environment) {
  static const auto nothing = std::make_shared<const StaticCompound>(nullptr);
  if (!environment) return nothing;
  return environment->model().derived().get<StaticCompound>(environment->options().collision.volume,
                                                            [&] { return StaticCompound(environment); });
}

bool StaticCompound::is_near(const Vec3d& center, double radius, std::int64_t& tests) const noexcept {
  bool found = false;
  const geometry::BoundingSphere sphere{center, radius};
  const auto look = [&](int i) {
    const auto& [position, orientation] = places_[i];
    const Vec3d inside = transposed_times(orientation, center - position);
    found = geometry::sphere_contact(inside, radius, shape(i).placed.shape).has_value();
    return !found;
  };
  const auto wanted = [&](const auto& volume) { return overlap(volume, sphere); };
  tests += std::visit([&](const auto& tree) { return geometry::for_leaves(tree, wanted, look); }, compound_.tree());
  return found;
}

bool NearStatics::operator()(const StaticCompound& environment, const Vec3d& base, double reach,
                             std::int64_t& tests) noexcept {
  constexpr double margin = 0.05;  // [m]
  const Vec3d way = asked_at_ ? base - *asked_at_ : Vec3d{};
  if (!asked_at_ || !(dot(way, way) < margin * margin)) {
    asked_at_ = base;
    near_ = environment.is_near(base, reach + margin, tests);
  }
  return near_;
}

}  // namespace murosimf::collision
