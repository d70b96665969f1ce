#include "murosimf/collision/relief/ridge_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "murosimf/geometry/ray.h"

namespace murosimf::collision {
namespace {

using geometry::Ray;

constexpr double along_sides = 1e-6;  // [1] of a direction between two normals, for rounding

/// Calls take(direction) for each direction against a side of the shape, near p: towards the surface that touches it there.
template <class Take>
struct ForSides {
  const Transformd& at;
  const Vec3d& p;  // [m]
  const Take& take;

  void operator()(const Box&) const {
    for (const Vec3d& axis : {at.orientation.x, at.orientation.y, at.orientation.z}) {
      take(axis);
      take(-axis);
    }
  }
  void operator()(const Cylinder&) const {
    take(at.orientation.z);
    take(-at.orientation.z);
    take(-tangential(p - at.position, at.orientation.z));
  }
  void operator()(const Ellipsoid& s) const {
    const Vec3d d = transposed_times(at.orientation, p - at.position);
    const auto slope = [](double x, double semi_axis) { return -x / (semi_axis * semi_axis); };
    take(at.orientation * Vec3d{slope(d.x, s.semi_axes.x), slope(d.y, s.semi_axes.y), slope(d.z, s.semi_axes.z)});
  }
  void operator()(const Convex& s) const {
    for (const Vec3d& normal : s.hull->normals) take(-(at.orientation * normal));
  }
  template <class Round>
  void operator()(const Round&) const {}  // relief_contact.cpp has these
};

class RidgeContact {
 public:
  RidgeContact(const Relief& relief, int index, const Shape& shape, const Transformd& at,
               std::vector<ReliefContact>& found)
      : relief_(relief),
        index_(index),
        triangle_(relief.triangles()[index]),
        shape_(shape),
        at_(at),
        reach_(bounding_radius(shape)),
        found_(found) {}

  void find() {
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle_.edges[k].stands_out && triangle_.edges[k].is_own) find_on_edge(k);
      if (triangle_.owns_corner[k]) find_on_corner(k);
    }
  }

 private:
  /// A direction [1] in which the shape leaves a point, and how far that is.
  struct WayOut {
    Vec3d normal;
    double depth = 0;
  };

  /// The soonest way out of p [m] among unit vectors that are given to see().
  class Soonest {
   public:
    Soonest(const RidgeContact& of, const Vec3d& p) : of_(of), p_(p) {}
    void see(const Vec3d& n) {
      const double depth = of_.depth(p_, n);
      if (!best_ || depth < best_->depth) best_ = WayOut{n, depth};
    }
    [[nodiscard]] const std::optional<WayOut>& best() const { return best_; }

   private:
    const RidgeContact& of_;
    Vec3d p_;
    std::optional<WayOut> best_;
  };

  /// [m] How far the shape reaches below p, against n.
  [[nodiscard]] double depth(const Vec3d& p, const Vec3d& n) const {
    const double far = 2 * reach_ + norm(p - at_.position);
    const auto entry = geometry::meet({p - far * n, n}, shape_, at_);
    return entry ? std::max(0.0, far - entry->distance) : 0;
  }

  void find_on_edge(std::size_t k) {
    const Vec3d &a = triangle_.corners[k], &b = triangle_.corners[(k + 1) % 3];
    const double length = norm(b - a);
    const Vec3d along = (1 / length) * (b - a), apart = tangential(at_.position - a, along);
    if (dot(apart, apart) >= reach_ * reach_) return;
    const auto first = geometry::meet({a, along}, shape_, at_);
    if (!first || first->distance >= length) return;
    const auto last = geometry::meet({b, -along}, shape_, at_);
    if (!last) return;
    const double begin = first->distance, end = length - last->distance;
    if (!(end > begin)) return;
    const auto way_out = soonest_from_edge(k, a + 0.5 * (begin + end) * along, along);
    if (way_out) add_places(k, a, along, begin, end, length, *way_out);
  }

  std::optional<WayOut> soonest_from_edge(std::size_t k, const Vec3d& p, const Vec3d& along) const {
    const ReliefEdge& edge = triangle_.edges[k];
    Soonest soonest(*this, p);
    const auto see = [&](const Vec3d& direction) {
      const Vec3d n = tangential(direction, along);
      const double size = norm(n);
      if (!(size > 0.1 * norm(direction))) return;
      const double least = -along_sides * size;
      if (dot(n, edge.outward) >= least && dot(n, edge.neighbor_outward) >= least) soonest.see((1 / size) * n);
    };
    std::visit(ForSides<decltype(see)>{at_, p, see}, shape_);
    if (std::holds_alternative<Box>(shape_)) {
      for (const Vec3d& axis : {at_.orientation.x, at_.orientation.y, at_.orientation.z}) {
        see(cross(along, axis));
        see(cross(axis, along));
      }
    }
    see(triangle_.normal + edge.normal_limit);
    see(triangle_.normal);
    see(edge.normal_limit);
    return soonest.best();
  }

  /// At the ends of the part inside, where it carries most; or, if it is far deeper between them, in its middle. An end that is a corner of the
  /// surface is a contact of its own, and the deepest place of the part.
  void add_places(std::size_t k, const Vec3d& a, const Vec3d& along, double begin, double end, double length,
                  const WayOut& middle) {
    constexpr double inside = 1e-3;  // [1] of that part: a ray along the shape's side would miss it
    const double step = inside * (end - begin), enough = 0.5 * middle.depth;
    const bool begins = begin > 0 || !relief_.is_exposed(triangle_.vertices[k]);
    const bool ends = end < length || !relief_.is_exposed(triangle_.vertices[(k + 1) % 3]);
    const Vec3d first = a + (begin + step) * along, last = a + (end - step) * along;
    const double first_depth = begins ? depth(first, middle.normal) : 0,
                 last_depth = ends ? depth(last, middle.normal) : 0;
    if (begins && ends && std::max(first_depth, last_depth) < enough) {
      return add(ridge_feature(index_, k, 2), a + 0.5 * (begin + end) * along, middle.normal, middle.depth);
    }
    if (first_depth >= enough) add(ridge_feature(index_, k, 0), first, middle.normal, first_depth);
    if (last_depth >= enough) add(ridge_feature(index_, k, 1), last, middle.normal, last_depth);
  }

  void find_on_corner(std::size_t k) {
    const Vec3d& p = triangle_.corners[k];
    const std::uint32_t vertex = triangle_.vertices[k];
    const Vec3d apart = p - at_.position;
    if (dot(apart, apart) >= reach_ * reach_) return;
    const auto start = geometry::meet({p, triangle_.normal}, shape_, at_);
    if (!start || start->distance > 0) return;
    Soonest soonest(*this, p);
    const auto see = [&](const Vec3d& direction) {
      const double size = norm(direction);
      if (size > 0 && relief_.leads_away(vertex, direction)) soonest.see((1 / size) * direction);
    };
    std::visit(ForSides<decltype(see)>{at_, p, see}, shape_);
    see(relief_.vertex_normal(vertex));
    if (soonest.best()) add(corner_feature(vertex), p, soonest.best()->normal, soonest.best()->depth);
  }

  void add(std::uint32_t feature, const Vec3d& p, const Vec3d& normal, double depth) {
    if (depth > 0 && depth <= relief_.thickness()) found_.push_back({feature, p, normal, depth, 0});
  }

  const Relief& relief_;
  int index_;
  const ReliefTriangle& triangle_;
  const Shape& shape_;
  const Transformd& at_;
  double reach_;  // [m] of the shape about its origin
  std::vector<ReliefContact>& found_;
};

}  // namespace

void find_ridge_contacts(const Relief& relief, int triangle, const Shape& shape, const Transformd& at,
                         std::vector<ReliefContact>& found) {
  RidgeContact(relief, triangle, shape, at, found).find();
}

}  // namespace murosimf::collision
