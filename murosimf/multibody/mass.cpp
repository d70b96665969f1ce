#include "murosimf/multibody/mass.h"

#include "murosimf/math/assert.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/span_sizes.h"

namespace murosimf::multibody {

template <class S>
CommonBody<S> common_body(const Tree& tree, std::span<const Vec3<S>> r, std::span<const Mat3<S>> R,
                          std::span<const Vec3<S>> v, std::span<const Vec3<S>> w) noexcept {
  MUROSIMF_ASSERT(one_row_per_object(tree, r, R, v, w));
  MUROSIMF_ASSERT(tree.mass > 0);
  // moments of mass about the base first: one pass, then moved to the common center; relative to the base, so that no digits
  // are lost far from the world's origin
  CommonBody<S> body;
  body.mass = tree.mass;
  const Vec3<S> origin = r[0];
  Vec3<S> first, momentum;
  SymMat3<S> second;
  for (const Link& link : tree.links) {
    if (link.mass == 0) continue;
    const int i = link.object;
    const Vec3<S> arm = R[i] * link.com;
    const Vec3<S> d = r[i] + arm - origin;
    first += link.mass * d;
    momentum += link.mass * (v[i] + cross(w[i], arm));
    second += rotated(R[i], link.inertia) + link.mass * inertia_of_point(d);
  }
  const double inverse = 1.0 / tree.mass;
  const Vec3<S> offset = inverse * first;
  body.center = origin + offset;
  body.velocity = inverse * momentum;
  body.inertia = second - tree.mass * inertia_of_point(offset);
  return body;
}

#define MUROSIMF_INSTANTIATE(S)                                                                          \
  template CommonBody<S> common_body<S>(const Tree&, std::span<const Vec3<S>>, std::span<const Mat3<S>>, \
                                        std::span<const Vec3<S>>, std::span<const Vec3<S>>) noexcept;
MUROSIMF_INSTANTIATE(double)
MUROSIMF_INSTANTIATE(Pack8)
#undef MUROSIMF_INSTANTIATE

}  // namespace murosimf::multibody
