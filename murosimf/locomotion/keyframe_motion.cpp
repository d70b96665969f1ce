#include "murosimf/locomotion/keyframe_motion.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"

namespace murosimf::locomotion {

double duration(const KeyframeMotion& motion) noexcept {
  double sum = 0;
  for (const KeyFrame& frame : motion.frames) sum += frame.duration;
  return sum;
}

void sample(const KeyframeMotion& motion, double time, std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() == motion.start.size());
  std::copy(motion.start.begin(), motion.start.end(), values.begin());
  const std::vector<double>* from = &motion.start;
  for (const KeyFrame& frame : motion.frames) {
    MUROSIMF_ASSERT(frame.duration > 0 && frame.values.size() == values.size());
    const double s = std::clamp(time / frame.duration, 0.0, 1.0);
    const double share = 0.5 * (1 - std::cos(pi * s));
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = (*from)[i] + share * (frame.values[i] - (*from)[i]);
    }
    if (time < frame.duration) return;
    time -= frame.duration;
    from = &frame.values;
  }
}

}  // namespace murosimf::locomotion
