#include "murosimf/collision/contact_point.h"

#include "murosimf/model/value.h"

namespace murosimf::collision {

void append_hash(Hasher& hasher, const ContactPoint& point) {
  hasher.add(point.feature);
  hasher.add(std::uint64_t{static_cast<std::uint8_t>(point.state)});
  hasher.add(point.last_normal_force);
  append_hash(hasher, point.stretch);
  append_hash(hasher, point.slip_direction);
  if (point.lift > 0) hasher.add(point.lift);
}

void recall(const ContactPoint& old, ContactPoint& point) noexcept {
  point.stretch = old.stretch;
  point.state = old.state;
  point.last_normal_force = old.last_normal_force;
  point.slip_direction = old.slip_direction;
  point.lift = old.lift;
}

}  // namespace murosimf::collision
