#include "murosimf/geometry/facing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/geometry/box_parts.h"
#include "murosimf/geometry/support.h"
#include "murosimf/math/assert.h"

namespace murosimf::geometry {
namespace {

constexpr int rim_corners = 16;
constexpr double shows_cap = 0.7;  // a cylinder that leans less than 45 degrees stands, else it lies

struct FindFacing {
  const Shape& shape;
  const Transformd& at;
  Vec3d d;
  Side& side;

  void operator()(const Box& s) const {
    const BoxParts box(s, at);
    box.face(box.axis_along(d), d, side);
  }
  void operator()(const Capsule& s) const {
    for (const double end : {-s.half_length, s.half_length}) {
      side.add(at.position + end * at.orientation.z + s.radius * d, end < 0 ? 0 : 1);
    }
  }
  void operator()(const Cylinder& s) const {
    const double along = dot(at.orientation.z, d);
    if (std::abs(along) > shows_cap) return cap(s, along > 0);
    const Vec3d out = d - along * at.orientation.z;
    const Vec3d line = at.position + (s.radius / norm(out)) * out;
    side.add(line - s.half_length * at.orientation.z, 0);
    side.add(line + s.half_length * at.orientation.z, 1);
  }
  void operator()(const Convex& s) const {
    const ConvexHull& hull = *s.hull;
    const Vec3d local = transposed_times(at.orientation, d);
    std::size_t best = 0;
    for (std::size_t i = 1; i < hull.normals.size(); ++i) {
      if (dot(hull.normals[i], local) > dot(hull.normals[best], local)) best = i;
    }
    const auto& face = hull.faces[best];
    const std::size_t stride = (face.size() + most_corners - 1) / most_corners;
    for (std::size_t k = 0; k < face.size(); k += stride) {
      side.add(at.position + at.orientation * hull.vertices[face[k]], face[k]);
    }
    side.normal = at.orientation * hull.normals[best];
    side.name = 0x10000u + static_cast<std::uint32_t>(best);
  }
  template <class Round>
  void operator()(const Round&) const {
    side.add(at.position + at.orientation * support(shape, transposed_times(at.orientation, d)), 0);
  }

 private:
  void cap(const Cylinder& s, bool top) const {
    const Vec3d middle = at.position + (top ? s.half_length : -s.half_length) * at.orientation.z;
    for (int i = 0; i < rim_corners; ++i) {
      const int turn = top ? i : rim_corners - 1 - i;
      const auto [sine, cosine] = sin_cos(2 * pi / rim_corners * turn);
      const Vec3d arm = s.radius * cosine * at.orientation.x + s.radius * sine * at.orientation.y;
      side.add(middle + arm, static_cast<std::uint32_t>(turn + (top ? rim_corners : 0)));
    }
    side.normal = top ? at.orientation.z : -at.orientation.z;
    side.name = top ? 3 : 2;
  }
};

}  // namespace

void find_facing(const Shape& shape, const Transformd& at, const Vec3d& d, Side& side) {
  side.count = 0;
  MUROSIMF_ASSERT(side.count == 0);
  std::visit(FindFacing{shape, at, d, side}, shape);
  side.name_sides();
}

Segment line_facing(const Shape& shape, const Side& side, const Vec3d& d, std::uint32_t& name) {
  if (side.count < 2 || (side.count > 2 && std::holds_alternative<Cylinder>(shape))) return {};
  int best = 0;
  double highest = -1e300;
  for (int i = 0; i < side.count; ++i) {
    const Vec3d sum = side.corners[i].point + side.corners[(i + 1) % side.count].point;
    if (dot(sum, d) <= highest) continue;
    highest = dot(sum, d);
    best = i;
  }
  const Vec3d &p = side.corners[best].point, &q = side.corners[(best + 1) % side.count].point;
  name = side.corners[best].side;
  return {0.5 * (p + q), 0.5 * (q - p)};
}

}  // namespace murosimf::geometry
