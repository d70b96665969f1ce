#include "murosimf/collision/colliding_shapes.h"

#include <algorithm>
#include <limits>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

/// Longest travel [m] of a slider; infinite without limits.
double longest_travel(const Model& model, int joint) {
  const Vec3d* range = model.find(properties::joint_range, joint);
  return range ? std::max(std::abs(range->x), std::abs(range->y)) : std::numeric_limits<double>::infinity();
}

/// Transform of a joint at its position nearest to zero.
Transformd moved(const Object& joint, const Vec3d& range) {
  MUROSIMF_ASSERT(range.x <= range.y);
  const double q = std::clamp(0.0, range.x, range.y);
  if (q == 0) return {};
  if (joint.kind == Kind::prismatic) return {q * joint.vector, {}};
  return {{}, to_matrix(exponential(q * joint.vector))};
}

std::vector<CollidingShape> shapes_where(const Model& model, bool planes) {
  std::vector<CollidingShape> result;
  for (const int object : model.bodies()) {
    const Shapes* shapes = model.find(properties::shapes, object);
    if (!shapes) continue;
    int index = 0;
    for (const PlacedShape& placed : *shapes) {
      if (placed.collides && std::holds_alternative<Plane>(placed.shape) == planes) {
        result.push_back({object, index, placed});
      }
      ++index;
    }
  }
  return result;
}

}  // namespace

std::vector<CollidingShape> colliding_shapes(const Model& model) { return shapes_where(model, false); }
std::vector<CollidingShape> colliding_planes(const Model& model) { return shapes_where(model, true); }

double farthest_reach(const Model& model) {
  double reach = 0;
  for (const CollidingShape& shape : colliding_shapes(model)) {
    // the longest chain of offsets from the base, and the size of the shape at its end
    double length = norm(shape.placed.position) + bounding_radius(shape.placed.shape);
    for (int i = shape.object; i >= 0; i = model.objects()[i].parent) {
      if (model.objects()[i].kind == Kind::translation) length += norm(model.objects()[i].vector);
      if (model.objects()[i].kind == Kind::prismatic) length += longest_travel(model, i);
    }
    reach = std::max(reach, length);
  }
  return reach;
}

std::vector<Transformd> rest_poses(const Model& model) {
  std::vector<Transformd> poses(static_cast<std::size_t>(model.size()));
  for (int i = 0; i < model.size(); ++i) {
    const Object& object = model.objects()[i];
    if (object.parent < 0) continue;
    Transformd step;
    if (object.kind == Kind::translation) step.position = object.vector;
    if (object.kind == Kind::rotation) step.orientation = object.turn;
    if (const Vec3d* range = model.find(properties::joint_range, i)) step = moved(object, *range);
    poses[i] = poses[object.parent] * step;
    MUROSIMF_ASSERT(object.parent < i);
  }
  return poses;
}

}  // namespace murosimf::collision
