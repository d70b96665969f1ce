/// delay_line.h - a number that arrives a fixed number of steps after it was sent.
#pragma once

#include <utility>
#include <vector>

#include "murosimf/model/property.h"
#include "murosimf/model/state_archive.h"
#include "murosimf/model/value.h"

namespace murosimf::motion {

class DelayLine {
 public:
  /// From now on everything arrives `steps` later; until then `value` does.
  void reset(std::size_t steps, double value) {
    values_.assign(steps, value);
    next_ = 0;
  }
  /// Sends `value`; what arrives in return was sent `steps` calls ago.
  [[nodiscard]] double pass(double value) noexcept {
    if (values_.empty()) return value;
    std::swap(values_[next_], value);
    if (++next_ == values_.size()) next_ = 0;
    return value;
  }
  void state(StateArchive& archive) { archive(values_, next_); }
  friend void append_hash(Hasher& hasher, const DelayLine& line) {
    for (std::size_t i = 0; i < line.values_.size(); ++i) {
      hasher.add(line.values_[(line.next_ + i) % line.values_.size()]);
    }
  }

 private:
  std::vector<double> values_;
  std::size_t next_ = 0;
};

/// Targets on their way from the controller to the motor.
inline constexpr Property<DelayLine> delayed_target{
    {"delayed_target", "rad | m", "joint", "targets on their way from the controller to the motor"}};

}  // namespace murosimf::motion
