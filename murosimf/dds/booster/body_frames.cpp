#include "murosimf/dds/booster/body_frames.h"

#include "murosimf/math/assert.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::dds::booster {

/// Legs are the last twelve joints of K1 and T1, arms begin behind the head.
BodyFrames::BodyFrames(const Model& model, std::span<const int> objects)
    : model_(&model), objects_(objects.begin(), objects.end()) {
  constexpr std::size_t head = 1, left_hand = 5, right_hand = 9, of_leg = 6;
  MUROSIMF_ASSERT(objects.size() >= right_hand + 2 * of_leg);
  links_ = {0,
            objects[head],
            objects[left_hand],
            objects[right_hand],
            objects[objects.size() - of_leg - 1],
            objects[objects.size() - 1]};
}

std::optional<Transformd> BodyFrames::pose(std::int64_t of, std::int64_t in, std::span<const MotorState> motors) const {
  const auto known = [](std::int64_t frame) { return frame >= 0 && frame < static_cast<std::int64_t>(count); };
  if (!known(of) || !known(in)) return std::nullopt;
  const auto size = static_cast<std::size_t>(model_->size());
  std::vector<double> q(size);
  std::vector<Vec3d> r(size);
  std::vector<Mat3d> R(size);
  for (std::size_t i = 0; i < objects_.size(); ++i) q[objects_[i]] = motors[i].q;
  multibody::poses<double>(model_->tree(), q, r, R);
  const int to = links_[static_cast<std::size_t>(of)], from = links_[static_cast<std::size_t>(in)];
  const Mat3d turned_back = transpose(R[from]);
  return Transformd{turned_back * (r[to] - r[from]), turned_back * R[to]};
}

}  // namespace murosimf::dds::booster
