#include "murosimf/motion/tree_lanes.h"

#include "murosimf/multibody/kinematics.h"

namespace murosimf::motion {

TreeLanes::TreeLanes(std::vector<MovingTree*> trees)
    : structure(trees.front()->columns.model.tree()), trees_(std::move(trees)), runs_(runs_of_moving_objects()) {
  const auto objects = static_cast<std::size_t>(trees_.front()->columns.model.size());
  nobody_.resize(numbers_of<Mat3> * objects);
  q.resize(objects);
  qd.resize(objects);
  links.resize(structure.links.size());
  r_.resize(objects);
  v_.resize(objects);
  w_.resize(objects);
  R_.resize(objects);
}

std::vector<TreeLanes::Run> TreeLanes::runs_of_moving_objects() const {
  std::vector<Run> runs;
  std::size_t i = 0;
  for (const Object& object : trees_.front()->columns.model.objects()) {
    const bool begins = runs.empty() || runs.back().begin + runs.back().size != i;
    if (!object.structural) begins ? runs.push_back({i, 1}) : void(++runs.back().size);
    ++i;
  }
  return runs;
}

void TreeLanes::take(int lane) noexcept {
  MovingTree& tree = this->tree(lane);
  if (has_lane(fresh_, lane) && tree.lanes_ == this && !tree.written_.differs(tree.columns)) return;
  tree.take_changes();
  set_lane(base_, lane, tree.base());
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i].set_lane(lane, tree.columns.q[i]);
    qd[i].set_lane(lane, tree.columns.qd[i]);
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

void TreeLanes::give_back(int lane) noexcept { tree(lane).take_links_back(); }

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
  r_[0] = base_.position;
  R_[0] = to_matrix(base_.turn);
  v_[0] = base_.velocity;
  w_[0] = base_.rate;
  multibody::poses<Pack8>(structure, q, r_, R_);
  multibody::velocities<Pack8>(structure, qd, r_, R_, v_, w_);
  multibody::link_motions<Pack8>(structure, r_, R_, w_[0], qd, links);
  whole = multibody::composite_inertia<Pack8>(links);
  put_back(r_, lanes, [](PoseColumns& columns) { return columns.r.data(); });
  put_back(R_, lanes, [](PoseColumns& columns) { return columns.R.data(); });
  put_back(v_, lanes, [](PoseColumns& columns) { return columns.v.data(); });
  put_back(w_, lanes, [](PoseColumns& columns) { return columns.w.data(); });
  put_back_whole(lanes);
  for_lanes(lanes, [&](int lane) {
    MovingTree& tree = this->tree(lane);
    tree.written_.remember(tree.columns);
    tree.lanes_ = this;
  });
  fresh_ = lanes;
}

template <class T, class Column>
void TreeLanes::put_back(const std::vector<T>& rows, LaneMask lanes, const Column& column) noexcept {
  constexpr std::size_t numbers = sizeof(T) / sizeof(Pack8);
  for (const Run& run : runs_) {
    LaneRows<double> to;
    to.fill(nobody_.data());
    for_lanes(lanes, [&](int lane) {
      to[static_cast<std::size_t>(lane)] = reinterpret_cast<double*>(column(tree(lane).columns) + run.begin);
    });
    scatter(reinterpret_cast<const Pack8*>(rows.data() + run.begin), numbers * run.size, to);
  }
}

/// The robot as one body: as MovingTree::update_links has it.
void TreeLanes::put_back_whole(LaneMask lanes) noexcept {
  const Vec3<Pack8> c = (1 / whole.mass) * whole.first;
  const Vec3<Pack8> center = r_[0] + c;
  const SymMat3<Pack8> inertia = whole.second - whole.mass * inertia_of_point(c);
  const Vec3<Pack8> velocity = v_[0] + (1 / whole.mass) * multibody::linear_momentum<Pack8>(links);
  for_lanes(lanes, [&](int lane) {
    MovingTree& tree = this->tree(lane);
    tree.total_mass_ = whole.mass;
    tree.center_ = lane_of(center, lane);
    tree.common_inertia_ = lane_of(inertia, lane);
    tree.center_velocity_ = lane_of(velocity, lane);
  });
}

}  // namespace murosimf::motion
