// Two boxes: of the 15 directions that can be normals of faces of their sum (axes of either, and products of edges) the
// one of least overlap. Source: S. Gottschalk, M. C. Lin and D. Manocha, OBBTree, 1996, sec. 5.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "murosimf/geometry/box_parts.h"
#include "murosimf/geometry/build_manifold.h"
#include "murosimf/geometry/pair_tests.h"
#include "murosimf/math/assert.h"

namespace murosimf::geometry {
namespace {

constexpr double prefer_earlier = 1 - 1e-6;  // faces before edges, where rounding would choose
constexpr double parallel_edges = 1e-6;      // sine below which the product of two edges is no direction

/// B seen from A.
struct TwoBoxes {
  const BoxParts &a, &b;
  std::array<double, 3> t, t_in_b;               // from A to B, in axes of A and of B
  std::array<std::array<double, 3>, 3> c, size;  // cosines between axes i of A and j of B, and their magnitudes

  TwoBoxes(const BoxParts& first, const BoxParts& second) : a(first), b(second) {
    const Vec3d way = b.center - a.center;
    for (int i = 0; i < 3; ++i) {
      t[i] = dot(a.axis[i], way);
      t_in_b[i] = dot(b.axis[i], way);
      for (int j = 0; j < 3; ++j) {
        c[i][j] = dot(a.axis[i], b.axis[j]);
        size[i][j] = std::abs(c[i][j]);
      }
    }
  }
};

/// The best direction so far.
struct Least {
  double overlap = std::numeric_limits<double>::infinity();
  int edge_a = -1, edge_b = -1;  // for products of edges
  Vec3d from_a;                  // roughly from A to B

  /// False if the boxes are apart.
  bool see_face(double overlap_here, const Vec3d& axis, double way) {
    if (!(overlap_here > 0)) return false;
    if (overlap_here < prefer_earlier * overlap) {
      overlap = overlap_here;
      from_a = way < 0 ? -axis : axis;
    }
    return true;
  }
};

bool see_faces(const TwoBoxes& p, Least& least) {
  for (int i = 0; i < 3; ++i) {
    const double reach = p.b.half[0] * p.size[i][0] + p.b.half[1] * p.size[i][1] + p.b.half[2] * p.size[i][2];
    if (!least.see_face(p.a.half[i] + reach - std::abs(p.t[i]), p.a.axis[i], p.t[i])) return false;
  }
  for (int j = 0; j < 3; ++j) {
    const double reach = p.a.half[0] * p.size[0][j] + p.a.half[1] * p.size[1][j] + p.a.half[2] * p.size[2][j];
    if (!least.see_face(p.b.half[j] + reach - std::abs(p.t_in_b[j]), p.b.axis[j], p.t_in_b[j])) return false;
  }
  return true;
}

bool see_edges(const TwoBoxes& p, Least& least) {
  MUROSIMF_ASSERT(least.overlap > 0);
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double square = p.c[i1][j] * p.c[i1][j] + p.c[i2][j] * p.c[i2][j];  // of the product's length
      if (square < parallel_edges * parallel_edges) continue;
      const double reach = p.a.half[i1] * p.size[i2][j] + p.a.half[i2] * p.size[i1][j] + p.b.half[j1] * p.size[i][j2] +
                           p.b.half[j2] * p.size[i][j1];
      const double way = p.t[i2] * p.c[i1][j] - p.t[i1] * p.c[i2][j];
      const double overlap = reach - std::abs(way);
      if (!(overlap > 0)) return false;
      const double limit = prefer_earlier * least.overlap;
      if (overlap * overlap >= limit * limit * square) continue;
      const double length = std::sqrt(square);
      least.overlap = overlap / length;
      least.edge_a = i;
      least.edge_b = j;
      least.from_a = ((way < 0 ? -1 : 1) / length) * cross(p.a.axis[i], p.b.axis[j]);
    }
  }
  return true;
}

void meet_at_edges(const BoxParts& a, const BoxParts& b, const Least& least, const Penetration& penetration,
                   Manifold& found) {
  const Vec3d& n = least.from_a;
  const Segment edge_a = a.edge(least.edge_a, n), edge_b = b.edge(least.edge_b, -n);
  MUROSIMF_ASSERT(least.edge_a >= 0 && least.edge_a < 3 && least.edge_b >= 0 && least.edge_b < 3);
  const auto [s, t] = closest_places(edge_a, edge_b);
  const std::uint32_t name = joined(a.edge_name(least.edge_a, n), 64 + b.edge_name(least.edge_b, -n));
  only_point(penetration, 0.5 * (edge_a.at(s) + edge_b.at(t)), name, found);
}

/// True if a face of either lies about flat against the other.
bool meet_at_faces(const BoxParts& a, const BoxParts& b, const Vec3d& from_a, Manifold& found) {
  const int i = a.axis_along(from_a), j = b.axis_along(from_a);
  const double flat_a = std::abs(dot(a.axis[i], from_a)), flat_b = std::abs(dot(b.axis[j], from_a));
  if (std::max(flat_a, flat_b) < flat) return false;
  // A's face, unless B's fits clearly better: the choice must not change while one rocks on the other
  const bool on_a = flat_a >= flat;
  Outline<8> reference, incident;
  (on_a ? a : b).face(on_a ? i : j, on_a ? from_a : -from_a, reference);
  (on_a ? b : a).face(on_a ? j : i, on_a ? -from_a : from_a, incident);
  reference.name += on_a ? 0 : 32;
  const Vec3d out = on_a ? from_a : -from_a;
  clip_by_sides(incident, reference, out);
  add_points_below(incident, reference, out, found);
  return found.count > 0;
}

}  // namespace

bool collide_boxes(const Box& box_a, const Transformd& at_a, const Box& box_b, const Transformd& at_b,
                   Manifold& found) {
  const BoxParts a(box_a, at_a), b(box_b, at_b);
  const TwoBoxes pair(a, b);
  Least least;
  if (!see_faces(pair, least) || !see_edges(pair, least)) return false;
  const Penetration penetration{-least.from_a, least.overlap};
  begin(penetration, found);
  if (meet_at_faces(a, b, least.from_a, found)) {
    finish(penetration, found);
  } else if (least.edge_a >= 0) {
    meet_at_edges(a, b, least, penetration, found);
  } else {
    only_point(penetration, 0.5 * (a.center + b.center), 0, found);
  }
  return true;
}

}  // namespace murosimf::geometry
