#include "murosimf/dynamics/pose_lanes.h"

#include "murosimf/math/assert.h"
#include "murosimf/math/spatial.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::dynamics {

PoseLanes::PoseLanes(std::vector<PoseColumns*> robots)
    : structure(robots.front()->model.tree()), robots_(std::move(robots)) {
  for (const Link& link : structure.links) links_.push_back(static_cast<std::size_t>(link.object));
  moving_ = links_;
  for (const FixedObject& follower : structure.followers) moving_.push_back(static_cast<std::size_t>(follower.object));
  const auto objects = static_cast<std::size_t>(robots_.front()->model.size());
  MUROSIMF_ASSERT(robots_.size() <= Pack8::lanes && links_.front() == 0);
  padding_.resize(numbers_of<Sym6> * objects);  // as long as the longest column that is taken
  q.resize(objects);
  qd.resize(objects);
  r.resize(objects);
  v.resize(objects);
  w.resize(objects);
  R.resize(objects);
}

void PoseLanes::take_joints(LaneMask lanes) noexcept {
  take(joints(), lanes, of_objects(joints(), q), [&](int lane) { return columns(lane).q.data(); });
  take(joints(), lanes, of_objects(joints(), qd), [&](int lane) { return columns(lane).qd.data(); });
}

void PoseLanes::put_back_joints(LaneMask lanes) noexcept {
  put_back(joints(), lanes, of_objects(joints(), q), [&](int lane) { return columns(lane).q.data(); });
  put_back(joints(), lanes, of_objects(joints(), qd), [&](int lane) { return columns(lane).qd.data(); });
}

void PoseLanes::update_poses() noexcept { multibody::poses<Pack8>(structure, q, r, R); }

void PoseLanes::update_velocities() noexcept { multibody::velocities<Pack8>(structure, qd, r, R, v, w); }

void PoseLanes::put_back_poses(LaneMask lanes) noexcept {
  put_back(moving(), lanes, of_objects(moving(), r), [&](int lane) { return columns(lane).r.data(); });
  put_back(moving(), lanes, of_objects(moving(), R), [&](int lane) { return columns(lane).R.data(); });
}

void PoseLanes::put_back_velocities(LaneMask lanes) noexcept {
  put_back(moving(), lanes, of_objects(moving(), v), [&](int lane) { return columns(lane).v.data(); });
  put_back(moving(), lanes, of_objects(moving(), w), [&](int lane) { return columns(lane).w.data(); });
}

}  // namespace murosimf::dynamics
