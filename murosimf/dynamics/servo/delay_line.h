/// delay_line.h - a number that arrives a fixed number of steps after it has been sent.
#pragma once

#include <utility>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/model/property.h"
#include "murosimf/model/value.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::dynamics {

class DelayLine {
 public:
  /// Sets the delay to `steps`; `value` arrives until the first number that is sent arrives.
  void reset(std::size_t steps, double value) {
    values_.assign(steps, value);
    next_ = 0;
  }
  /// Sends `value`; returns what was sent `steps` calls ago.
  [[nodiscard]] double pass(double value) noexcept {
    if (values_.empty()) return value;
    MUROSIMF_ASSERT(next_ < values_.size());
    std::swap(values_[next_], value);
    if (++next_ == values_.size()) next_ = 0;
    return value;
  }
  void state(StateArchive& archive) {
    archive(values_);
    if (!values_.empty()) archive(next_);
  }
  friend void append_hash(Hasher& hasher, const DelayLine& line) {
    for (std::size_t i = 0; i < line.values_.size(); ++i) {
      hasher.add(line.values_[(line.next_ + i) % line.values_.size()]);
    }
  }

 private:
  std::vector<double> values_;
  std::size_t next_ = 0;
};

/// Targets under way from the controller to the motor.
inline constexpr Property<DelayLine> delayed_target{
    {"delayed_target", "rad | m", "joint", "targets on their way from the controller to the motor"}};

}  // namespace murosimf::dynamics
