#include "murosimf/appearance/jersey_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "murosimf/geometry/digit_triangles.h"
#include "murosimf/geometry/ray.h"
#include "murosimf/geometry/support.h"
#include "murosimf/math/assert.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::appearance {
namespace {

constexpr double width_share = 0.3;   // [1] of the trunk's width: half of the plate's
constexpr double height_share = 0.4;  // [1] of its height
constexpr double widest = 1.5;        // [1] width over height
constexpr double distance = 1e-3;     // [m] from the surface
constexpr int rays = 17;              // along each side of a plate
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A frame in the base's, joints at zero.
struct PlateFrame {
  Vec3d r;
  Mat3d R;
};

struct Box {
  void add(const Vec3d& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  [[nodiscard]] Vec3d size() const { return high - low; }
  [[nodiscard]] double volume() const { return low.x > high.x ? 0 : size().x * size().y * size().z; }
  Vec3d low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
};

/// Visible parts of one link, in axes of the base.
struct Part {
  std::vector<std::array<Vec3d, 3>> triangles;
  std::vector<std::pair<Shape, Transformd>> shapes;
  Box box;
};

std::vector<PlateFrame> frames_of(const Model& model) {
  const auto count = static_cast<std::size_t>(model.size());
  std::vector<Vec3d> r(count);
  std::vector<Mat3d> R(count);
  multibody::poses<double>(model.tree(), std::vector<double>(count, 0.0), r, R);
  std::vector<PlateFrame> frames;
  for (int object = 0; object < model.size(); ++object) {
    const FixedObject placed = model.placement(object);
    const int link = model.tree().links[placed.link].object;
    frames.push_back({r[link] + R[link] * placed.offset, R[link] * placed.turn});
  }
  return frames;
}

void add_mesh(const SeenMesh& seen, const PlateFrame& frame, Part& part) {
  const auto at = [&](std::uint32_t i) {
    MUROSIMF_ASSERT(i < seen.mesh.vertices.size());
    return frame.r + frame.R * seen.mesh.vertices[i];
  };
  for (const auto& [a, b, c] : seen.mesh.triangles) {
    part.triangles.push_back({at(a), at(b), at(c)});
    for (const Vec3d& p : part.triangles.back()) part.box.add(p);
  }
}

void add_shape(const SeenShape& seen, const PlateFrame& frame, Part& part) {
  const PlacedShape& placed = seen.placed;
  if (std::holds_alternative<Plane>(placed.shape)) return;
  const Mat3d R = frame.R * placed.orientation;
  const Vec3d r = frame.r + frame.R * placed.position;
  part.shapes.emplace_back(placed.shape, Transformd{r, R});
  for (const Vec3d& d : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
    for (const double sign : {-1.0, 1.0}) {
      part.box.add(r + R * geometry::support(placed.shape, transposed_times(R, sign * d)));
    }
  }
}

/// Visible parts by link.
std::vector<Part> parts_of(const Model& model, const Appearance& appearance, const std::vector<PlateFrame>& frames) {
  MUROSIMF_ASSERT(frames.size() == static_cast<std::size_t>(model.size()));
  const Tree& tree = model.tree();
  std::vector<Part> parts(tree.links.size());
  for (const SeenMesh& seen : appearance.meshes) add_mesh(seen, frames[seen.object], parts[tree.link_of[seen.object]]);
  for (const SeenShape& seen : appearance.shapes)
    add_shape(seen, frames[seen.object], parts[tree.link_of[seen.object]]);
  return parts;
}

std::size_t find_trunk(const Tree& tree, const std::vector<Part>& parts) {
  MUROSIMF_ASSERT(!parts.empty() && parts.size() == tree.links.size());
  std::vector<int> limbs(parts.size());
  for (const Link& link : tree.links) {
    if (link.parent >= 0) ++limbs[link.parent];
  }
  std::size_t trunk = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (limbs[i] >= 2 && parts[i].box.volume() > parts[trunk].box.volume()) trunk = i;
  }
  return trunk;
}

/// A rectangle that looks along x, or against it if `side` is -1.
struct Window {
  Vec3d center;
  double half_width = 0, half_height = 0, side = 1;
};

/// The part of a polygon at p[axis] * sign <= limit (Sutherland and Hodgman).
std::vector<Vec3d> cut(const std::vector<Vec3d>& polygon, double Vec3d::*axis, double sign, double limit) {
  std::vector<Vec3d> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = limit - sign * a.*axis, to = limit - sign * b.*axis;
    if (from >= 0) kept.push_back(a);
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) kept.push_back(a + (from / (from - to)) * (b - a));
  }
  return kept;
}

/// [m] Largest extent of the triangle behind the window, along its side; -infinity if it is not behind it.
double outermost(const std::array<Vec3d, 3>& triangle, const Window& window) {
  std::vector<Vec3d> polygon(triangle.begin(), triangle.end());
  for (const double sign : {-1.0, 1.0}) {
    polygon = cut(polygon, &Vec3d::y, sign, sign * window.center.y + window.half_width);
    polygon = cut(polygon, &Vec3d::z, sign, sign * window.center.z + window.half_height);
  }
  double most = -infinity;
  for (const Vec3d& p : polygon) most = std::max(most, window.side * p.x);
  return most;
}

/// The same for a shape, by rays.
double outermost(const std::pair<Shape, Transformd>& shape, const Window& window, double far) {
  double most = -infinity;
  for (int i = 0; i < rays; ++i) {
    for (int j = 0; j < rays; ++j) {
      const double u = 2.0 * i / (rays - 1) - 1, v = 2.0 * j / (rays - 1) - 1;
      const Vec3d origin{window.side * far, window.center.y + u * window.half_width,
                         window.center.z + v * window.half_height};
      const auto entry = geometry::meet({origin, {-window.side, 0, 0}}, shape.first, shape.second);
      if (entry) most = std::max(most, far - entry->distance);
    }
  }
  return most;
}

/// Moves the window in front of the part.
void push_out(const Part& part, Window& window) {
  MUROSIMF_ASSERT(std::abs(window.side) == 1);
  const double edge = window.side > 0 ? part.box.high.x : -part.box.low.x;
  double most = -infinity;
  for (const auto& triangle : part.triangles) most = std::max(most, outermost(triangle, window));
  for (const auto& shape : part.shapes) most = std::max(most, outermost(shape, window, edge + 1));
  window.center.x = window.side * ((most > -infinity ? most : edge) + distance);
}

Window window_on(const Part& trunk, double side) {
  const Vec3d size = trunk.box.size();
  Window window{0.5 * (trunk.box.low + trunk.box.high), width_share * size.y, 0, side};
  window.half_height = std::min(window.half_width, height_share * size.z);
  window.half_width = std::min(window.half_width, widest * window.half_height);
  push_out(trunk, window);
  return window;
}

}  // namespace

std::vector<JerseyNumber> jersey_numbers(const Model& model, const Appearance& appearance) {
  const auto frames = frames_of(model);
  const auto parts = parts_of(model, appearance, frames);
  const std::size_t trunk = find_trunk(model.tree(), parts);
  if (!(parts[trunk].box.volume() > 0)) return {};
  const int object = model.tree().links[trunk].object;
  const auto& [r, R] = frames[object];
  std::vector<JerseyNumber> plates;
  for (const double side : {1.0, -1.0}) {
    const Window window = window_on(parts[trunk], side);
    plates.push_back({object, transposed_times(R, window.center - r), transposed_times(R, Vec3d{0, side, 0}),
                      transposed_times(R, Vec3d{0, 0, 1}), window.half_width, window.half_height});
  }
  MUROSIMF_ASSERT(plates.size() == 2);
  return plates;
}

geometry::TriangleMesh number_on(const JerseyNumber& plate, int number) {
  geometry::TriangleMesh mesh = geometry::digit_triangles(number);
  const double height = 2 * std::min(plate.half_height, plate.half_width / geometry::number_width(number));
  for (Vec3d& v : mesh.vertices) v = plate.center + height * (v.x * plate.right + v.y * plate.up);
  return mesh;
}

}  // namespace murosimf::appearance
