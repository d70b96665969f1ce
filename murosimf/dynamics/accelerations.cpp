#include "murosimf/dynamics/accelerations.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::dynamics {
namespace {

template <class T>
void difference(std::span<const T> now, double dt, std::vector<T>& last, std::span<T> rate) noexcept {
  MUROSIMF_ASSERT(last.size() == now.size() && rate.size() == now.size() && dt > 0);
  for (std::size_t i = 0; i < now.size(); ++i) {
    // all rows, for a simple loop: those of structural objects are unused
    rate[i] = (1 / dt) * (now[i] - last[i]);
    last[i] = now[i];
  }
}

template <class T>
void start_from(std::span<const T> now, std::vector<T>& last, std::span<T> rate) {
  last.assign(now.begin(), now.end());
  std::fill(rate.begin(), rate.end(), T{});
}

}  // namespace

Accelerations::Accelerations(Setup& setup)
    : v_(setup.read(properties::linear_velocity)),
      w_(setup.read(properties::angular_velocity)),
      qd_(setup.read(properties::joint_velocity)),
      a_(setup.write(properties::linear_acceleration)),
      alpha_(setup.write(properties::angular_acceleration)),
      qdd_(setup.write(properties::joint_acceleration)) {}

void Accelerations::initialize() {
  start_from(v_, last_v_, a_);
  start_from(w_, last_w_, alpha_);
  start_from(qd_, last_qd_, qdd_);
}

void Accelerations::state(StateArchive& archive) {
  archive.elements(std::span(last_v_));
  archive.elements(std::span(last_w_));
  archive.elements(std::span(last_qd_));
}

void Accelerations::step(const Instant& instant) noexcept {
  const double dt = seconds(instant.period);
  difference(v_, dt, last_v_, a_);
  difference(w_, dt, last_w_, alpha_);
  difference(qd_, dt, last_qd_, qdd_);
}

}  // namespace murosimf::dynamics
