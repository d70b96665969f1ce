#include "murosimf/multibody/integrate.h"

#include "murosimf/math/assert.h"
#include "murosimf/math/pack.h"

namespace murosimf::multibody {

template <class S>
void advance(FreeBody<S>& body, const Twist<S>& acceleration, double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  // velocity first (semi-implicit Euler): the energy of oscillations stays bounded
  body.velocity += dt * acceleration.v;
  body.position += dt * body.velocity;
  body.rate += dt * acceleration.w;
  // the exponential map keeps the length up to rounding; normalizing removes the rounding
  body.turn = normalized(exponential(dt * body.rate) * body.turn);
}

template void advance<double>(FreeBody<double>&, const Twist<double>&, double) noexcept;
template void advance<Pack8>(FreeBody<Pack8>&, const Twist<Pack8>&, double) noexcept;

}  // namespace murosimf::multibody
