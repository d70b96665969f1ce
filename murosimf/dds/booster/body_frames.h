/// body_frames.h - where parts of a Booster's body are, seen from each other, by its joints.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/dds/booster/messages.h"
#include "murosimf/math/transform.h"
#include "murosimf/model/model.h"

namespace murosimf::dds::booster {

/// Numbers of frames as in the vendor's enum Frame: body, head, left and right hand, left and right foot. Each is the link that its last joint moves.
class BodyFrames {
 public:
  static constexpr std::size_t count = 6;

  /// `objects` of the model, by joint in the robot's order.
  BodyFrames(const Model& model, std::span<const int> objects);

  /// Pose of `of` in the frame `in`, at these positions [rad] of the joints; nothing: there is no such frame.
  [[nodiscard]] std::optional<Transformd> pose(std::int64_t of, std::int64_t in,
                                               std::span<const MotorState> motors) const;

 private:
  const Model* model_;
  std::vector<int> objects_;
  std::array<int, count> links_{};  // objects
};

}  // namespace murosimf::dds::booster
