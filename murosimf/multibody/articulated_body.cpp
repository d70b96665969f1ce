#include "murosimf/multibody/articulated_body.h"

#include "murosimf/math/assert.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/articulated_parts.h"
#include "murosimf/multibody/span_sizes.h"

namespace murosimf::multibody {

template <class S>
void clear_loads(std::span<ArticulatedLink<S>> bodies) noexcept {
  // only the flags: add_link and hand_over overwrite the numbers of a body that is not loaded
  for (auto& body : bodies) body.loaded = false;
}

template <class S>
void add_load(ArticulatedLink<S>& body, const Wrench<S>& force, const Sym6<S>& damping) noexcept {
  if (!body.loaded) {
    body.inertia = {};
    body.force = {};
    body.loaded = true;
  }
  body.inertia += damping;
  body.force -= force;
}

template <class S>
void sweep_to_base(const Tree& tree, std::span<const LinkMotion<S>> links,
                   std::span<ArticulatedLink<S>> bodies) noexcept {
  MUROSIMF_ASSERT(one_row_per_link(tree, links, bodies));
  MUROSIMF_ASSERT(!links.empty());
  // children have larger numbers than their parents: going down, each body is complete when its turn comes
  for (std::size_t l = links.size() - 1; l > 0; --l) {
    MUROSIMF_ASSERT(tree.links[l].parent >= 0 && static_cast<std::size_t>(tree.links[l].parent) < l);
    ArticulatedLink<S>& body = bodies[l];
    const Twist<S>& s = links[l].axis;
    parts::add_link(links[l], body);
    body.U = body.inertia * s;
    body.inverse_D = 1.0 / (dot(s, body.U) + body.added_inertia);
    body.u = body.torque - dot(s, body.force);
    const S share = body.u * body.inverse_D;
    parts::hand_over(body, share, bodies[tree.links[l].parent]);
  }
  parts::add_link(links[0], bodies[0]);
}

template <class S>
void accelerate(const Tree& tree, std::span<const LinkMotion<S>> links, std::span<ArticulatedLink<S>> bodies,
                const Twist<S>& base) noexcept {
  MUROSIMF_ASSERT(one_row_per_link(tree, links, bodies));
  MUROSIMF_ASSERT(!bodies.empty());
  bodies[0].acceleration = base;
  for (std::size_t l = 1; l < links.size(); ++l) {
    ArticulatedLink<S>& body = bodies[l];
    const Twist<S>& a = bodies[tree.links[l].parent].acceleration;
    body.joint_acceleration = (body.u - dot(a, body.U)) * body.inverse_D;
    body.acceleration = a + body.joint_acceleration * links[l].axis;
  }
}

#define MUROSIMF_INSTANTIATE(S)                                                                                        \
  template void clear_loads<S>(std::span<ArticulatedLink<S>>) noexcept;                                                \
  template void add_load<S>(ArticulatedLink<S>&, const Wrench<S>&, const Sym6<S>&) noexcept;                           \
  template void sweep_to_base<S>(const Tree&, std::span<const LinkMotion<S>>, std::span<ArticulatedLink<S>>) noexcept; \
  template void accelerate<S>(const Tree&, std::span<const LinkMotion<S>>, std::span<ArticulatedLink<S>>,              \
                              const Twist<S>&) noexcept;
MUROSIMF_INSTANTIATE(double)
MUROSIMF_INSTANTIATE(Pack8)
#undef MUROSIMF_INSTANTIATE

}  // namespace murosimf::multibody
