/// tree_lanes.h - up to eight copies of one robot, each in its own lane: the counterpart of moving_tree.h.
///
/// Poses, velocities and links are computed in packs, with the kernels and so with the bits of a robot alone. Columns receive the part
/// that others read. Links stay here from step to step: the links of one robot alone are computed again where they are needed
/// (MovingTree::take_changes), unless the robot receives them at the end of each step, as one that an island solver settles. A robot whose
/// columns have been changed by others is read in again; links of loaded states are computed here, in all lanes at once.
#pragma once

#include <span>
#include <vector>

#include "murosimf/dynamics/moving_tree.h"
#include "murosimf/dynamics/pose_lanes.h"
#include "murosimf/math/assert.h"

namespace murosimf::dynamics {

class TreeLanes {
 public:
  /// One to eight, of which each goes with each (MovingTree::goes_with); they outlive this object.
  explicit TreeLanes(std::vector<MovingTree*> trees);

  /// To be called first in a step, in the place of MovingTree::take_changes: reads the robots' columns into their lanes.
  void take(LaneMask lanes) noexcept;

  /// To be called at the beginning of a step: finds the bodies that may have a load in its passes.
  void look_for_loads(LaneMask lanes) noexcept;
  /// MovingTree::for_loads of these lanes: calls add(link, those of the lanes with a load, force, damping).
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

  /// The robots of `due` that can step in lanes: no island solver has settled their step. None if they are too few.
  [[nodiscard]] LaneMask ready(LaneMask due) const noexcept;

  /// MovingTree::advance_base by a'_0 for a step of dt [s]: writes the sane bases back to their columns; the other robots are not
  /// changed. Returns the lanes with a sane base.
  [[nodiscard]] LaneMask advance_bases(const Twist<Pack8>& acceleration, double dt, LaneMask lanes) noexcept;
  /// Reads in the base and the joints of a robot that has been advanced alone, for the end of its step.
  void take_advanced(int lane) noexcept;
  /// Ends a step of these lanes, once bases and joints are final: as MovingTree::finish_step. Robots of `with_links` receive
  /// their links.
  void finish_step(LaneMask lanes, LaneMask with_links = 0) noexcept;

  [[nodiscard]] MovingTree& tree(int lane) const noexcept {
    MUROSIMF_ASSERT(lane >= 0 && static_cast<std::size_t>(lane) < trees_.size());
    return *trees_[static_cast<std::size_t>(lane)];
  }

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
  /// The load of a body, by lane.
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
  void take_state(int lane) noexcept;
  void take_links(int lane) noexcept;
  void refresh() noexcept;
  void put_back_whole(LaneMask lanes) noexcept;
  void put_back_links(LaneMask lanes) const noexcept;

  std::vector<MovingTree*> trees_;
  LaneMask fresh_ = 0;  // lanes that hold their robot's state as the last step left it
  multibody::FreeBody<Pack8> base_;
  CenterMotion wanted_;            // momentum after the present step, of the lanes in flight
  LaneMask flying_ = 0;            // lanes in flight
  std::vector<char> is_busy_;      // by object: it touches something
  std::vector<std::size_t> busy_;  // objects that may have a load, in the model's order
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

}  // namespace murosimf::dynamics
