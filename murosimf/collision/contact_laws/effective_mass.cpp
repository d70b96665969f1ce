#include "murosimf/collision/contact_laws/effective_mass.h"

#include <algorithm>

#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/rigid_inertia.h"

namespace murosimf::collision {
namespace {

/// Whether torques move the joints: more coordinates than those of a rigid body. A level without an answer counts as such.
bool limbs_yield(const MovingEntity& moving_entity) {
  const ImpulseResponse* response = moving_entity.interface.response;
  return !response || response->coordinates() > 6;
}

/// About the origin of the entity's base, world axes.
RigidInertia<double> link_inertia(const MovingEntity& moving_entity, const Link& link) {
  const Mat3d& R = moving_entity.R[link.object];
  const Vec3d c = moving_entity.r[link.object] + R * link.com - moving_entity.r[0];
  return {link.mass, link.mass * c, rotated(R, link.inertia) + link.mass * inertia_of_point(c)};
}

struct MassAndInertia {
  double mass = 0;
  Vec3d center;      // from the origin of the base, world axes
  SymMat3d inertia;  // at the center of mass
};

MassAndInertia at_center(const RigidInertia<double>& sum) {
  MUROSIMF_ASSERT(sum.mass >= 0);
  const Vec3d c = sum.mass > 0 ? (1 / sum.mass) * sum.first : Vec3d{};
  return {sum.mass, c, sum.second - sum.mass * inertia_of_point(c)};
}

/// Inertia of a link; a link without mass moves with its parent.
MassAndInertia inertia_from(const MovingEntity& moving_entity, int link) {
  const std::vector<Link>& links = moving_entity.model().tree().links;
  RigidInertia<double> sum;
  MassAndInertia part;
  for (; link >= 0; link = links[link].parent) {
    sum += link_inertia(moving_entity, links[link]);
    part = at_center(sum);
    if (is_positive_definite(part.inertia)) break;
  }
  return part;
}

MassAndInertia inertia_of_all(const MovingEntity& moving_entity) {
  RigidInertia<double> sum;
  for (const Link& link : moving_entity.model().tree().links) sum += link_inertia(moving_entity, link);
  return at_center(sum);
}

}  // namespace

EffectiveMass::Number EffectiveMass::touch(const MovingEntity& moving_entity, int number, int object) {
  if (!moving_entity.can_be_pushed()) return none;
  MUROSIMF_ASSERT(object >= 0 && object < moving_entity.model().size());
  const bool by_links = limbs_yield(moving_entity);
  const int link = by_links ? moving_entity.model().tree().link_of[object] : 0;
  const auto known = std::find_if(parts_.begin(), parts_.end(),
                                  [&](const Part& part) { return part.entity == number && part.link == link; });
  if (known != parts_.end()) {
    ++known->contacts;
    return static_cast<Number>(known - parts_.begin());
  }
  const MassAndInertia part = by_links ? inertia_from(moving_entity, link) : inertia_of_all(moving_entity);
  const bool turns = is_positive_definite(part.inertia);
  parts_.push_back(
      {number, link, 1, part.mass, moving_entity.r[0] + part.center, turns ? inverse(part.inertia) : SymMat3d{}});
  return static_cast<Number>(parts_.size()) - 1;
}

double EffectiveMass::along(Number number, const Vec3d& point, const Vec3d& direction) const noexcept {
  if (number == none) return 0;
  MUROSIMF_ASSERT(static_cast<std::size_t>(number) < parts_.size());
  const Part& part = parts_[number];
  const Vec3d moment = cross(point - part.center, direction);
  return part.contacts * (1 / part.mass + dot(moment, part.inverse_inertia * moment));
}

double EffectiveMass::about(Number number, const Vec3d& direction) const noexcept {
  if (number == none) return 0;
  MUROSIMF_ASSERT(static_cast<std::size_t>(number) < parts_.size());
  const Part& part = parts_[number];
  return part.contacts * dot(direction, part.inverse_inertia * direction);
}

}  // namespace murosimf::collision
