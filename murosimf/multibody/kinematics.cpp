#include "murosimf/multibody/kinematics.h"

#include "murosimf/math/assert.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/joint_axis.h"
#include "murosimf/multibody/span_sizes.h"

namespace murosimf::multibody {
namespace {

/// R rot(axis, q). About a coordinate axis two columns turn in their plane and the third is unchanged.
template <class S>
MUROSIMF_INLINE Mat3<S> turned(const Mat3<S>& R, const Link& link, S q) {
  const SinCos<S> a = sin_cos(q);
  const auto& [s, c] = a;
  switch (link.axis_kind) {
    case AxisKind::x: return {R.x, c * R.y + s * R.z, c * R.z - s * R.y};
    case AxisKind::y: return {c * R.x - s * R.z, R.y, c * R.z + s * R.x};
    case AxisKind::z: return {c * R.x + s * R.y, c * R.y - s * R.x, R.z};
    case AxisKind::general: break;
  }
  return R * rotation(link.axis, a);
}

/// Pose (r, R) of a joint's frame from its parent link's pose.
template <class S>
MUROSIMF_INLINE void place_joint(const Link& link, const S& q, const Vec3<S>& r_parent, const Mat3<S>& R_parent,
                                 Vec3<S>& r, Mat3<S>& R) {
  MUROSIMF_ASSERT(link.kind != LinkKind::base);
  const Mat3<S> at_zero = link.turned ? R_parent * link.turn : R_parent;
  r = r_parent + R_parent * link.offset;
  if (link.kind == LinkKind::revolute) {
    R = turned(at_zero, link, q);
  } else {
    R = at_zero;
    r += q * joint_axis(at_zero, link);
  }
}

/// Pose (r, R) of an object that is fixed to a link, from the link's pose.
template <class S>
MUROSIMF_INLINE void place_fixed(const FixedObject& fixed, const Vec3<S>& r_link, const Mat3<S>& R_link, Vec3<S>& r,
                                 Mat3<S>& R) {
  r = r_link + R_link * fixed.offset;
  R = fixed.turned ? R_link * fixed.turn : R_link;
}

}  // namespace

template <class S>
void poses(const Tree& tree, std::span<const S> q, std::span<Vec3<S>> r, std::span<Mat3<S>> R) noexcept {
  MUROSIMF_ASSERT(one_row_per_object(tree, q, r, R));
  MUROSIMF_ASSERT(!tree.links.empty() && tree.links[0].object == 0);
  // parents come first, so one pass in the order of the links is enough
  for (std::size_t l = 1; l < tree.links.size(); ++l) {
    const Link& link = tree.links[l];
    MUROSIMF_ASSERT(link.parent >= 0 && static_cast<std::size_t>(link.parent) < l);
    const int p = tree.links[link.parent].object;
    place_joint(link, q[link.object], r[p], R[p], r[link.object], R[link.object]);
  }
  for (const FixedObject& fixed : tree.followers) {
    MUROSIMF_ASSERT(fixed.link >= 0 && static_cast<std::size_t>(fixed.link) < tree.links.size());
    const int p = tree.links[fixed.link].object;
    place_fixed(fixed, r[p], R[p], r[fixed.object], R[fixed.object]);
  }
}

template <class S>
Transform<S> pose_in_base(const Tree& tree, std::span<const int> path, const FixedObject& object,
                          std::span<const S> q) noexcept {
  MUROSIMF_ASSERT(one_row_per_object(tree, q));
  Transform<S> link_pose;
  for (const int l : path) {
    MUROSIMF_ASSERT(l > 0 && static_cast<std::size_t>(l) < tree.links.size());
    Transform<S> next;
    place_joint(tree.links[l], q[tree.links[l].object], link_pose.position, link_pose.orientation, next.position,
                next.orientation);
    link_pose = next;
  }
  Transform<S> result;
  place_fixed(object, link_pose.position, link_pose.orientation, result.position, result.orientation);
  return result;
}

template <class S>
Twist<S> twist_against_base(const Tree& tree, std::span<const int> path, const Vec3<S>& at, std::span<const S> qd,
                            std::span<const Vec3<S>> r, std::span<const Mat3<S>> R) noexcept {
  MUROSIMF_ASSERT(one_row_per_object(tree, qd, r, R));
  Twist<S> twist;
  for (const int l : path) {
    MUROSIMF_ASSERT(l > 0 && static_cast<std::size_t>(l) < tree.links.size());
    const Link& link = tree.links[l];
    const Vec3<S> joint = qd[link.object] * joint_axis(R[link.object], link);
    if (link.kind == LinkKind::revolute) {
      twist.w += joint;
      twist.v += cross(joint, at - r[link.object]);
    } else {
      twist.v += joint;
    }
  }
  return twist;
}

template <class S>
void velocities(const Tree& tree, std::span<const S> qd, std::span<const Vec3<S>> r, std::span<const Mat3<S>> R,
                std::span<Vec3<S>> v, std::span<Vec3<S>> w) noexcept {
  MUROSIMF_ASSERT(one_row_per_object(tree, qd, r, R, v, w));
  for (std::size_t l = 1; l < tree.links.size(); ++l) {
    const Link& link = tree.links[l];
    const int i = link.object;
    MUROSIMF_ASSERT(link.parent >= 0 && static_cast<std::size_t>(link.parent) < l);
    const int p = tree.links[link.parent].object;
    const Vec3<S> joint = qd[i] * joint_axis(R[i], link);
    Vec3<S> turning = w[p];  // in registers: a copy in memory would wait for the preceding store
    Vec3<S> moving = v[p] + cross(turning, r[i] - r[p]);
    (link.kind == LinkKind::revolute ? turning : moving) += joint;
    w[i] = turning;
    v[i] = moving;
  }
  for (const FixedObject& fixed : tree.followers) {
    MUROSIMF_ASSERT(fixed.link >= 0 && static_cast<std::size_t>(fixed.link) < tree.links.size());
    const int p = tree.links[fixed.link].object;
    w[fixed.object] = w[p];
    v[fixed.object] = v[p] + cross(w[p], r[fixed.object] - r[p]);
  }
}

template <class S>
void shift_all(std::span<Vec3<S>> rows, const Vec3<S>& shift) noexcept {
  for (Vec3<S>& row : rows) row += shift;
}

#define MUROSIMF_INSTANTIATE(S)                                                                                    \
  template void poses<S>(const Tree&, std::span<const S>, std::span<Vec3<S>>, std::span<Mat3<S>>) noexcept;        \
  template void velocities<S>(const Tree&, std::span<const S>, std::span<const Vec3<S>>, std::span<const Mat3<S>>, \
                              std::span<Vec3<S>>, std::span<Vec3<S>>) noexcept;                                    \
  template Transform<S> pose_in_base<S>(const Tree&, std::span<const int>, const FixedObject&,                     \
                                        std::span<const S>) noexcept;                                              \
  template Twist<S> twist_against_base<S>(const Tree&, std::span<const int>, const Vec3<S>&, std::span<const S>,   \
                                          std::span<const Vec3<S>>, std::span<const Mat3<S>>) noexcept;            \
  template void shift_all<S>(std::span<Vec3<S>>, const Vec3<S>&) noexcept;
MUROSIMF_INSTANTIATE(double)
MUROSIMF_INSTANTIATE(Pack8)
#undef MUROSIMF_INSTANTIATE

}  // namespace murosimf::multibody
