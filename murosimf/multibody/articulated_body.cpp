#include "murosimf/multibody/articulated_body.h"

#include <cassert>

#include "murosimf/math/pack.h"

namespace murosimf::multibody {

template <class S>
void start_sweep(std::span<const LinkMotion<S>> links, std::span<ArticulatedLink<S>> bodies) noexcept {
  assert(links.size() == bodies.size());
  for (std::size_t l = 0; l < links.size(); ++l) {
    bodies[l].inertia = to_sym6(links[l].inertia);
    bodies[l].force = links[l].bias_force;
  }
}

template <class S>
void sweep_to_base(const Tree& tree, std::span<const LinkMotion<S>> links,
                   std::span<ArticulatedLink<S>> bodies) noexcept {
  for (std::size_t l = links.size() - 1; l > 0; --l) {
    ArticulatedLink<S>& body = bodies[l];
    const Motion<S>& s = links[l].axis;
    body.U = body.inertia * s;
    body.inverse_D = 1.0 / (dot(s, body.U) + body.added_inertia);
    body.u = body.torque - dot(s, body.force);
    ArticulatedLink<S>& parent = bodies[tree.links[l].parent];
    subtract_outer(body.inertia, body.inverse_D, body.U);
    parent.inertia += body.inertia;
    parent.force += body.force + (body.u * body.inverse_D) * body.U;
  }
}

template <class S>
void accelerate(const Tree& tree, std::span<const LinkMotion<S>> links, std::span<ArticulatedLink<S>> bodies,
                const Motion<S>& base) noexcept {
  bodies[0].acceleration = base;
  for (std::size_t l = 1; l < links.size(); ++l) {
    ArticulatedLink<S>& body = bodies[l];
    const Motion<S>& a = bodies[tree.links[l].parent].acceleration;
    body.joint_acceleration = (body.u - dot(a, body.U)) * body.inverse_D;
    body.acceleration = a + body.joint_acceleration * links[l].axis;
  }
}

#define MUROSIMF_INSTANTIATE(S)                                                                                        \
  template void start_sweep<S>(std::span<const LinkMotion<S>>, std::span<ArticulatedLink<S>>) noexcept;                \
  template void sweep_to_base<S>(const Tree&, std::span<const LinkMotion<S>>, std::span<ArticulatedLink<S>>) noexcept; \
  template void accelerate<S>(const Tree&, std::span<const LinkMotion<S>>, std::span<ArticulatedLink<S>>,              \
                              const Motion<S>&) noexcept;
MUROSIMF_INSTANTIATE(double)
MUROSIMF_INSTANTIATE(Pack8)
#undef MUROSIMF_INSTANTIATE

}  // namespace murosimf::multibody
