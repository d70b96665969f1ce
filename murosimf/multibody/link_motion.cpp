#include "murosimf/multibody/link_motion.h"

#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/joint_axis.h"
#include "murosimf/multibody/span_sizes.h"

namespace murosimf::multibody {
namespace {

/// R m R^T; a diagonal m, as of primitive shapes, costs half.
template <class S>
MUROSIMF_INLINE SymMat3<S> seen_in_world(const Mat3<S>& R, const Link& link) {
  const SymMat3d& m = link.inertia;
  if (!link.diagonal_inertia) return rotated(R, m);
  const Vec3<S> a = m.xx * R.x, b = m.yy * R.y, c = m.zz * R.z;
  return {a.x * R.x.x + b.x * R.y.x + c.x * R.z.x, a.y * R.x.y + b.y * R.y.y + c.y * R.z.y,
          a.z * R.x.z + b.z * R.y.z + c.z * R.z.z, a.x * R.x.y + b.x * R.y.y + c.x * R.z.y,
          a.x * R.x.z + b.x * R.y.z + c.x * R.z.z, a.y * R.x.z + b.y * R.y.z + c.y * R.z.z};
}

/// Writes member by member: a whole vector would be copied in pieces of another size than it was computed in, which defeats
/// store forwarding.
template <class S>
MUROSIMF_INLINE void store(const Vec3<S>& from, Vec3<S>& to) {
  to.x = from.x;
  to.y = from.y;
  to.z = from.z;
}

/// Sets a link's inertia and bias force p; d [m] from O to its origin, R its orientation.
template <class S>
MUROSIMF_INLINE void add_mass(const Link& link, const Vec3<S>& d, const Mat3<S>& R, LinkMotion<S>& to) {
  MUROSIMF_ASSERT(link.mass >= 0);
  if (link.mass == 0) {
    to.inertia = {};
    to.bias_force = {};
    return;
  }
  const double m = link.mass;
  const Vec3<S> c = d + R * link.com;
  const SymMat3<S> Ic = seen_in_world(R, link);
  const Vec3<S> w = to.velocity.w, bw = to.bias.w;
  // of the center of mass: its velocity and its acceleration
  const Vec3<S> vc = to.velocity.v + cross(w, c);
  const Vec3<S> f = m * (to.bias.v + cross(bw, c) + cross(w, vc));
  to.bias_force.n = cross(c, f) + Ic * bw + cross(w, Ic * w);
  store(f, to.bias_force.f);

  const Vec3<S> h = m * c;
  const S xx = h.x * c.x, yy = h.y * c.y, zz = h.z * c.z;
  to.inertia.mass = m;
  store(h, to.inertia.first);
  to.inertia.second.xx = Ic.xx + (yy + zz);
  to.inertia.second.yy = Ic.yy + (xx + zz);
  to.inertia.second.zz = Ic.zz + (xx + yy);
  to.inertia.second.xy = Ic.xy - h.x * c.y;
  to.inertia.second.xz = Ic.xz - h.x * c.z;
  to.inertia.second.yz = Ic.yz - h.y * c.z;
}

}  // namespace

template <class S>
void link_motions(const Tree& tree, std::span<const Vec3<S>> r, std::span<const Mat3<S>> R, const Vec3<S>& w,
                  std::span<const S> qd, std::span<LinkMotion<S>> links) noexcept {
  MUROSIMF_ASSERT(one_row_per_link(tree, links) && one_row_per_object(tree, r, R, qd));
  MUROSIMF_ASSERT(!links.empty());
  links[0].axis = links[0].bias = {};
  links[0].velocity = {w, {}};
  add_mass(tree.links[0], Vec3<S>{}, R[0], links[0]);
  for (std::size_t l = 1; l < links.size(); ++l) {
    const Link& link = tree.links[l];
    MUROSIMF_ASSERT(link.parent >= 0 && static_cast<std::size_t>(link.parent) < l && link.kind != LinkKind::base);
    const LinkMotion<S>& parent = links[link.parent];
    LinkMotion<S>& to = links[l];
    const Vec3<S> d = r[link.object] - r[0];  // relative to the base: no digits are lost far from the world's origin
    const Vec3<S> a = joint_axis(R[link.object], link);
    const Vec3<S> rate = qd[link.object] * a;
    const Vec3<S> turn = parent.velocity.w;
    if (link.kind == LinkKind::revolute) {
      to.axis.w = a;
      to.axis.v = cross(d, a);
      const Vec3<S> v = cross(d, rate);
      to.velocity.w = turn + rate;
      to.velocity.v = parent.velocity.v + v;
      to.bias.w = parent.bias.w + cross(turn, rate);
      to.bias.v = parent.bias.v + cross(turn, v) + cross(parent.velocity.v, rate);
    } else {
      to.axis.w = {};
      to.axis.v = a;
      to.velocity.w = turn;
      to.velocity.v = parent.velocity.v + rate;
      to.bias.w = parent.bias.w;
      to.bias.v = parent.bias.v + cross(turn, rate);
    }
    add_mass(link, d, R[link.object], to);
  }
}

template <class S>
RigidInertia<S> composite_inertia(std::span<const LinkMotion<S>> links) noexcept {
  RigidInertia<S> sum;
  for (const auto& link : links) sum += link.inertia;
  return sum;
}

void moved_inertias(const Tree& tree, std::span<const LinkMotion<double>> links, std::span<double> moved) {
  MUROSIMF_ASSERT(one_row_per_link(tree, links, moved) && !links.empty());
  std::vector<RigidInertia<double>> composite;
  for (const auto& link : links) composite.push_back(link.inertia);
  for (std::size_t l = links.size() - 1; l > 0; --l) {
    moved[l] = dot(links[l].axis, composite[l] * links[l].axis);
    composite[tree.links[l].parent] += composite[l];
  }
}

template <class S>
Wrench<S> momentum(std::span<const LinkMotion<S>> links) noexcept {
  Wrench<S> sum;
  for (const auto& link : links) sum += link.inertia * link.velocity;
  return sum;
}

template <class S>
Vec3<S> linear_momentum(std::span<const LinkMotion<S>> links) noexcept {
  Vec3<S> sum;
  for (const auto& link : links)
    sum += link.inertia.mass * link.velocity.v - cross(link.inertia.first, link.velocity.w);
  return sum;
}

template <class S>
S kinetic_energy(std::span<const LinkMotion<S>> links, const Vec3<S>& v0) noexcept {
  S twice{};
  for (const auto& link : links) {
    const Twist<S> v{link.velocity.w, link.velocity.v + v0};
    twice = twice + dot(v, link.inertia * v);
  }
  return 0.5 * twice;
}

template <class S>
S potential_energy(std::span<const LinkMotion<S>> links, const Vec3<S>& r0, const Vec3d& gravity) noexcept {
  const RigidInertia<S> all = composite_inertia(links);
  return -(dot(all.first + all.mass * r0, gravity));
}

#define MUROSIMF_INSTANTIATE(S)                                                                                  \
  template void link_motions<S>(const Tree&, std::span<const Vec3<S>>, std::span<const Mat3<S>>, const Vec3<S>&, \
                                std::span<const S>, std::span<LinkMotion<S>>) noexcept;                          \
  template RigidInertia<S> composite_inertia<S>(std::span<const LinkMotion<S>>) noexcept;                        \
  template Wrench<S> momentum<S>(std::span<const LinkMotion<S>>) noexcept;                                       \
  template Vec3<S> linear_momentum<S>(std::span<const LinkMotion<S>>) noexcept;                                  \
  template S kinetic_energy<S>(std::span<const LinkMotion<S>>, const Vec3<S>&) noexcept;                         \
  template S potential_energy<S>(std::span<const LinkMotion<S>>, const Vec3<S>&, const Vec3d&) noexcept;
MUROSIMF_INSTANTIATE(double)
MUROSIMF_INSTANTIATE(Pack8)
#undef MUROSIMF_INSTANTIATE

}  // namespace murosimf::multibody
