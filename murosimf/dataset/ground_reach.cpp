#include "murosimf/dataset/ground_reach.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "murosimf/geometry/volume.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::dataset {
namespace {

constexpr double around_joints = 0.05;  // [m] of joints without shapes

/// [m] From the vertical through the origin to the farthest corner of the box.
double farthest(const geometry::Aabb& box) {
  return std::hypot(std::abs(box.center.x) + box.half.x, std::abs(box.center.y) + box.half.y);
}

double reach_of(const Shapes& shapes, const Transformd& object) {
  double reach = 0;
  for (const PlacedShape& one : shapes) {
    if (std::holds_alternative<Plane>(one.shape)) continue;
    reach = std::max(reach, farthest(geometry::fit<geometry::Aabb>(one.shape, object * one.place())));
  }
  return reach;
}

}  // namespace

double ground_reach(const Model& model, std::span<const Vec3d> position, std::span<const Mat3d> orientation) {
  MUROSIMF_ASSERT(position.size() == static_cast<std::size_t>(model.size()) && position.size() == orientation.size());
  double reach = 0;
  const Mat3d level = rotation_z(-heading(orientation[0]));
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Transformd object{level * (position[i] - position[0]), level * orientation[i]};
    const auto number = static_cast<int>(i);
    if (model.objects()[i].is_joint())
      reach = std::max(reach, std::hypot(object.position.x, object.position.y) + around_joints);
    if (const Shapes* shapes = model.find(properties::shapes, number))
      reach = std::max(reach, reach_of(*shapes, object));
  }
  return reach;
}

double Footprint::distance(const Vec3d& point) const {
  const double c = std::cos(heading), s = std::sin(heading), dx = point.x - middle.x, dy = point.y - middle.y;
  const double x = std::max(0.0, std::abs(c * dx + s * dy) - half_x);
  const double y = std::max(0.0, std::abs(c * dy - s * dx) - half_y);
  return std::hypot(x, y);
}

Footprint footprint_of(const Shape& shape, const Transformd& place) {
  const double turned = heading(place.orientation);
  if (std::holds_alternative<Plane>(shape)) return {place.position, turned, 0, 0};
  const auto box = geometry::fit<geometry::Aabb>(shape, {{}, rotation_z(-turned) * place.orientation});
  return {place.position + rotation_z(turned) * box.center, turned, box.half.x, box.half.y};
}

}  // namespace murosimf::dataset
