#include "murosimf/collision/relief/relief_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "murosimf/collision/relief/ridge_contact.h"
#include "murosimf/geometry/low_points.h"
#include "murosimf/geometry/segments.h"
#include "murosimf/geometry/spread.h"
#include "murosimf/geometry/support.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/insertion_sort.h"

namespace murosimf::collision {
namespace {

constexpr double on_border = 1e-9;  // [m] a point that near to the border of two triangles is in both

/// The place of a shape in the frame of the surface.
Transformd in_frame(const Transformd& at_relief, const Transformd& at) {
  return {transposed_times(at_relief.orientation, at.position - at_relief.position),
          transpose(at_relief.orientation) * at.orientation};
}

bool is_in_space(const ReliefTriangle& triangle, const Vec3d& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (dot(p - triangle.corners[k], triangle.edges[k].wall) > on_border) return false;
  }
  return true;
}

/// Contacts of a shape with a triangle, in the surface's frame.
class TriangleContact {
 public:
  TriangleContact(const Relief& relief, int index, const Shape& shape, const Transformd& at,
                  std::vector<ReliefContact>& found)
      : relief_(relief), index_(index), triangle_(relief.triangles()[index]), shape_(shape), at_(at), found_(found) {}

  void find() {
    const Vec3d down = -transposed_times(at_.orientation, triangle_.normal);
    const Vec3d lowest = at_.position + at_.orientation * geometry::support(shape_, down);
    if (height_of(lowest) >= 0) return;  // nor can edges and corners be in it
    std::visit([&](const auto& s) { find(s); }, shape_);
  }

 private:
  void find(const Sphere& s) { add_ball(0, at_.position, s.radius); }
  void find(const Capsule& s) {
    const Vec3d arm = s.half_length * at_.orientation.z;
    add_ball(0, at_.position - arm, s.radius);
    add_ball(1, at_.position + arm, s.radius);
    add_rod(s);
  }
  void find(const Plane&) {}
  void find(const Convex& s) {
    const auto& vertices = s.hull->vertices;
    const auto point = [&](int i) { return at_.position + at_.orientation * vertices[i]; };
    const auto depth = [&](int i) { return depth_below(point(i)); };
    const geometry::Chosen chosen = geometry::choose_spread(static_cast<int>(vertices.size()), point, depth);
    for (int k = 0; k < chosen.count; ++k) {
      add(static_cast<std::uint32_t>(chosen.index[k]), point(chosen.index[k]), triangle_.normal, depth(chosen.index[k]),
          0);
    }
    find_ridge_contacts(relief_, index_, shape_, at_, found_);
  }
  template <class Other>
  void find(const Other& s) {
    const geometry::LowPoints points{at_.position, at_.orientation, triangle_.normal};
    points(s, [&](std::uint32_t feature, const Vec3d& p, double radius) {
      const double depth = depth_below(p);
      if (depth > 0) add(feature, p, triangle_.normal, depth, radius);
    });
    find_ridge_contacts(relief_, index_, shape_, at_, found_);
  }

  void add(std::uint32_t feature, const Vec3d& point, const Vec3d& normal, double depth, double radius) {
    found_.push_back({feature, point, normal, depth, radius});
  }
  [[nodiscard]] double height_of(const Vec3d& p) const { return dot(triangle_.normal, p - triangle_.corners[0]); }
  /// [m] Of a point of the triangle's space; else zero.
  [[nodiscard]] double depth_below(const Vec3d& p) const {
    const double depth = -height_of(p);
    return depth > 0 && depth <= triangle_.depth && is_in_space(triangle_, p) ? depth : 0;
  }

  void add_ball(std::uint32_t feature, const Vec3d& center, double radius) {
    const Vec3d& n = triangle_.normal;
    const double height = height_of(center);
    if (height >= radius) return;
    const auto add_face = [&] { add(feature, center - radius * n, n, radius - height, radius); };
    if (height < 0 && height >= -triangle_.depth && is_in_space(triangle_, center)) return add_face();
    const bool above_face = std::ranges::none_of(std::array{0, 1, 2}, [&](int k) {
      return dot(center - triangle_.corners[k], triangle_.edges[k].outward) > on_border;
    });
    if (above_face) {
      if (height >= 0) add_face();
      return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      add_ball_on_edge(feature, center, radius, k);
      if (triangle_.owns_corner[k]) add_ball_on_corner(feature, center, radius, k);
    }
  }

  void add_ball_on_edge(std::uint32_t feature, const Vec3d& center, double radius, std::size_t k) {
    const ReliefEdge& edge = triangle_.edges[k];
    if (!edge.stands_out || !edge.is_own) return;
    const Vec3d &a = triangle_.corners[k], way = triangle_.corners[(k + 1) % 3] - a;
    const double along = dot(center - a, way) / dot(way, way);
    if (!(along > 0 && along < 1)) return;
    const Vec3d nearest = a + along * way, d = center - nearest;
    if (dot(d, edge.outward) < -on_border || dot(d, edge.neighbor_outward) < -on_border) return;
    add_round(feature, nearest, d, radius);
  }

  void add_ball_on_corner(std::uint32_t feature, const Vec3d& center, double radius, std::size_t k) {
    const Vec3d d = center - triangle_.corners[k];
    if (relief_.leads_away(triangle_.vertices[k], d)) add_round(feature, triangle_.corners[k], d, radius);
  }

  /// A point of the surface, and the way from it to the middle of what is round.
  void add_round(std::uint32_t feature, const Vec3d& point, const Vec3d& d, double radius) {
    const double distance = norm(d);
    if (distance < radius && distance > 0) add(feature, point, (1 / distance) * d, radius - distance, radius);
  }

  /// A capsule between its ends touches edges and corners only.
  void add_rod(const Capsule& s) {
    const Vec3d arm = s.half_length * at_.orientation.z;
    for (std::size_t k = 0; k < 3; ++k) {
      const ReliefEdge& edge = triangle_.edges[k];
      const Vec3d &a = triangle_.corners[k], &b = triangle_.corners[(k + 1) % 3];
      if (edge.stands_out && edge.is_own) {
        const geometry::Segment rod{at_.position, arm}, line{0.5 * (a + b), 0.5 * (b - a)};
        const auto places = geometry::closest_places(rod, line);
        if (std::abs(places.s) < 1 && std::abs(places.t) < 1) {
          const Vec3d on_edge = line.at(places.t), d = rod.at(places.s) - on_edge;
          if (dot(d, edge.outward) >= 0 && dot(d, edge.neighbor_outward) >= 0) {
            add_round(ridge_feature(index_, k, 0), on_edge, d, s.radius);
          }
        }
      }
      if (!triangle_.owns_corner[k] || !(dot(arm, arm) > 0)) continue;
      const double along = dot(a - at_.position, arm) / dot(arm, arm);
      const Vec3d d = at_.position + along * arm - a;
      if (std::abs(along) < 1 && relief_.leads_away(triangle_.vertices[k], d)) {
        add_round(corner_feature(triangle_.vertices[k]), a, d, s.radius);
      }
    }
  }

  const Relief& relief_;
  int index_;
  const ReliefTriangle& triangle_;
  const Shape& shape_;
  const Transformd& at_;
  std::vector<ReliefContact>& found_;
};

/// Found by two triangles that touch a point alike, or of which both have the point in their space.
bool are_one(const ReliefContact& a, const ReliefContact& b) {
  const Vec3d apart = a.point - b.point, turn = a.normal - b.normal;
  if (dot(apart, apart) < on_border * on_border) return true;
  return dot(turn, turn) < 1e-12 && std::abs(a.depth - b.depth) <= 1e-6 * std::max(a.depth, b.depth);
}

/// Those of one place become one, sooner out of the ground, and all get features of their own.
void tidy(std::vector<ReliefContact>& contacts) noexcept {
  constexpr std::uint32_t next_of_feature =
      1u << 22;  // above the vertices of any hull, below edges and corners (ridge_contact.h)
  constexpr std::uint32_t most = 60;
  insertion_sort(contacts.begin(), contacts.end(),
                 [](const ReliefContact& a, const ReliefContact& b) { return a.feature < b.feature; });
  std::size_t kept = 0, first_of_feature = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (kept > 0 && contacts[i].feature != contacts[kept - 1].feature) first_of_feature = kept;
    const auto same = std::span(contacts).subspan(first_of_feature, kept - first_of_feature);
    const auto known =
        std::ranges::find_if(same, [&](const ReliefContact& other) { return are_one(other, contacts[i]); });
    if (known == same.end()) {
      contacts[kept++] = contacts[i];
    } else if (contacts[i].depth < known->depth) {
      *known = contacts[i];  // the nearer face is the way out
    }
  }
  contacts.resize(kept);
  std::uint32_t count = 0, last = 0;
  for (std::size_t i = 0; i < kept; ++i) {
    count = i > 0 && contacts[i].feature == last ? std::min(count + 1, most) : 0;
    last = contacts[i].feature;
    contacts[i].feature += count * next_of_feature;
  }
  insertion_sort(contacts.begin(), contacts.end(),
                 [](const ReliefContact& a, const ReliefContact& b) { return a.feature < b.feature; });
}

}  // namespace

void find_relief_contacts(const Shape& shape, const Transformd& at, const Relief& relief, const Transformd& at_relief,
                          std::span<const int> triangles, std::vector<ReliefContact>& found) {
  found.clear();
  const Transformd inside = in_frame(at_relief, at);
  const double reach = bounding_radius(shape);
  for (const int i : triangles) {
    MUROSIMF_ASSERT(i >= 0 && static_cast<std::size_t>(i) < relief.triangles().size());
    const ReliefTriangle& triangle = relief.triangles()[i];
    if (dot(triangle.normal, inside.position - triangle.corners[0]) < reach) {
      TriangleContact(relief, i, shape, inside, found).find();
    }
  }
  if (found.empty()) return;
  tidy(found);
  for (ReliefContact& contact : found) {
    contact.point = at_relief.position + at_relief.orientation * contact.point;
    contact.normal = at_relief.orientation * contact.normal;
  }
}

}  // namespace murosimf::collision
