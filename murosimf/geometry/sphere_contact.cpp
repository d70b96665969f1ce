#include "murosimf/geometry/sphere_contact.h"

#include <algorithm>
#include <cmath>

#include "murosimf/geometry/nearest.h"

namespace murosimf::geometry {
namespace {

/// A sphere against a shape that is a point, a segment or a body known by its nearest surface point outside.
struct AgainstShape {
  Vec3d center;
  double radius;

  using Result = std::optional<SphereContact>;

  /// Sphere of `other_radius` about `other`; `sideways`: way out if the centers coincide.
  [[nodiscard]] Result ball(const Vec3d& other, double other_radius, const Vec3d& sideways = {0, 0, 1}) const {
    const Vec3d d = center - other;
    const double distance = norm(d);
    const double depth = radius + other_radius - distance;
    if (depth <= 0) return std::nullopt;
    const Vec3d n = distance > 0 ? (1.0 / distance) * d : sideways;
    return SphereContact{other + other_radius * n, n, depth};
  }

  [[nodiscard]] Result beside(const Nearest& nearest) const {
    const double depth = radius - nearest.distance;
    if (depth <= 0) return std::nullopt;
    return SphereContact{nearest.point, nearest.normal, depth};
  }

  Result operator()(const Sphere& s) const { return ball({}, s.radius); }
  Result operator()(const Capsule& s) const {
    return ball({0, 0, std::clamp(center.z, -s.half_length, s.half_length)}, s.radius, {1, 0, 0});
  }
  Result operator()(const Box& s) const {
    const Vec3d& h = s.half_size;
    const Vec3d nearest{std::clamp(center.x, -h.x, h.x), std::clamp(center.y, -h.y, h.y),
                        std::clamp(center.z, -h.z, h.z)};
    const Vec3d gap = center - nearest;
    if (dot(gap, gap) > 0) return ball(nearest, 0.0);
    // the center is inside: out through the nearest face
    const Vec3d room{h.x - std::abs(center.x), h.y - std::abs(center.y), h.z - std::abs(center.z)};
    SphereContact contact{center, {}, 0};
    if (room.x <= room.y && room.x <= room.z) {
      contact.normal.x = center.x < 0 ? -1 : 1;
      contact.depth = radius + room.x;
      contact.point.x = contact.normal.x * h.x;
    } else if (room.y <= room.z) {
      contact.normal.y = center.y < 0 ? -1 : 1;
      contact.depth = radius + room.y;
      contact.point.y = contact.normal.y * h.y;
    } else {
      contact.normal.z = center.z < 0 ? -1 : 1;
      contact.depth = radius + room.z;
      contact.point.z = contact.normal.z * h.z;
    }
    return contact;
  }
  Result operator()(const Cylinder& s) const {
    const double across = std::hypot(center.x, center.y);
    const Vec3d out = across > 1e-12 ? Vec3d{center.x / across, center.y / across, 0} : Vec3d{1, 0, 0};
    const double along = std::clamp(center.z, -s.half_length, s.half_length);
    if (across > s.radius || std::abs(center.z) > s.half_length) {
      return ball(std::min(across, s.radius) * out + Vec3d{0, 0, along}, 0.0);
    }
    const double room_side = s.radius - across;
    const double room_cap = s.half_length - std::abs(center.z);
    if (room_side <= room_cap) return SphereContact{s.radius * out + Vec3d{0, 0, along}, out, radius + room_side};
    const Vec3d up{0, 0, center.z < 0 ? -1.0 : 1.0};
    return SphereContact{across * out + s.half_length * up, up, radius + room_cap};
  }
  Result operator()(const Ellipsoid& s) const { return beside(nearest_on_ellipsoid(s.semi_axes, center)); }
  Result operator()(const Convex& s) const { return beside(nearest_on_hull(*s.hull, center)); }
  Result operator()(const Plane&) const {
    if (center.z >= radius) return std::nullopt;
    return SphereContact{{center.x, center.y, 0}, {0, 0, 1}, radius - center.z};
  }
};

}  // namespace

std::optional<SphereContact> sphere_contact(const Vec3d& center, double radius, const Shape& other) {
  return std::visit(AgainstShape{center, radius}, other);
}

}  // namespace murosimf::geometry
