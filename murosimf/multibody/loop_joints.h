/// loop_joints.h - passive joints of loops, whose positions follow from those of the driven joints: Newton's method.
///
/// The gap e of the loops' frames (difference of their origins; of welded ones also 0.1 m times the rotation vector) depends on the
/// passive joints p and on all other joints a:
///
///     p -= (J^T J + m 1)^-1 J^T e,   J = de/dp;       p' = -(J^T J + m 1)^-1 J^T (de/da a')
///
/// m is close to zero while the gap shrinks (Levenberg, Marquardt). Where joints are not determined, as the turn of a rod about
/// itself, they move least; where loops cannot close, the gap is smallest. dynamics/mimic_joints.h selects the joints that follow.
/// Source: Nocedal, Wright, Numerical Optimization, sec. 10.3; loops: Featherstone 2008, sec. 8.
#pragma once

#include <span>
#include <vector>

#include "murosimf/math/transform.h"
#include "murosimf/multibody/loops.h"

namespace murosimf::multibody {

class LoopJoints {
 public:
  /// `follows`: by object, passive joints; those that are in no loop are ignored. `start` [rad | m] by object: a posture in which
  /// the loops are closed.
  LoopJoints(const Model& model, const std::vector<bool>& follows, std::vector<double> start);

  [[nodiscard]] bool empty() const { return following_.empty(); }
  /// Objects of the joints that follow.
  [[nodiscard]] std::span<const int> joints() const { return following_; }

  /// Stores the present positions: follow() begins there.
  void keep(std::span<const double> q) noexcept;
  /// Moves the joints to where the loops close: positions and rates, by object.
  void follow(std::span<double> q, std::span<double> qd) noexcept;
  /// The same for a robot at rest, from the closed posture in small steps of all joints, so that the result is on the file's branch.
  void assemble(std::span<double> q) noexcept;
  /// Root of the sum of all gaps' squares [m].
  [[nodiscard]] double gap(std::span<const double> q) noexcept;

 private:
  /// A joint on the way to the end of a loop.
  struct Hinge {
    int object = 0, column = -1;  // column of J; -1: it is driven
    const Link* link = nullptr;
    Vec3d axis, origin;  // [1], [m] seen from the loop's common link
  };
  struct Side {
    FixedObject frame;
    std::vector<Hinge> hinges;
  };
  struct LoopSides {
    Side sides[2];
    bool welded = false;
  };
  [[nodiscard]] static Transformd walk(Side& side, std::span<const double> q) noexcept;
  [[nodiscard]] double look(std::span<const double> q) noexcept;
  void differentiate(const Side& side, const Vec3d& end, double sign, std::size_t row, bool welded) noexcept;
  void find_rates(std::span<const double> qd) noexcept;
  void settle(std::span<double> q) noexcept;
  [[nodiscard]] double largest_diagonal() const noexcept;
  void solve(double damping) noexcept;
  void move(std::span<double> q, double share) const noexcept;

  std::vector<int> following_;
  std::vector<double> start_, kept_;
  std::vector<LoopSides> loops_;
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<double> gap_;         // e
  std::vector<double> J_, normal_;  // row by row; J^T J, then its factor
  std::vector<double> step_;        // of p
  std::vector<Vec3d> points_;       // [m] both ends of each loop
};

}  // namespace murosimf::multibody
