/// shape.h - geometry and surface of bodies: plain data, no algorithms.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "murosimf/math/transform.h"

namespace murosimf {

// All lengths in meters. The shape's own frame: center at the origin, long axis along z.
struct Sphere {
  double radius = 0;
};
struct Box {
  Vec3d half_size;
};
struct Capsule {
  double radius = 0;
  double half_length = 0;  ///< of the straight part
};
struct Cylinder {
  double radius = 0;
  double half_length = 0;
};
struct Ellipsoid {
  Vec3d semi_axes;
};
struct Plane {};  ///< infinite, z = 0, solid below

/// A convex polyhedron, shared by all shapes that are made of it (geometry/hull.h makes one of points).
struct ConvexHull {
  std::vector<Vec3d> vertices;                    ///< [m] shape frame
  std::vector<std::vector<std::uint32_t>> faces;  ///< corners of each face, counterclockwise seen from outside
  std::vector<Vec3d> normals;                     ///< [1] of each face, unit, outwards
  /// Vertices joined to vertex i by an edge: neighbors[first_neighbor[i]] to neighbors[first_neighbor[i + 1] - 1].
  std::vector<std::uint32_t> first_neighbor, neighbors;
};
/// The middle of its axis-aligned box is at the origin.
struct Convex {
  std::shared_ptr<const ConvexHull> hull;
};

using Shape = std::variant<Sphere, Box, Capsule, Cylinder, Ellipsoid, Plane, Convex>;

/// "sphere", "box", ... as in MJCF; "mesh" for a convex polyhedron.
[[nodiscard]] const char* shape_name(const Shape& shape);

/// Radius of the smallest sphere about the shape's origin that encloses it [m]; infinite for a plane.
[[nodiscard]] double bounding_radius(const Shape& shape);

struct Color {
  double red = 0.5, green = 0.5, blue = 0.5;
  double alpha = 1;  ///< [1] 0: cannot be seen; below 1: what is behind shines through
  friend bool operator==(const Color&, const Color&) = default;
};

/// What a surface is made of. The force between two surfaces depends on the pair (material.h).
struct Surface {
  std::string material;      ///< name in the pair table; empty: only the friction below counts
  double friction = 0.8;     ///< [1] Coulomb coefficient used where the pair is not in the table
  Vec3d friction_direction;  ///< [1] of the ground: where its pile leans, shape frame, any length; zero: nowhere
};

/// A shape at its place on an object.
struct PlacedShape {
  Shape shape;
  Vec3d position;     ///< [m] of the shape's origin, object frame
  Mat3d orientation;  ///< shape axes to object axes
  [[nodiscard]] Transformd place() const { return {position, orientation}; }
  Surface surface;
  Color color;
  bool collides = true;  ///< false: visual only
  /// Which kinds of shapes this one is, and which it touches; one bit per kind (`may_touch`).
  std::uint32_t contact_type = 1, contact_affinity = 1;
};

/// Two shapes touch if one of them touches a kind that the other one is, as MJCF's contype and conaffinity say. It
/// counts within one robot and on the ground; between robots everything touches.
template <class A, class B>
[[nodiscard]] bool may_touch(const A& a, const B& b) {
  return (a.contact_type & b.contact_affinity) != 0 || (b.contact_type & a.contact_affinity) != 0;
}

/// The shape's kinds are the defaults: of such shapes all touch each other.
template <class A>
[[nodiscard]] bool is_usual(const A& shape) {
  return shape.contact_type == 1 && shape.contact_affinity == 1;
}

using Shapes = std::vector<PlacedShape>;

/// Two objects of a model, by name.
using ObjectPair = std::pair<std::string, std::string>;
using ExcludedPairs = std::vector<ObjectPair>;

/// A shape of a model: one of those of an object.
struct ShapeOfObject {
  std::string object;     ///< name
  std::size_t index = 0;  ///< among all shapes of the object
};
using AllowedPairs = std::vector<std::pair<ShapeOfObject, ShapeOfObject>>;

/// The flat bottom of a foot; a property of the frame at its center, x forward, z up.
struct Sole {
  double half_length = 0;  ///< [m] along x
  double half_width = 0;   ///< [m] along y
};

/// A painted line on the ground.
struct Stroke {
  std::vector<Vec3d> points;  ///< [m] polygon, object frame
  double width = 0.05;        ///< [m]
  Color color{1, 1, 1};       ///< of a goal: of its posts and bars, for pictures from above
};

/// What is painted on the ground, and how far it reaches.
struct Markings {
  std::vector<Stroke> strokes;
  double half_length = 0, half_width = 0;  ///< [m] ground to show, from the middle
};

}  // namespace murosimf
