#include "murosimf/geometry/ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace murosimf::geometry {
namespace {

using Meeting = std::optional<RayEntry>;

const Meeting& nearer(const Meeting& a, const Meeting& b) { return !a || (b && b->distance < a->distance) ? b : a; }

/// A convex body is what all its half spaces have in common: the ray is inside from the last that it enters to the
/// first that it leaves.
class HalfSpaces {
 public:
  /// The half space below a plane: `height` [m] of the ray's origin above it, `rate` [1] at which the ray rises.
  void add(double height, double rate, const Vec3d& normal) {
    if (height > 0) outside_ = true;
    if (rate == 0) {
      missed_ = missed_ || height > 0;
    } else if (const double t = -height / rate; rate > 0) {
      leave_ = std::min(leave_, t);
    } else if (t > enter_.distance) {
      enter_ = {t, normal};
    }
  }
  [[nodiscard]] Meeting result(const Vec3d& direction) const {
    if (!outside_) return RayEntry{0, -direction};
    if (missed_ || enter_.distance > leave_ || enter_.distance < 0) return std::nullopt;
    return enter_;
  }

 private:
  bool outside_ = false, missed_ = false;
  RayEntry enter_{-std::numeric_limits<double>::infinity(), {}};
  double leave_ = std::numeric_limits<double>::infinity();
};

/// A ray o + t d in the frame of the shape.
struct MeetShape {
  Vec3d o, d;

  [[nodiscard]] Meeting inside() const { return RayEntry{0, -d}; }

  /// The sphere of `radius` about (0, 0, z), from outside.
  [[nodiscard]] Meeting ball(double radius, double z) const {
    const Vec3d from{o.x, o.y, o.z - z};
    const double nearest = -dot(from, d);
    const Vec3d off = from + nearest * d;
    const double square = radius * radius - dot(off, off);
    if (square < 0 || nearest < 0) return std::nullopt;
    const double t = nearest - sqrt(square);
    return RayEntry{t, (1 / radius) * (from + t * d)};
  }
  /// The side of the cylinder along z, from outside.
  [[nodiscard]] Meeting side(double radius, double half_length) const {
    const double across = d.x * d.x + d.y * d.y;
    if (across == 0) return std::nullopt;
    const double nearest = -(o.x * d.x + o.y * d.y) / across;
    const double x = o.x + nearest * d.x, y = o.y + nearest * d.y;
    const double square = (radius * radius - x * x - y * y) / across;
    if (square < 0) return std::nullopt;
    const double t = nearest - sqrt(square);
    if (t < 0 || abs(o.z + t * d.z) > half_length) return std::nullopt;
    return RayEntry{t, {(o.x + t * d.x) / radius, (o.y + t * d.y) / radius, 0}};
  }

  Meeting operator()(const Sphere& s) const { return dot(o, o) <= s.radius * s.radius ? inside() : ball(s.radius, 0); }
  Meeting operator()(const Box& s) const {
    HalfSpaces box;
    box.add(o.x - s.half_size.x, d.x, {1, 0, 0});
    box.add(-o.x - s.half_size.x, -d.x, {-1, 0, 0});
    box.add(o.y - s.half_size.y, d.y, {0, 1, 0});
    box.add(-o.y - s.half_size.y, -d.y, {0, -1, 0});
    box.add(o.z - s.half_size.z, d.z, {0, 0, 1});
    box.add(-o.z - s.half_size.z, -d.z, {0, 0, -1});
    return box.result(d);
  }
  Meeting operator()(const Capsule& s) const {
    const Vec3d from_axis{o.x, o.y, o.z - std::clamp(o.z, -s.half_length, s.half_length)};
    if (dot(from_axis, from_axis) <= s.radius * s.radius) return inside();
    const Meeting ends = nearer(ball(s.radius, s.half_length), ball(s.radius, -s.half_length));
    return nearer(side(s.radius, s.half_length), ends);
  }
  Meeting operator()(const Cylinder& s) const {
    const double square = s.radius * s.radius;
    if (abs(o.z) <= s.half_length && o.x * o.x + o.y * o.y <= square) return inside();
    if (d.z * o.z < 0 && abs(o.z) >= s.half_length) {
      const double end = std::copysign(s.half_length, o.z), t = (end - o.z) / d.z;
      const double x = o.x + t * d.x, y = o.y + t * d.y;
      if (x * x + y * y <= square) return RayEntry{t, {0, 0, std::copysign(1.0, o.z)}};
    }
    return side(s.radius, s.half_length);
  }
  Meeting operator()(const Ellipsoid& s) const {
    // the unit sphere after scaling each axis
    const Vec3d& a = s.semi_axes;
    const Vec3d from{o.x / a.x, o.y / a.y, o.z / a.z}, along{d.x / a.x, d.y / a.y, d.z / a.z};
    if (dot(from, from) <= 1) return inside();
    const double square_along = dot(along, along);
    const double nearest = -dot(from, along) / square_along;
    const Vec3d off = from + nearest * along;
    const double square = (1 - dot(off, off)) / square_along;
    if (square < 0 || nearest < 0) return std::nullopt;
    const double t = nearest - sqrt(square);
    const Vec3d p = from + t * along;
    const Vec3d slope{p.x / a.x, p.y / a.y, p.z / a.z};
    return RayEntry{t, (1 / norm(slope)) * slope};
  }
  Meeting operator()(const Plane&) const {
    if (o.z <= 0) return inside();
    if (d.z >= 0) return std::nullopt;
    return RayEntry{-o.z / d.z, {0, 0, 1}};
  }
  Meeting operator()(const Convex& s) const {
    HalfSpaces faces;
    for (std::size_t i = 0; i < s.hull->faces.size(); ++i) {
      const Vec3d& n = s.hull->normals[i];
      faces.add(dot(n, o - s.hull->vertices[s.hull->faces[i][0]]), dot(n, d), n);
    }
    return faces.result(d);
  }
};

}  // namespace

std::optional<RayEntry> meet(const Ray& ray, const Shape& shape, const Transformd& at) {
  const MeetShape in_frame{transposed_times(at.orientation, ray.origin - at.position),
                           transposed_times(at.orientation, ray.direction)};
  std::optional<RayEntry> found = std::visit(in_frame, shape);
  if (found) found->normal = at.orientation * found->normal;
  return found;
}

}  // namespace murosimf::geometry
