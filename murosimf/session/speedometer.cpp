#include "murosimf/session/speedometer.h"

#include "murosimf/math/assert.h"

namespace murosimf::session {
namespace {

constexpr std::chrono::milliseconds window(500);

}  // namespace

void Speedometer::restart(Duration simulated, WallClock::time_point wall) {
  old_ = newer_ = {simulated, wall};
  factor_ = 0;
}

void Speedometer::advance(Duration simulated, WallClock::time_point wall) {
  MUROSIMF_ASSERT(wall >= old_.wall);
  // Two marks half a second apart: the mean covers between half a second and a second.
  if (wall - newer_.wall >= window) {
    old_ = newer_;
    newer_ = {simulated, wall};
  }
  const double passed = std::chrono::duration<double>(wall - old_.wall).count();
  if (passed > 0) factor_ = seconds(simulated - old_.simulated) / passed;
}

}  // namespace murosimf::session
