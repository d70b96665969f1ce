/// head_motion.h - the way of a Booster's head to where a request wants it.
#pragma once

#include <algorithm>
#include <array>

namespace murosimf::dds::booster {

/// Yaw and pitch [rad].
using HeadAngles = std::array<double, 2>;

class HeadMotion {
 public:
  /// In a straight line within `duration` [s]; 0: as fast as its joints go.
  void go(const HeadAngles& from, const HeadAngles& to, double duration) {
    from_ = from;
    to_ = to;
    duration_ = duration;
    time_ = 0;
    asked_ = true;
  }
  void stop() { asked_ = false; }
  void advance(double dt) { time_ += dt; }
  /// Whether a request says where the head is; without one it is where walks and motions have it.
  [[nodiscard]] bool is_asked() const { return asked_; }
  [[nodiscard]] HeadAngles angles() const {
    const double share = duration_ > 0 ? std::clamp(time_ / duration_, 0.0, 1.0) : 1;
    return {from_[0] + share * (to_[0] - from_[0]), from_[1] + share * (to_[1] - from_[1])};
  }

  template <class Archive>
  void state(Archive& archive) {
    archive(from_, to_, duration_, time_, asked_);
  }

 private:
  HeadAngles from_{}, to_{};
  double duration_ = 0, time_ = 0;  // [s]
  bool asked_ = false;
};

}  // namespace murosimf::dds::booster
