#include "murosimf/multibody/inverse_dynamics.h"

#include <algorithm>
#include <array>

#include "murosimf/math/assert.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/span_sizes.h"

namespace murosimf::multibody {

template <class S>
void inverse_dynamics(const Tree& tree, std::span<const LinkMotion<S>> links, const Twist<S>& base,
                      std::span<const S> qdd, std::span<const Wrench<S>> external, std::span<Wrench<S>> force,
                      std::span<S> torque) noexcept {
  // a'_i = a'_0 + sum of s qdd on the path; `force` holds these motions first, which saves an array of working memory
  MUROSIMF_ASSERT(one_row_per_link(tree, links, qdd, external, force, torque));
  MUROSIMF_ASSERT(!links.empty());
  const auto count = links.size();
  for (std::size_t l = 0; l < count; ++l) {
    const Link& link = tree.links[l];
    Twist<S> a = base;
    if (l > 0) {
      MUROSIMF_ASSERT(link.parent >= 0 && static_cast<std::size_t>(link.parent) < l);
      const Wrench<S>& parent = force[link.parent];
      a = Twist<S>{parent.n, parent.f} + qdd[l] * links[l].axis;
    }
    force[l] = {a.w, a.v};
  }
  for (std::size_t l = 0; l < count; ++l) {
    const Twist<S> a{force[l].n, force[l].f};
    force[l] = links[l].inertia * a + links[l].bias_force - external[l];
  }
  for (std::size_t l = count - 1; l > 0; --l) {
    torque[l] = dot(links[l].axis, force[l]);
    force[tree.links[l].parent] += force[l];
  }
  torque[0] = {};
}

template <class S>
Wrench<S> base_bias(const Tree& tree, std::span<const LinkMotion<S>> links, std::span<const S> qdd,
                    std::span<Twist<S>> working) noexcept {
  MUROSIMF_ASSERT(one_row_per_link(tree, links, qdd, working));
  MUROSIMF_ASSERT(!links.empty());
  working[0] = {};
  Wrench<S> sum = links[0].bias_force;
  for (std::size_t l = 1; l < links.size(); ++l) {
    MUROSIMF_ASSERT(tree.links[l].parent >= 0 && static_cast<std::size_t>(tree.links[l].parent) < l);
    working[l] = working[tree.links[l].parent] + qdd[l] * links[l].axis;
    sum += links[l].inertia * working[l] + links[l].bias_force;
  }
  return sum;
}

namespace {

std::array<double, 6> numbers(const Wrench<double>& force) {
  return {force.n.x, force.n.y, force.n.z, force.f.x, force.f.y, force.f.z};
}

}  // namespace

void mass_matrix(const Tree& tree, std::span<const LinkMotion<double>> links, std::span<RigidInertia<double>> composite,
                 std::span<double> M) noexcept {
  const std::size_t size = 6 + links.size() - 1;
  MUROSIMF_ASSERT(!links.empty());
  MUROSIMF_ASSERT(M.size() == size * size && one_row_per_link(tree, links, composite));
  // rows and columns of joints on different branches stay zero
  std::fill(M.begin(), M.end(), 0.0);
  const auto set = [&](std::size_t row, std::size_t column, double value) {
    M[row * size + column] = M[column * size + row] = value;
  };
  for (std::size_t l = 0; l < links.size(); ++l) composite[l] = links[l].inertia;
  for (std::size_t l = links.size() - 1; l > 0; --l) {
    MUROSIMF_ASSERT(tree.links[l].parent >= 0 && static_cast<std::size_t>(tree.links[l].parent) < l);
    const Wrench<double> F = composite[l] * links[l].axis;
    for (std::size_t j = l; j != 0; j = static_cast<std::size_t>(tree.links[j].parent)) {
      set(5 + l, 5 + j, dot(links[j].axis, F));
    }
    const auto rows = numbers(F);
    for (std::size_t k = 0; k < 6; ++k) set(5 + l, k, rows[k]);
    composite[tree.links[l].parent] += composite[l];
  }
  for (std::size_t k = 0; k < 6; ++k) {
    // the base's block, column by column, as the momentum of unit velocities
    std::array<double, 6> unit{};
    unit[k] = 1;
    const Twist<double> m{{unit[0], unit[1], unit[2]}, {unit[3], unit[4], unit[5]}};
    const auto column = numbers(composite[0] * m);
    for (std::size_t i = 0; i < 6; ++i) M[i * size + k] = column[i];
  }
}

#define MUROSIMF_INSTANTIATE(S)                                                                                       \
  template void inverse_dynamics<S>(const Tree&, std::span<const LinkMotion<S>>, const Twist<S>&, std::span<const S>, \
                                    std::span<const Wrench<S>>, std::span<Wrench<S>>, std::span<S>) noexcept;         \
  template Wrench<S> base_bias<S>(const Tree&, std::span<const LinkMotion<S>>, std::span<const S>,                    \
                                  std::span<Twist<S>>) noexcept;
MUROSIMF_INSTANTIATE(double)
MUROSIMF_INSTANTIATE(Pack8)
#undef MUROSIMF_INSTANTIATE

}  // namespace murosimf::multibody
