#include "murosimf/model/tree.h"

#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf {
namespace {

struct Placement {
  Vec3d offset;
  Mat3d turn;
  bool turned = false;
};

/// Where an object stands in the frame of its link.
Placement after(const Placement& parent, const Object& object) {
  Placement result = parent;
  if (object.kind == Kind::translation) result.offset += parent.turn * object.vector;
  if (object.kind == Kind::rotation) {
    result.turn = parent.turn * object.turn;
    result.turned = true;
  }
  return result;
}

AxisKind axis_kind(const Vec3d& axis) {
  if (axis.x == 1.0) return AxisKind::x;
  if (axis.y == 1.0) return AxisKind::y;
  if (axis.z == 1.0) return AxisKind::z;
  return AxisKind::general;
}

/// Products of inertia that are rounding against the moments.
bool is_diagonal(const SymMat3d& m) {
  const double rounding = 1e-15 * (m.xx + m.yy + m.zz);
  return std::abs(m.xy) <= rounding && std::abs(m.xz) <= rounding && std::abs(m.yz) <= rounding;
}

/// Merges a mass into the link: center by weights, inertia by the parallel-axis theorem.
/// A body without mass would leave the center undefined.
void add_mass(Link& link, double mass, const Vec3d& com, const SymMat3d& inertia) {
  MUROSIMF_ASSERT(link.mass >= 0 && mass > 0);
  const double sum = link.mass + mass;
  const Vec3d center = (1.0 / sum) * (link.mass * link.com + mass * com);
  link.inertia += link.mass * inertia_of_point(link.com - center);
  link.inertia += inertia + mass * inertia_of_point(com - center);
  link.com = center;
  link.mass = sum;
}

}  // namespace

Tree::Tree(const std::vector<Object>& objects, const ConstantTable& constants) : link_of(objects.size()) {
  std::vector<Placement> placements(objects.size());
  for (int i = 0; i < static_cast<int>(objects.size()); ++i) {
    const Object& object = objects[i];
    if (object.kind == Kind::base || object.is_joint()) {
      Link link;
      link.object = i;
      if (object.is_joint()) {
        MUROSIMF_ASSERT(object.parent >= 0 && object.parent < i);
        const Placement& before = placements[object.parent];
        link.parent = link_of[object.parent];
        link.kind = object.kind == Kind::revolute ? LinkKind::revolute : LinkKind::prismatic;
        link.axis = object.vector;
        link.axis_kind = axis_kind(object.vector);
        link.offset = before.offset;
        link.turn = before.turn;
        link.turned = before.turned;
      }
      // objects come parents first, so links do as well
      link_of[i] = static_cast<int>(links.size());
      links.push_back(link);
    } else {
      MUROSIMF_ASSERT(object.parent >= 0 && object.parent < i);
      placements[i] = after(placements[object.parent], object);
      link_of[i] = link_of[object.parent];
      fixed.push_back({i, link_of[i], placements[i].offset, placements[i].turn, placements[i].turned});
      if (!object.structural) followers.push_back(fixed.back());
    }
    if (const double* m = constants.find(properties::mass, i)) {
      const Vec3d* com = constants.find(properties::center_of_mass, i);
      const SymMat3d* inertia = constants.find(properties::inertia, i);
      const Placement& place = placements[i];
      add_mass(links[link_of[i]], *m, place.offset + place.turn * (com ? *com : Vec3d{}),
               inertia ? rotated(place.turn, *inertia) : SymMat3d{});
      mass += *m;
    }
  }
  MUROSIMF_ASSERT(links.size() + fixed.size() == objects.size() && followers.size() <= fixed.size());
  for (Link& link : links) link.diagonal_inertia = is_diagonal(link.inertia);
}

}  // namespace murosimf
