/// tree_lanes.h - up to eight copies of one robot, each in its own lane: what moving_tree.h is for one.
///
/// Poses, velocities and links are worked out in packs, with the kernels and so with the bits of a robot alone. Columns get what
/// others read of them. Links stay here from step to step: whoever needs those of one robot alone works them out again
/// (MovingTree::take_changes), unless it gets them at the end of each step, as one that an island solver settles. A robot whose columns
/// somebody has changed is taken in anew.
#pragma once

#include <span>
#include <vector>

#include "murosimf/motion/moving_tree.h"
#include "murosimf/motion/pose_lanes.h"

namespace murosimf::motion {

class TreeLanes {
 public:
  /// One to eight, of which each goes with each (MovingTree::goes_with); they outlive this.
  explicit TreeLanes(std::vector<MovingTree*> trees);

  /// To be called first in a step, in the place of MovingTree::take_changes: the lane has the robot as its columns are.
  void take(int lane) noexcept;

  /// To be called at the beginning of a step: finds the bodies that may feel something in its passes.
  void look_for_loads(LaneMask lanes) noexcept;
  /// MovingTree::for_loads of these lanes: calls add(link, those of the lanes in which it feels anything, force, damping).
  template <class Add>
  void for_loads(LaneMask lanes, double dt, const Add& add) noexcept;

  /// MovingTree::predict_contacts; acceleration_of(link) is a' of a link of this robot.
  template <class Acceleration>
  void predict_contacts(int lane, double dt, const Acceleration& acceleration_of) noexcept {
    const auto motion_of = [&](int l) {
      const auto& link = links[static_cast<std::size_t>(l)];
      return Motion{lane_of(link.velocity, lane), lane_of(link.bias, lane)};
    };
    tree(lane).predict_contacts(dt, motion_of, acceleration_of);
  }

  /// Those of these robots that can step in lanes now: nobody has settled their step already. None if they are too few.
  [[nodiscard]] LaneMask ready(LaneMask due) const noexcept;

  /// MovingTree::advance_base by a'_0 for a step of dt [s]: puts the bases of the lanes that have come to a sensible state back into their
  /// columns; of the others nothing is changed. Returns these lanes.
  [[nodiscard]] LaneMask advance_bases(const Twist<Pack8>& acceleration, double dt, LaneMask lanes) noexcept;
  /// Takes in the base and the joints of a robot that has been advanced alone, for the end of its step.
  void take_advanced(int lane) noexcept;
  /// The end of a step of these lanes, once bases and joints stand where they will: as MovingTree::finish_step. Robots of `with_links` get
  /// their links back.
  void finish_step(LaneMask lanes, LaneMask with_links = 0) noexcept;

  [[nodiscard]] MovingTree& tree(int lane) const noexcept { return *trees_[static_cast<std::size_t>(lane)]; }

  /// As in the columns of the lanes that have been taken.
  PoseLanes poses;
  std::vector<multibody::LinkMotion<Pack8>> links;
  RigidInertia<Pack8> whole;  ///< of all links, about O

 private:
  /// Of a link, as LinkMotion has them.
  struct Motion {
    Twistd velocity, bias;
  };
  /// As MovingTree has it.
  struct CenterMotion {
    Vec3<Pack8> linear, angular, center;
  };
  /// What a body feels, by lane.
  struct Load {
    LaneMask loaded = 0, damped = 0;
    Wrench<Pack8> force;
    Sym6<Pack8> damping;
  };
  void gather_load(std::size_t object, LaneMask lanes) noexcept;
  void see_load_from_base(int link, std::size_t object, double dt) noexcept;
  [[nodiscard]] LaneMask in_flight(LaneMask lanes) const noexcept;
  [[nodiscard]] CenterMotion momentum(const Vec3<Pack8>& center) const noexcept;
  void want_momentum(LaneMask flying, double dt) noexcept;
  [[nodiscard]] Vec3<Pack8> center_of_mass() const noexcept { return poses.r[0] + (1 / whole.mass) * whole.first; }
  void correct_momentum(LaneMask flying) noexcept;
  void refresh() noexcept;
  void put_back_whole(LaneMask lanes) noexcept;
  void put_back_links(LaneMask lanes) const noexcept;

  std::vector<MovingTree*> trees_;
  LaneMask fresh_ = 0;  // lanes that have their robot as this left it
  multibody::FreeBody<Pack8> base_;
  CenterMotion wanted_;            // after the present step, of the lanes in flight
  LaneMask flying_ = 0;            // these
  std::vector<char> is_busy_;      // by object: it touches something
  std::vector<std::size_t> busy_;  // those that may, in the model's order
  Load load_;                      // working memory
};

// ---- definitions ----

template <class Add>
void TreeLanes::for_loads(LaneMask lanes, double dt, const Add& add) noexcept {
  for (const std::size_t object : busy_) {
    gather_load(object, lanes);
    if (load_.loaded == 0) continue;
    const int link = poses.structure.link_of[object];
    see_load_from_base(link, object, dt);
    add(static_cast<std::size_t>(link), load_.loaded, load_.force, load_.damping);
  }
}

}  // namespace murosimf::motion
