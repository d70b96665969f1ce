#include "murosimf/dynamics/tree_lanes.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "murosimf/math/assert.h"

namespace murosimf::dynamics {
namespace {

/// The union of the bits of some numbers.
class SomeBits {
 public:
  template <std::size_t numbers>
  MUROSIMF_INLINE void add(const double* row) {
    constexpr std::size_t whole = numbers - numbers % register_lanes;
    for (std::size_t k = 0; k < whole; k += register_lanes) {
      Pack8::MaskRegister more;
      std::memcpy(&more, row + k, sizeof more);
      wide_ |= more;
    }
    for (std::size_t k = whole; k < numbers; ++k) rest_ |= std::bit_cast<std::uint64_t>(row[k]);
    // bits are enough to tell zeros from other numbers, and need no comparison for each number
  }
  /// Whether any number is not zero; the sign bit of zeros is ignored.
  [[nodiscard]] bool of_other_than_zeros() const {
    std::uint64_t bits = rest_;
    for (int i = 0; i < register_lanes; ++i) bits |= static_cast<std::uint64_t>(wide_[i]);
    return bits << 1U != 0;
  }

 private:
  Pack8::MaskRegister wide_{};
  std::uint64_t rest_ = 0;
};

multibody::LinkMotion<double> lane_of_link(const multibody::LinkMotion<Pack8>& from, int lane) {
  const auto& inertia = from.inertia;
  return {lane_of(from.axis, lane),
          lane_of(from.velocity, lane),
          lane_of(from.bias, lane),
          {inertia.mass, lane_of(inertia.first, lane), lane_of(inertia.second, lane)},
          lane_of(from.bias_force, lane)};
}

}  // namespace

TreeLanes::TreeLanes(std::vector<MovingTree*> trees)
    : poses(parts_of(trees, [](MovingTree& tree) { return &tree.columns; })),
      links(poses.structure.links.size()),
      trees_(std::move(trees)),
      is_busy_(poses.objects()) {
  MUROSIMF_ASSERT(!trees_.empty() && trees_.size() <= Pack8::lanes);
}

void TreeLanes::take(LaneMask lanes) noexcept {
  LaneMask without_links = 0;
  for_lanes(lanes, [&](int lane) {
    MovingTree& tree = this->tree(lane);
    const bool changed = tree.written_.differs(tree.columns);
    // the lane still holds the state that the last step left: nothing to copy
    if (has_lane(fresh_, lane) && tree.lanes_ == this && !changed) return;
    take_state(lane);
    if (!changed && !tree.has_own_links_) {
      without_links |= lane_bit(lane);
    } else {
      tree.take_changes();
      take_links(lane);
    }
  });
  // in all lanes: where links are there, they keep their bits, since all of it follows from bases and joints
  if (std::popcount(without_links) >= fewest_in_lanes) return refresh();
  for_lanes(without_links, [&](int lane) {
    tree(lane).take_links_back();
    take_links(lane);
  });
}

void TreeLanes::take_state(int lane) noexcept {
  const MovingTree& tree = this->tree(lane);
  set_lane(base_, lane, tree.base());
  set_lane(poses.R[0], lane, tree.columns.R[0]);  // not from the quaternion: at a start, that follows from the matrix
  for (const std::size_t i : poses.joints()) {
    poses.q[i].set_lane(lane, tree.columns.q[i]);
    poses.qd[i].set_lane(lane, tree.columns.qd[i]);
  }
}

/// From a tree that has its own.
void TreeLanes::take_links(int lane) noexcept {
  const MovingTree& tree = this->tree(lane);
  MUROSIMF_ASSERT(tree.has_own_links_);
  for (const std::size_t i : poses.moving()) set_lane(poses.r[i], lane, tree.columns.r[i]);
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
  MUROSIMF_ASSERT(due >> trees_.size() == 0);
  for_lanes(due, [&](int lane) {
    if (!tree(lane).contacts.solved()) lanes |= lane_bit(lane);
  });
  return std::popcount(lanes) < fewest_in_lanes ? 0 : lanes;
}

/// Bodies of all robots are tested together: most carry nothing in any robot, and one test for all of them is enough.
void TreeLanes::look_for_loads(LaneMask lanes) noexcept {
  LaneRows<const Wrenchd> forces;
  LaneRows<const Sym6d> dampings;
  std::size_t robots = 0;
  std::fill(is_busy_.begin(), is_busy_.end(), false);
  for_lanes(lanes, [&](int lane) {
    MUROSIMF_ASSERT(robots < forces.size());
    const MovingTree& robot = tree(lane);
    forces[robots] = robot.external_force.data();
    dampings[robots++] = robot.external_damping.data();
    for (const int object : robot.contacts.touching()) is_busy_[static_cast<std::size_t>(object)] = true;
  });
  busy_.clear();
  for (const int object : trees_.front()->columns.model.bodies()) {
    const auto i = static_cast<std::size_t>(object);
    SomeBits bits;
    for (std::size_t k = 0; k < robots; ++k) {
      bits.add<6>(&forces[k][i].n.x);
      bits.add<4>(&dampings[k][i].J.xx);  // what is_zero asks for, the diagonals, and one number more
      bits.add<4>(&dampings[k][i].M.xx);
    }
    // touching bodies stay in the list even while their force is zero: later passes may load them
    if (is_busy_[i] || bits.of_other_than_zeros()) busy_.push_back(i);
  }
}

void TreeLanes::gather_load(std::size_t object, LaneMask lanes) noexcept {
  load_.loaded = load_.damped = 0;
  for_lanes(lanes, [&](int lane) {
    const bool damped = !is_zero(tree(lane).external_damping[object]);
    if (!damped && is_zero(tree(lane).external_force[object])) return;
    load_.loaded |= lane_bit(lane);
    if (damped) load_.damped |= lane_bit(lane);
  });
  if (load_.loaded == 0) return;
  const std::span<const std::size_t> one(&object, 1);
  poses.take(
      one, load_.loaded, [&](std::size_t) -> Wrench<Pack8>& { return load_.force; },
      [&](int lane) { return tree(lane).external_force.data(); });
  poses.take(
      one, load_.loaded, [&](std::size_t) -> Sym6<Pack8>& { return load_.damping; },
      [&](int lane) { return tree(lane).external_damping.data(); });
}

/// Moves force and damping from the body's origin to O, as MovingTree::for_loads does.
void TreeLanes::see_load_from_base(int link, std::size_t object, double dt) noexcept {
  MUROSIMF_ASSERT(link >= 0 && static_cast<std::size_t>(link) < links.size() && dt > 0);
  const auto& motion = links[static_cast<std::size_t>(link)];
  const Vec3<Pack8> to_base = poses.r[0] - poses.r[object];
  const Vec3<Pack8> d = poses.r[object] - poses.r[0];
  const auto& [w, v] = motion.velocity;
  const Vec3<Pack8> zero;
  const Vec3<Pack8> alpha = motion.bias.w + zero;  // + zero as for one robot: it turns -0 into 0
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

LaneMask TreeLanes::in_flight(LaneMask lanes) const noexcept {
  LaneMask flying = 0;
  for_lanes(lanes, [&](int lane) {
    if (tree(lane).is_in_flight()) flying |= lane_bit(lane);
  });
  return flying;
}

TreeLanes::CenterMotion TreeLanes::momentum(const Vec3<Pack8>& center) const noexcept {
  const Wrench<Pack8> about_base = multibody::momentum<Pack8>(links);
  const Vec3<Pack8> c = center - poses.r[0];
  return {about_base.f + whole.mass * base_.velocity, about_base.n - cross(c, about_base.f), center};
}

/// MovingTree::momentum_after.
void TreeLanes::want_momentum(LaneMask flying, double dt) noexcept {
  Vec3<Pack8> center;
  MUROSIMF_ASSERT(dt > 0 && flying != 0);
  for_lanes(flying, [&](int lane) { set_lane(center, lane, tree(lane).center_); });
  CenterMotion after = momentum(center);
  after.linear += (dt * whole.mass) * trees_.front()->gravity;
  for (const int body : trees_.front()->columns.model.bodies()) {
    const auto object = static_cast<std::size_t>(body);
    Wrench<Pack8> force;
    poses.take(
        {&object, 1}, flying, [&](std::size_t) -> Wrench<Pack8>& { return force; },
        [&](int lane) { return tree(lane).external_force.data(); });
    const Wrench<Pack8> push = moved(force, center - poses.r[object]);
    after.linear += dt * push.f;
    after.angular += dt * push.n;
  }
  after.center += (dt / whole.mass) * after.linear;
  wanted_ = after;
}

LaneMask TreeLanes::advance_bases(const Twist<Pack8>& acceleration, double dt, LaneMask lanes) noexcept {
  MUROSIMF_ASSERT(dt > 0 && lanes >> trees_.size() == 0);
  flying_ = in_flight(lanes);
  multibody::FreeBody<Pack8> next = base_;
  const Vec3d& gravity = trees_.front()->gravity;
  multibody::advance(next, {acceleration.w, acceleration.v + gravity}, dt);
  if (flying_ != 0) {
    want_momentum(flying_, dt);
    const Vec3<Pack8> middle_rate = base_.rate + (0.5 * dt) * acceleration.w;
    assign_where(where(flying_), normalized(exponential(dt * middle_rate) * base_.turn), next.turn);
  }
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

void TreeLanes::take_advanced(int lane) noexcept {
  MUROSIMF_ASSERT(lane >= 0 && static_cast<std::size_t>(lane) < trees_.size());
  const MovingTree& tree = this->tree(lane);
  take_state(lane);
  flying_ &= ~lane_bit(lane);
  if (!tree.wanted_momentum_) return;
  flying_ |= lane_bit(lane);
  set_lane(wanted_.linear, lane, tree.wanted_momentum_->linear);
  set_lane(wanted_.angular, lane, tree.wanted_momentum_->angular);
  set_lane(wanted_.center, lane, tree.wanted_momentum_->center);
}

void TreeLanes::finish_step(LaneMask lanes, LaneMask with_links) noexcept {
  MUROSIMF_ASSERT((with_links & ~lanes) == 0);
  for_lanes(lanes, [&](int lane) { tree(lane).contacts.renew(); });
  poses.R[0] = to_matrix(base_.turn);
  refresh();
  if ((flying_ & lanes) != 0) correct_momentum(flying_ & lanes);
  poses.put_back_poses(lanes);
  poses.put_back_velocities(lanes);
  put_back_whole(lanes);
  for_lanes(lanes, [&](int lane) {
    MovingTree& tree = this->tree(lane);
    tree.written_.remember(tree.columns);
    tree.lanes_ = this;
    tree.has_own_links_ = has_lane(with_links, lane);
  });
  put_back_links(lanes & with_links);
  // the next step may skip reading these lanes
  fresh_ = lanes;
}

/// MovingTree::correct_momentum.
void TreeLanes::correct_momentum(LaneMask flying) noexcept {
  const CenterMotion now = momentum(center_of_mass());
  const Vec3<Pack8> linear = wanted_.linear - now.linear;
  const Vec3<Pack8> angular = wanted_.angular - now.angular;
  const Vec3<Pack8> c = now.center - poses.r[0];
  const Twist<Pack8> change = solve(to_sym6(whole), {angular + cross(c, linear), linear});
  const Pack8::Mask mask = where(flying);
  assign_where(mask, base_.rate + change.w, base_.rate);
  assign_where(mask, base_.velocity + change.v, base_.velocity);
  assign_where(mask, base_.position + (wanted_.center - now.center), base_.position);
  refresh();
}

/// Poses, velocities, links and common mass, from the base and the joints.
void TreeLanes::refresh() noexcept {
  poses.r[0] = base_.position;
  poses.v[0] = base_.velocity;
  poses.w[0] = base_.rate;
  poses.update_poses();
  poses.update_velocities();
  multibody::link_motions<Pack8>(poses.structure, poses.r, poses.R, poses.w[0], poses.qd, links);
  whole = multibody::composite_inertia<Pack8>(links);
}

/// Link by link: the packs of all are more than the first-level cache holds.
void TreeLanes::put_back_links(LaneMask lanes) const noexcept {
  MUROSIMF_ASSERT(lanes >> trees_.size() == 0);
  for (std::size_t l = 0; l < links.size(); ++l) {
    for_lanes(lanes, [&](int lane) { tree(lane).links[l] = lane_of_link(links[l], lane); });
  }
  for_lanes(lanes, [&](int lane) {
    tree(lane).whole_ = {whole.mass, lane_of(whole.first, lane), lane_of(whole.second, lane)};
  });
}

/// The robot as one body: as MovingTree::update_links has it.
void TreeLanes::put_back_whole(LaneMask lanes) noexcept {
  const Vec3<Pack8> c = (1 / whole.mass) * whole.first;
  const Vec3<Pack8> center = center_of_mass();
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

}  // namespace murosimf::dynamics
