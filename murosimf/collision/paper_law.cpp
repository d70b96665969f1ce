#include "murosimf/collision/paper_law.h"

#include <algorithm>

#include "murosimf/collision/contact_law_parts.h"
#include "murosimf/collision/soft_start.h"

namespace murosimf::collision {
namespace {

/// Keeps the deepest point of every body.
void keep_deepest(std::vector<ContactPoint>& points) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto same_body = [&](const ContactPoint& other) { return other.object == points[i].object; };
    const auto best = std::find_if(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(kept), same_body);
    if (best == points.begin() + static_cast<std::ptrdiff_t>(kept)) {
      points[kept++] = points[i];
    } else if (points[i].depth > best->depth) {
      *best = points[i];
    }
  }
  points.resize(kept);
  std::sort(points.begin(), points.end(),
            [](const ContactPoint& a, const ContactPoint& b) { return a.feature < b.feature; });
}

}  // namespace

void PaperLaw::prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept {
  if (options_.one_point_per_body) keep_deepest(points);
  for (ContactPoint& c : points) {
    clear_force(c);
    const double v_n = dot(c.velocity, c.normal);
    const double gain = v_n < 0 ? 1.0 : options_.rebound;
    const ContactParameters& p = terms.parameters[c.surface];
    const double f_n = std::min(gain * p.stiffness * c.depth, explicit_limit(c, p, terms.dt, v_n));
    c.force = f_n * c.normal - (options_.friction * f_n) * tangential(c.velocity, c.normal);
    c.moment = (-options_.spin_friction * f_n) * c.angular_velocity;
  }
}

}  // namespace murosimf::collision
