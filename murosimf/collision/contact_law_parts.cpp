#include "murosimf/collision/contact_law_parts.h"

namespace murosimf::collision {
namespace {

constexpr double slow_turn = 0.5;  // [rad/s]

}  // namespace

double rolling_damping(const ContactPoint& c, const ContactParameters& p, double f_n) noexcept {
  if (p.rolling == 0 || c.radius == 0) return 0;
  return p.rolling * c.radius * f_n / std::max(norm(c.angular_velocity), slow_turn);
}

}  // namespace murosimf::collision
