#include "murosimf/dataset/places.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/scalar.h"

namespace murosimf::dataset {
namespace {

constexpr int most_tries = 20;

}  // namespace

bool Looker::sees(const Vec3d& point) const {
  const auto pixel = lens->project(transposed_times(axes, point - eye));
  return pixel && pixel->u > 0 && pixel->v > 0 && pixel->u < lens->spec().width - 1 &&
         pixel->v < lens->spec().height - 1;
}

bool Places::is_free(const Vec3d& place, double radius) const {
  const double beyond = std::abs(place.x) - 0.5 * field_->length;
  const bool in_goal = beyond > -radius && beyond < field_->goal_depth + radius &&
                       std::abs(place.y) < 0.5 * field_->goal_width + field_->post_width + radius;
  if (in_goal) return false;
  if (std::ranges::any_of(blocked_, [&](const Footprint& one) { return one.distance(place) < radius; })) return false;
  return std::ranges::none_of(taken_, [&](const Disc& other) {
    return std::hypot(place.x - other.place.x, place.y - other.place.y) < radius + other.radius;
  });
}

std::optional<Vec3d> Places::on_field(Dice& dice, double radius) {
  for (int tries = 0; tries < most_tries; ++tries) {
    const double x = dice.in({-0.5, 0.5}) * field_->length, y = dice.in({-0.5, 0.5}) * field_->width;
    const Vec3d place{x, y, 0};
    if (!is_free(place, radius)) continue;
    take(place, radius);
    return place;
  }
  return std::nullopt;
}

std::optional<Vec3d> Places::in_view(Dice& dice, double radius, const Looker& looker, const Range& distance,
                                     double height) {
  const Vec3d forward = looker.axes.z;
  const double ahead = std::atan2(forward.y, forward.x);
  const double half = 0.5 * looker.lens->fov().horizontal;
  for (int tries = 0; tries < most_tries; ++tries) {
    const double angle = ahead + dice.in({-half, half});
    const double away = distance.low * std::pow(distance.high / distance.low, dice.uniform());
    const Vec3d place{looker.eye.x + away * std::cos(angle), looker.eye.y + away * std::sin(angle), 0};
    const bool inside = std::abs(place.x) < 0.5 * field_->length + 0.5 * field_->border &&
                        std::abs(place.y) < 0.5 * field_->width + 0.5 * field_->border;
    if (!inside || !is_free(place, radius) || !looker.sees(place + Vec3d{0, 0, height})) continue;
    take(place, radius);
    return place;
  }
  return std::nullopt;
}

std::optional<Vec3d> Places::around(Dice& dice, double radius, double reach, const Looker* looker) {
  for (int tries = 0; tries < most_tries; ++tries) {
    const double x = dice.in({-0.5, 0.5}) * (field_->length + 2 * reach);
    const double y = dice.in({-0.5, 0.5}) * (field_->width + 2 * reach);
    const bool on_field = std::abs(x) < 0.5 * field_->length + radius && std::abs(y) < 0.5 * field_->width + radius;
    const Vec3d place{x, y, 0};
    if (on_field || !is_free(place, radius)) continue;
    if (looker && !looker->sees(place + Vec3d{0, 0, 0.5})) continue;
    take(place, radius);
    return place;
  }
  return std::nullopt;
}

}  // namespace murosimf::dataset
