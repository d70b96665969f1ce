#include "murosimf/geometry/mesh_reduction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "murosimf/geometry/error_quadric.h"
#include "murosimf/geometry/shrinking_mesh.h"

namespace murosimf::geometry {
namespace {

using Index = ShrinkingMesh::Index;

constexpr double crease_width = 1e-3;   // [m] moving a crease costs as much as moving a strip of this width
constexpr double smooth = 0.7;          // [1] cosine of the angle between triangles up to which their edge is no crease
constexpr double least_weight = 1e-12;  // [m^2] so that what costs nothing goes by length
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Drawing a vertex to the best of its neighbors.
struct Collapse {
  double cost = infinity;  // [m^4] area times squared distance
  Index to = std::numeric_limits<Index>::max();
};

/// A vertex and what its collapse costs at least.
struct Candidate {
  double cost;
  Index vertex;
  bool operator<(const Candidate& other) const {  // the cheapest is the largest
    return std::tie(other.cost, other.vertex) < std::tie(cost, vertex);
  }
};

class Reducer {
 public:
  explicit Reducer(const std::vector<TriangleMesh>& meshes)
      : mesh_(meshes), quadrics_(mesh_.vertices().size()), bounds_(mesh_.vertices().size(), infinity) {
    for (const auto& corners : mesh_.faces()) add_area(corners);
    add_creases();
  }

  /// First without turning triangles over; what is left then takes any way.
  void reduce(std::size_t most) {
    for (const bool careful : {true, false}) {
      careful_ = careful;
      queue_ = {};
      for (Index v = 0; v < bounds_.size(); ++v) enter(v, mesh_.around(v).empty() ? infinity : 0);
      while (mesh_.left() > most && !queue_.empty()) take_next();
    }
  }

  [[nodiscard]] double error() const { return area_ > 0 ? std::sqrt(cost_ / area_) : 0; }
  [[nodiscard]] std::vector<TriangleMesh> meshes() const { return mesh_.meshes(); }

 private:
  void add_area(const ShrinkingMesh::Corners& corners) {
    const Vec3d n = mesh_.normal(corners);
    const double twice = norm(n);
    if (!(twice > 0)) return;
    area_ += 0.5 * twice;
    for (const Index c : corners) quadrics_[c].add_plane((1 / twice) * n, mesh_.vertices()[c], twice / 6);
  }

  void add_creases() {
    for (Index f = 0; f < mesh_.faces().size(); ++f) {
      const auto& corners = mesh_.faces()[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = corners[k], b = corners[(k + 1) % 3];
        if (!is_smooth(a, b, f)) add_crease(a, b, f);
      }
    }
  }

  /// One other triangle continues the surface across the edge.
  [[nodiscard]] bool is_smooth(Index a, Index b, Index face) const {
    int others = 0;
    bool bends = false;
    const Vec3d n = mesh_.normal(mesh_.faces()[face]);
    for (const Index f : mesh_.around(a)) {
      if (f == face || !mesh_.has(f, b)) continue;
      ++others;
      const Vec3d m = mesh_.normal(mesh_.faces()[f]);
      bends = bends || dot(n, m) < smooth * norm(n) * norm(m) || !mesh_.share_places(face, f, a, b);
    }
    return others == 1 && !bends;
  }

  /// A plane through the edge, across the triangle.
  void add_crease(Index a, Index b, Index face) {
    const auto at = mesh_.vertices();
    const Vec3d edge = at[b] - at[a], across = cross(edge, mesh_.normal(mesh_.faces()[face]));
    if (!(norm(across) > 0)) return;
    const double weight = 0.5 * crease_width * norm(edge);
    for (const Index end : {a, b}) quadrics_[end].add_plane((1 / norm(across)) * across, at[a], weight);
  }

  void enter(Index vertex, double bound) {
    bounds_[vertex] = bound;
    if (bound < infinity) queue_.push({bound, vertex});
  }

  [[nodiscard]] double cost(Index from, Index to) const {
    const Vec3d& p = mesh_.vertices()[to];
    const Vec3d way = p - mesh_.vertices()[from];
    return std::max(0.0, quadrics_[from](p)) + least_weight * dot(way, way);
  }

  /// The cheapest that is allowed.
  [[nodiscard]] Collapse best(Index from) const {
    Collapse found;
    for (const Index f : mesh_.around(from)) {
      for (const Index to : mesh_.faces()[f]) {
        if (to == from || to == found.to) continue;
        const double c = cost(from, to);
        const bool better = c < found.cost || (c == found.cost && to < found.to);
        if (better && !(careful_ && mesh_.turns_a_face(from, to))) found = {c, to};
      }
    }
    return found;
  }

  /// Bounds may be too low; a vertex whose bound is right is drawn to its neighbor.
  void take_next() {
    const Candidate next = queue_.top();
    queue_.pop();
    if (next.cost != bounds_[next.vertex]) return;  // it has another one by now
    const Collapse collapse = best(next.vertex);
    if (collapse.cost > next.cost) return enter(next.vertex, collapse.cost);
    draw_together(next.vertex, collapse);
  }

  void draw_together(Index from, const Collapse& collapse) {
    const Index to = collapse.to;
    cost_ += collapse.cost;
    quadrics_[to] += quadrics_[from];
    bounds_[from] = infinity;
    mesh_.draw_together(from, to);
    double lowest = infinity;
    for (const Index f : mesh_.around(to)) {
      for (const Index other : mesh_.faces()[f]) {
        if (other == to) continue;
        lowest = std::min(lowest, cost(to, other));
        if (const double c = cost(other, to); c < bounds_[other]) enter(other, c);
      }
    }
    enter(to, lowest);
  }

  ShrinkingMesh mesh_;
  std::vector<ErrorQuadric> quadrics_;  // of each vertex
  std::vector<double> bounds_;          // of each vertex: its collapse costs at least this; infinite: not in the queue
  std::priority_queue<Candidate> queue_;
  double area_ = 0, cost_ = 0;
  bool careful_ = true;
};

}  // namespace

MeshReduction reduce_meshes(std::vector<TriangleMesh> meshes, std::size_t most) {
  std::size_t triangles = 0;
  for (const TriangleMesh& mesh : meshes) triangles += mesh.triangles.size();
  if (triangles <= most) return {std::move(meshes), 0};
  Reducer reducer(meshes);
  reducer.reduce(most);
  return {reducer.meshes(), reducer.error()};
}

}  // namespace murosimf::geometry
