#include "murosimf/multibody/link_motion.h"

#include <cassert>

#include "murosimf/math/pack.h"
#include "murosimf/multibody/joint_axis.h"

namespace murosimf::multibody {
namespace {

/// The inertia of a link and the force p; d [m] from O to its origin, R its orientation.
template <class S>
[[gnu::always_inline]] inline void add_mass(const Link& link, const Vec3<S>& d, const Mat3<S>& R, LinkMotion<S>& to) {
  if (link.mass == 0) {
    to.inertia = {};
    to.bias_force = {};
    return;
  }
  const Vec3<S> c = d + R * link.com;
  const SymMat3<S> Ic = rotated(R, link.inertia);
  to.inertia = {link.mass, link.mass * c, Ic + link.mass * inertia_of_point(c)};
  // of the center of mass: its velocity and its acceleration
  const auto& [w, v] = to.velocity;
  const auto& [bw, bv] = to.bias;
  const Vec3<S> vc = v + cross(w, c);
  const Vec3<S> f = link.mass * (bv + cross(bw, c) + cross(w, vc));
  to.bias_force = {cross(c, f) + Ic * bw + cross(w, Ic * w), f};
}

}  // namespace

template <class S>
void link_motions(const Tree& tree, std::span<const Vec3<S>> r, std::span<const Mat3<S>> R, const Vec3<S>& w,
                  std::span<const S> qd, std::span<LinkMotion<S>> links) noexcept {
  assert(links.size() == tree.links.size());
  links[0].axis = links[0].bias = {};
  links[0].velocity = {w, {}};
  add_mass(tree.links[0], Vec3<S>{}, R[0], links[0]);
  for (std::size_t l = 1; l < links.size(); ++l) {
    const Link& link = tree.links[l];
    const LinkMotion<S>& parent = links[link.parent];
    LinkMotion<S>& to = links[l];
    const Vec3<S> d = r[link.object] - r[0];
    const Vec3<S> a = joint_axis(R[link.object], link);
    if (link.kind == LinkKind::revolute) {
      to.axis = {a, cross(d, a)};
    } else {
      to.axis = {{}, a};
    }
    const Motion<S> joint = qd[link.object] * to.axis;
    to.velocity = parent.velocity + joint;
    to.bias = parent.bias + cross(parent.velocity, joint);
    add_mass(link, d, R[link.object], to);
  }
}

template <class S>
RigidInertia<S> composite_inertia(std::span<const LinkMotion<S>> links) noexcept {
  RigidInertia<S> sum;
  for (const auto& link : links) sum += link.inertia;
  return sum;
}

template <class S>
Force<S> momentum(std::span<const LinkMotion<S>> links) noexcept {
  Force<S> sum;
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
    const Motion<S> v{link.velocity.w, link.velocity.v + v0};
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
  template Force<S> momentum<S>(std::span<const LinkMotion<S>>) noexcept;                                        \
  template Vec3<S> linear_momentum<S>(std::span<const LinkMotion<S>>) noexcept;                                  \
  template S kinetic_energy<S>(std::span<const LinkMotion<S>>, const Vec3<S>&) noexcept;                         \
  template S potential_energy<S>(std::span<const LinkMotion<S>>, const Vec3<S>&, const Vec3d&) noexcept;
MUROSIMF_INSTANTIATE(double)
MUROSIMF_INSTANTIATE(Pack8)
#undef MUROSIMF_INSTANTIATE

}  // namespace murosimf::multibody
