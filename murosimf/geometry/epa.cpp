#include "murosimf/geometry/epa.h"

#include <array>
#include <cmath>
#include <limits>

#include "murosimf/geometry/descent.h"
#include "murosimf/math/assert.h"

namespace murosimf::geometry {
namespace {

constexpr int most_vertices = 100;
constexpr int most_faces = 2 * most_vertices;

struct Face {
  std::array<int, 3> corner{};  // counterclockwise seen from outside
  Vec3d normal;                 // unit
  double height = 0;            // of its plane above the origin
};

/// The polyhedron inside B - A: its support in direction n is the shift along n.
class Polyhedron {
 public:
  Polyhedron(const Body& a, const Body& b, double size) : a_(a), b_(b), tiny_(1e-13 * size) {}

  [[nodiscard]] Vec3d support(const Vec3d& n) const { return b_.core_support(n) - a_.core_support(-n); }

  /// A tetrahedron: the ends along x, the farthest from their line, the farthest from their plane.
  void start() {
    const Vec3d p = support({1, 0, 0}), q = support({-1, 0, 0});
    const Vec3d along = p - q;
    const Vec3d aside =
        std::abs(along.y) < std::abs(along.z) ? cross(along, Vec3d{0, 1, 0}) : cross(along, Vec3d{0, 0, 1});
    const Vec3d r = farther(aside, q);
    const Vec3d upright = cross(along, r - q);
    const Vec3d s = farther(upright, q);
    const bool above = dot(upright, s - q) > 0;
    vertices_ = {p, q, above ? r : s, above ? s : r};
    vertex_count_ = 4;
    // seen from the last vertex the first three turn counterclockwise
    turn_outwards();
  }
  /// The face that is lowest above the origin.
  [[nodiscard]] int lowest() const {
    int best = 0;
    for (int i = 1; i < face_count_; ++i) {
      if (faces_[i].height < faces_[best].height) best = i;
    }
    return best;
  }
  [[nodiscard]] const Face& face(int i) const {
    MUROSIMF_ASSERT(i >= 0 && i < face_count_);
    return faces_[i];
  }
  /// Replaces all faces below the new vertex. False if there is no room, or none is below it.
  [[nodiscard]] bool grow(const Vec3d& vertex) {
    if (vertex_count_ == most_vertices) return false;
    edge_count_ = 0;
    int kept = 0;
    for (int i = 0; i < face_count_; ++i) {
      const Face face = faces_[i];
      if (dot(face.normal, vertex) - face.height > tiny_) {
        for (int k = 0; k < 3; ++k) open(face.corner[k], face.corner[(k + 1) % 3]);
      } else {
        faces_[kept++] = face;
      }
    }
    face_count_ = kept;
    if (edge_count_ == 0 || kept + edge_count_ > most_faces) return false;
    vertices_[vertex_count_] = vertex;
    for (int e = 0; e < edge_count_; ++e) add_face(edges_[e][0], edges_[e][1], vertex_count_);
    ++vertex_count_;
    return true;
  }

 private:
  [[nodiscard]] Vec3d farther(const Vec3d& d, const Vec3d& from) const {
    const Vec3d plus = support(d), minus = support(-d);
    return dot(d, plus - from) >= dot(d, from - minus) ? plus : minus;
  }
  void turn_outwards() {
    constexpr std::array<std::array<int, 4>, 4> sides{{{0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}}};
    for (const auto& [i, j, k, opposite] : sides) {
      const Vec3d n = cross(vertices_[j] - vertices_[i], vertices_[k] - vertices_[i]);
      const bool inwards = dot(n, vertices_[opposite] - vertices_[i]) > 0;
      add_face(i, inwards ? k : j, inwards ? j : k);
    }
  }
  void add_face(int i, int j, int k) {
    const Vec3d n = cross(vertices_[j] - vertices_[i], vertices_[k] - vertices_[i]);
    const double size = norm(n);
    MUROSIMF_ASSERT(face_count_ < most_faces);
    Face& face = faces_[face_count_++];
    face.corner = {i, j, k};
    if (size > tiny_ * tiny_) {
      face.normal = (1 / size) * n;
      face.height = dot(face.normal, vertices_[i]);
    } else {
      // no area: its neighbors lie in the same plane
      face.normal = {};
      face.height = std::numeric_limits<double>::infinity();
    }
  }
  /// An edge of a removed face; those of two removed ones vanish.
  void open(int from, int to) {
    for (int e = 0; e < edge_count_; ++e) {
      if (edges_[e][0] == to && edges_[e][1] == from) {
        edges_[e] = edges_[--edge_count_];
        return;
      }
    }
    if (edge_count_ < most_faces) edges_[edge_count_++] = {from, to};
  }

  const Body &a_, &b_;
  double tiny_;  // [m]
  int vertex_count_ = 0, face_count_ = 0, edge_count_ = 0;
  std::array<Vec3d, most_vertices> vertices_;
  std::array<Face, most_faces> faces_;
  std::array<std::array<int, 2>, most_faces> edges_;
};

bool is_curved(const Body& body) {
  return std::holds_alternative<Cylinder>(body.shape()) || std::holds_alternative<Ellipsoid>(body.shape());
}

/// The least shift so far.
struct Least {
  Deepest deepest;
  bool settled = false;  // at a local minimum, and with its points
};

/// Takes a direction in, if it is better. For curved bodies the local minimum below it, once the polyhedron is no longer
/// coarse: with its surface point as a vertex, the faces around lie about as high, and need not be made finer.
void take(const Descent& descent, const Face& face, double shift, double coarse, Polyhedron& polyhedron, Least& least) {
  Penetration& penetration = least.deepest.penetration;
  if (!(shift < penetration.depth)) return;
  if (shift - face.height > coarse) {
    penetration = {face.normal, shift};
    least.settled = false;
    return;
  }
  const Deepest here = descent.from(face.normal);
  if (!(here.penetration.depth < penetration.depth)) return;
  least = {here, true};
  (void)polyhedron.grow(polyhedron.support(here.penetration.normal));
}

}  // namespace

Deepest deepest_of_cores(const Body& a, const Body& b, double size) {
  const Descent descent(a, b, size);
  const double tolerance = 1e-5 * size;
  const double coarse = is_curved(a) || is_curved(b) ? 0.02 * size : -1;
  Polyhedron polyhedron(a, b, size);
  polyhedron.start();
  Least least;
  least.deepest.penetration = {{0, 0, 1}, std::numeric_limits<double>::infinity()};
  const double& depth = least.deepest.penetration.depth;
  while (true) {
    const Face face = polyhedron.face(polyhedron.lowest());
    if (!(depth - face.height > tolerance)) break;
    const Vec3d vertex = polyhedron.support(face.normal);
    take(descent, face, dot(vertex, face.normal), coarse, polyhedron, least);
    if (!(depth - face.height > tolerance) || !polyhedron.grow(vertex)) break;
  }
  return least.settled ? least.deepest : descent.from(least.deepest.penetration.normal);
}

}  // namespace murosimf::geometry
