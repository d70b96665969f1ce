#include "murosimf/motion/tree_lanes.h"

#include <algorithm>
#include <bit>

namespace murosimf::motion {

TreeLanes::TreeLanes(std::vector<MovingTree*> trees)
    : poses(parts_of(trees, [](MovingTree& tree) { return &tree.columns; })),
      links(poses.structure.links.size()),
      trees_(std::move(trees)),
      is_busy_(poses.objects()) {}

void TreeLanes::take(int lane) noexcept {
  MovingTree& tree = this->tree(lane);
  if (has_lane(fresh_, lane) && tree.lanes_ == this && !tree.written_.differs(tree.columns)) return;
  tree.take_changes();
  set_lane(base_, lane, tree.base());
  for (const std::size_t i : poses.moving()) set_lane(poses.r[i], lane, tree.columns.r[i]);
  for (const std::size_t i : poses.joints()) {
    poses.q[i].set_lane(lane, tree.columns.q[i]);
    poses.qd[i].set_lane(lane, tree.columns.qd[i]);
  }
  for (std::size_t l = 0; l < links.size(); ++l) {
    const auto& from = tree.links[l];
    auto& to = links[l];
    set_lane(to.axis, lane, from.axis);
    set_lane(to.velocity, lane, from.velocity);
    set_lane(to.bias, lane, from.bias);
    to.inertia.mass = from.inertia.mass;
    set_lane(to.inertia.first, lane, from.inertia.first);
    set_lane(to.inertia.second, lane, from.inertia.second);
    set_lane(to.bias_force, lane, from.bias_force);
  }
  whole.mass = tree.whole_.mass;
  set_lane(whole.first, lane, tree.whole_.first);
  set_lane(whole.second, lane, tree.whole_.second);
}

LaneMask TreeLanes::ready(LaneMask due) const noexcept {
  LaneMask lanes = 0;
  for_lanes(due, [&](int lane) {
    if (!tree(lane).contacts.solved() && !tree(lane).is_in_flight()) lanes |= lane_bit(lane);
  });
  return std::popcount(lanes) < fewest_in_lanes ? 0 : lanes;
}

void TreeLanes::look_for_loads(LaneMask lanes) noexcept {
  const std::span<const int> bodies = trees_.front()->columns.model.bodies();
  std::fill(is_busy_.begin(), is_busy_.end(), false);
  for_lanes(lanes, [&](int lane) {
    const MovingTree& robot = tree(lane);
    const Wrenchd* const force = robot.external_force.data();
    const Sym6d* const damping = robot.external_damping.data();
    for (const int object : bodies) {
      if (!is_zero(force[object]) || !is_zero(damping[object])) is_busy_[static_cast<std::size_t>(object)] = true;
    }
    for (const int object : robot.contacts.touching()) is_busy_[static_cast<std::size_t>(object)] = true;
  });
  busy_.clear();
  for (const int object : bodies) {
    if (is_busy_[static_cast<std::size_t>(object)]) busy_.push_back(static_cast<std::size_t>(object));
  }
}

void TreeLanes::gather_load(std::size_t object, LaneMask lanes) noexcept {
  load_.loaded = load_.damped = 0;
  for_lanes(lanes, [&](int lane) {
    const Wrenchd& force = tree(lane).external_force[object];
    const Sym6d& damping = tree(lane).external_damping[object];
    const bool damped = !is_zero(damping);
    if (!damped && is_zero(force)) return;
    load_.loaded |= lane_bit(lane);
    if (damped) load_.damped |= lane_bit(lane);
    set_lane(load_.force, lane, force);
    set_lane(load_.damping, lane, damping);
  });
}

/// From force and damping at the body's origin to those at O, as MovingTree::for_loads has them.
void TreeLanes::see_load_from_base(int link, std::size_t object, double dt) noexcept {
  const auto& motion = links[static_cast<std::size_t>(link)];
  const Vec3<Pack8> to_base = poses.r[0] - poses.r[object];
  const Vec3<Pack8> d = poses.r[object] - poses.r[0];
  const auto& [w, v] = motion.velocity;
  const Vec3<Pack8> zero;
  const Vec3<Pack8> alpha = motion.bias.w + zero;
  const Vec3<Pack8> a = motion.bias.v + trees_.front()->gravity + zero + cross(alpha, d) + cross(w, v + cross(w, d));
  const Sym6<Pack8> damping = dt * load_.damping;
  Wrench<Pack8> force = load_.force;
  force -= damping * Twist<Pack8>{alpha, a};
  const Pack8::Mask damped = where(load_.damped);
  assign_where(damped, force, load_.force);
  load_.force = moved(load_.force, to_base);
  load_.damping = {};
  assign_where(damped, moved(damping, to_base), load_.damping);
}

LaneMask TreeLanes::advance_bases(const Twist<Pack8>& acceleration, double dt, LaneMask lanes) noexcept {
  multibody::FreeBody<Pack8> next = base_;
  const Vec3d& gravity = trees_.front()->gravity;
  multibody::advance(next, {acceleration.w, acceleration.v + gravity}, dt);
  LaneMask sane = 0;
  for_lanes(lanes, [&](int lane) {
    const multibody::FreeBody<double> base = lane_of(next, lane);
    MovingTree& tree = this->tree(lane);
    tree.wanted_momentum_.reset();
    if (!is_sane(base)) return;
    tree.place_base(base);
    sane |= lane_bit(lane);
  });
  base_ = next;
  return sane;
}

void TreeLanes::finish_step(LaneMask lanes) noexcept {
  for_lanes(lanes, [&](int lane) { tree(lane).contacts.renew(); });
  poses.r[0] = base_.position;
  poses.R[0] = to_matrix(base_.turn);
  poses.v[0] = base_.velocity;
  poses.w[0] = base_.rate;
  poses.update_poses();
  poses.update_velocities();
  multibody::link_motions<Pack8>(poses.structure, poses.r, poses.R, poses.w[0], poses.qd, links);
  whole = multibody::composite_inertia<Pack8>(links);
  poses.put_back_poses(lanes);
  poses.put_back_velocities(lanes);
  put_back_whole(lanes);
  for_lanes(lanes, [&](int lane) {
    MovingTree& tree = this->tree(lane);
    tree.written_.remember(tree.columns);
    tree.lanes_ = this;
  });
  fresh_ = lanes;
}

/// The robot as one body: as MovingTree::update_links has it.
void TreeLanes::put_back_whole(LaneMask lanes) noexcept {
  const Vec3<Pack8> c = (1 / whole.mass) * whole.first;
  const Vec3<Pack8> center = poses.r[0] + c;
  const SymMat3<Pack8> inertia = whole.second - whole.mass * inertia_of_point(c);
  const Vec3<Pack8> velocity = poses.v[0] + (1 / whole.mass) * multibody::linear_momentum<Pack8>(links);
  for_lanes(lanes, [&](int lane) {
    MovingTree& tree = this->tree(lane);
    tree.total_mass_ = whole.mass;
    tree.center_ = lane_of(center, lane);
    tree.common_inertia_ = lane_of(inertia, lane);
    tree.center_velocity_ = lane_of(velocity, lane);
  });
}

}  // namespace murosimf::motion
