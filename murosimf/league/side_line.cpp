#include "murosimf/league/side_line.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"

namespace murosimf::league {
namespace {

constexpr double outside = 0.35;  // [m] from the touch line; borders have 0.7 m and more
constexpr double spacing = 0.6;   // [m] arms do not reach the neighbor
constexpr int most_places = 11;

}  // namespace

scene::Placement place_at_side_line(const scene_file::FieldSize& field, double attacks, double side,
                                    const std::vector<Vec3d>& others) {
  MUROSIMF_ASSERT((attacks == 1 || attacks == -1) && (side == 1 || side == -1));
  const double mark = -attacks * (0.5 * field.length - field.penalty_mark_distance);
  scene::Placement placement{{mark, side * (0.5 * field.width + outside), 0}, -side * pi / 2};
  for (int i = 1; i < most_places; ++i) {
    const auto is_near = [&](const Vec3d& other) {
      return std::hypot(other.x - placement.position.x, other.y - placement.position.y) < 0.9 * spacing;
    };
    if (std::ranges::none_of(others, is_near)) return placement;
    const double steps = (i % 2 == 1 ? 1 : -1) * ((i + 1) / 2);  // to the half line, to the goal line, ...
    placement.position.x = mark + attacks * steps * spacing;
  }
  return placement;
}

}  // namespace murosimf::league
