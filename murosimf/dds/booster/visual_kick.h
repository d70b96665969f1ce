/// visual_kick.h - a Booster's kick at the ball that its programs see: between VisualKick(true) and VisualKick(false) each message of `rt/kick_ball`
/// says where the ball lies and where it shall go.
#pragma once

#include <cstdint>
#include <optional>

#include "murosimf/dds/booster/messages.h"

namespace murosimf::dds::booster {

class VisualKick {
 public:
  /// Cycles after which a message is too old for a kick that begins, and between two requests to the motion engine: both our own rules.
  static constexpr std::uint64_t longest_age = 500, request_interval = 250;

  /// A message has come in this cycle.
  void see(const KickTarget& target, std::uint64_t cycle) {
    target_ = target;
    seen_ = cycle + 1;
    fresh_ = true;
  }
  /// Kicks from now on. False: there is no message of the last second, so nothing says where the ball is.
  [[nodiscard]] bool start(std::uint64_t cycle) {
    active_ = true;
    asked_ = 0;
    fresh_ = seen_ > 0 && cycle + 1 - seen_ <= longest_age;
    return fresh_;
  }
  void stop() { active_ = false; }
  /// What is to be asked of the motion engine in this cycle.
  [[nodiscard]] std::optional<KickTarget> request(std::uint64_t cycle) {
    if (!active_ || !fresh_ || (asked_ > 0 && cycle + 1 - asked_ < request_interval)) return std::nullopt;
    asked_ = cycle + 1;
    fresh_ = false;
    return target_;
  }

  template <class Archive>
  void state(Archive& archive) {
    archive(target_, seen_, asked_, active_, fresh_);
  }

 private:
  KickTarget target_;
  std::uint64_t seen_ = 0, asked_ = 0;  // one more than the cycle; 0: never
  bool active_ = false, fresh_ = false;
};

}  // namespace murosimf::dds::booster
