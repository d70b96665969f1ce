#include "murosimf/multibody/loop_joints.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/multibody/joint_axis.h"

namespace murosimf::multibody {
namespace {

constexpr double turn_length = 0.1;   // [m] length that weights a turn of 1 rad against a shift: the size of a joint
constexpr double closed = 1e-10;      // [m] residual of a closed loop
constexpr int most_iterations = 30;   // few are needed: joints move little from step to step
constexpr double least_share = 1e-9;  // [1] of the largest diagonal number of J^T J: m while the gap shrinks
constexpr double most_share = 1e3;    // [1] likewise: larger steps of m would move nothing
constexpr double least_gain = 0.999;  // [1] ratio of e^2 to that before an iteration, above which iterations end
constexpr double longest_step = 0.3;  // [rad | m] of any joint, in one iteration
constexpr int assembly_steps = 64;    // small enough to stay on the branch that the file's start position is on

}  // namespace

LoopJoints::LoopJoints(const Model& model, const std::vector<bool>& follows, std::vector<double> start)
    : start_(std::move(start)) {
  const auto loops = loops_of(model);
  MUROSIMF_ASSERT(start_.size() == static_cast<std::size_t>(model.size()) && follows.size() == start_.size());
  std::vector<int> column(static_cast<std::size_t>(model.size()), -1);
  for (const int joint : model.joints()) {
    if (!follows[joint] || !is_in_loop(model, loops, joint)) continue;
    column[joint] = static_cast<int>(following_.size());
    following_.push_back(joint);
  }
  if (empty()) return;
  for (const Loop& loop : loops) {
    LoopSides& sides = loops_.emplace_back();
    sides.welded = loop.welded;
    for (int k = 0; k < 2; ++k) {
      sides.sides[k].frame = loop.ends[k].frame;
      for (const int l : loop.ends[k].path) {
        const Link& link = model.tree().links[l];
        sides.sides[k].hinges.push_back({link.object, column[link.object], &link, {}, {}});
      }
    }
    rows_ += static_cast<std::size_t>(loop.rows());
  }
  columns_ = following_.size();
  kept_.resize(columns_);
  gap_.resize(rows_);
  J_.resize(rows_ * columns_);
  normal_.resize(columns_ * columns_);
  step_.resize(columns_);
  points_.resize(2 * loops_.size());
}

/// Pose of the frame at the end of a side; stores the joint axes and origins of the side.
Transformd LoopJoints::walk(Side& side, std::span<const double> q) noexcept {
  Transformd pose;
  for (Hinge& hinge : side.hinges) {
    MUROSIMF_ASSERT(hinge.link && hinge.object >= 0 && static_cast<std::size_t>(hinge.object) < q.size());
    const Link& link = *hinge.link;
    pose.position += pose.orientation * link.offset;
    if (link.turned) pose.orientation = pose.orientation * link.turn;
    hinge.axis = joint_axis(pose.orientation, link);
    hinge.origin = pose.position;
    if (link.kind == LinkKind::prismatic) {
      pose.position += q[hinge.object] * hinge.axis;
    } else {
      pose.orientation = pose.orientation * rotation(link.axis, q[hinge.object]);
    }
  }
  return pose * Transformd{side.frame.offset, side.frame.turn};
}

/// Computes e and J; returns the sum of the squares of e.
double LoopJoints::look(std::span<const double> q) noexcept {
  std::fill(J_.begin(), J_.end(), 0.0);
  MUROSIMF_ASSERT(q.size() == start_.size());
  std::size_t row = 0;
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    LoopSides& loop = loops_[i];
    const Transformd first = walk(loop.sides[0], q), second = walk(loop.sides[1], q);
    points_[2 * i] = first.position;
    points_[2 * i + 1] = second.position;
    const Vec3d shift = second.position - first.position;
    gap_[row] = shift.x;
    gap_[row + 1] = shift.y;
    gap_[row + 2] = shift.z;
    if (loop.welded) {
      const Mat3d turn = second.orientation * transpose(first.orientation);
      const Vec3d angle = turn_length * rotation_vector(from_matrix(turn));
      gap_[row + 3] = angle.x;
      gap_[row + 4] = angle.y;
      gap_[row + 5] = angle.z;
    }
    differentiate(loop.sides[0], first.position, -1, row, loop.welded);
    differentiate(loop.sides[1], second.position, 1, row, loop.welded);
    row += loop.welded ? 6 : 3;
  }
  MUROSIMF_ASSERT(row == rows_);
  double sum = 0;
  for (const double e : gap_) sum += e * e;
  return sum;
}

void LoopJoints::differentiate(const Side& side, const Vec3d& end, double sign, std::size_t row, bool welded) noexcept {
  for (const Hinge& hinge : side.hinges) {
    if (hinge.column < 0) continue;
    const auto put = [&](std::size_t at, const Vec3d& v) {
      MUROSIMF_ASSERT(static_cast<std::size_t>(hinge.column) < columns_);
      J_[at * columns_ + hinge.column] += v.x;
      J_[(at + 1) * columns_ + hinge.column] += v.y;
      J_[(at + 2) * columns_ + hinge.column] += v.z;
    };
    const bool slides = hinge.link->kind == LinkKind::prismatic;
    put(row, sign * (slides ? hinge.axis : cross(hinge.axis, end - hinge.origin)));
    if (welded && !slides) put(row + 3, (sign * turn_length) * hinge.axis);
  }
}

/// Computes the gap's rates in place of the gap, at the positions of the last look().
void LoopJoints::find_rates(std::span<const double> qd) noexcept {
  std::fill(gap_.begin(), gap_.end(), 0.0);
  MUROSIMF_ASSERT(qd.size() == start_.size());
  std::size_t row = 0;
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      Twistd sum;
      for (const Hinge& hinge : loops_[i].sides[k].hinges) {
        const Vec3d rate = qd[hinge.object] * hinge.axis;
        const bool slides = hinge.link->kind == LinkKind::prismatic;
        sum.v += slides ? rate : cross(rate, points_[2 * i + k] - hinge.origin);
        if (!slides) sum.w += rate;
      }
      const double sign = k == 0 ? -1 : 1;
      const auto put = [&](std::size_t at, const Vec3d& v) {
        gap_[at] += v.x;
        gap_[at + 1] += v.y;
        gap_[at + 2] += v.z;
      };
      put(row, sign * sum.v);
      if (loops_[i].welded) put(row + 3, (sign * turn_length) * sum.w);
    }
    row += loops_[i].welded ? 6 : 3;
  }
}

double LoopJoints::largest_diagonal() const noexcept {
  double most = 0;
  for (std::size_t c = 0; c < columns_; ++c) {
    double sum = 0;
    for (std::size_t r = 0; r < rows_; ++r) sum += J_[r * columns_ + c] * J_[r * columns_ + c];
    most = std::max(most, sum);
  }
  return most;
}

/// step = (J^T J + damping 1)^-1 J^T e, by Cholesky's factorization; the factor replaces J^T J row by row.
void LoopJoints::solve(double damping) noexcept {
  MUROSIMF_ASSERT(!(damping < 0));
  const auto L = [&](std::size_t i, std::size_t j) -> double& { return normal_[i * columns_ + j]; };
  for (std::size_t i = 0; i < columns_; ++i) {
    step_[i] = 0;
    for (std::size_t r = 0; r < rows_; ++r) step_[i] += J_[r * columns_ + i] * gap_[r];
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = i == j ? damping : 0;
      for (std::size_t r = 0; r < rows_; ++r) sum += J_[r * columns_ + i] * J_[r * columns_ + j];
      for (std::size_t k = 0; k < j; ++k) sum -= L(i, k) * L(j, k);
      L(i, j) = i == j ? std::sqrt(sum) : sum / L(j, j);
    }
    for (std::size_t k = 0; k < i; ++k) step_[i] -= L(i, k) * step_[k];
    step_[i] /= L(i, i);
  }
  for (std::size_t i = columns_; i-- > 0;) {
    for (std::size_t k = i + 1; k < columns_; ++k) step_[i] -= L(k, i) * step_[k];
    step_[i] /= L(i, i);
  }
}

void LoopJoints::move(std::span<double> q, double share) const noexcept {
  for (std::size_t c = 0; c < columns_; ++c) q[following_[c]] += share * step_[c];
}

void LoopJoints::settle(std::span<double> q) noexcept {
  double error = look(q), share = least_share;
  for (int i = 0; i < most_iterations && error > closed * closed && share < most_share; ++i) {
    const double scale = largest_diagonal();
    // m is relative to J^T J, so that the result does not depend on the robot's size
    if (!(scale > 0)) return;  // no joint moves the gap, or a number is not finite
    solve(share * scale);
    double longest = 0;
    for (const double s : step_) longest = std::max(longest, std::abs(s));
    if (!std::isfinite(longest)) return;
    const double cut = longest > longest_step ? longest_step / longest : 1;  // Newton steps from far away overshoot
    move(q, -cut);
    const double next = look(q);
    if (next < error) {
      if (next > least_gain * error) return;  // the loop does not close further
      error = next;
      share = std::max(share / 10, least_share);
    } else {
      move(q, cut);
      error = look(q);
      share *= 10;
    }
  }
}

void LoopJoints::keep(std::span<const double> q) noexcept {
  MUROSIMF_ASSERT(empty() || q.size() == start_.size());
  for (std::size_t c = 0; c < columns_; ++c) kept_[c] = q[following_[c]];
}

void LoopJoints::follow(std::span<double> q, std::span<double> qd) noexcept {
  if (empty()) return;
  MUROSIMF_ASSERT(q.size() == start_.size() && qd.size() == start_.size());
  for (std::size_t c = 0; c < columns_; ++c) {
    // from the kept positions, not from the present ones: a trial step repeated from the same state has the same bits
    q[following_[c]] = kept_[c];
    qd[following_[c]] = 0;
  }
  settle(q);
  find_rates(qd);
  solve(least_share * largest_diagonal());
  move(qd, -1);
}

void LoopJoints::assemble(std::span<double> q) noexcept {
  if (empty()) return;
  MUROSIMF_ASSERT(q.size() == start_.size());
  const std::vector<double> goal(q.begin(), q.end());
  // continuation from the closed position: a jump could end on another branch of the linkage
  std::vector<double> way = start_;
  for (int i = 0; i <= assembly_steps; ++i) {
    const double share = static_cast<double>(i) / assembly_steps;
    keep(way);
    for (std::size_t k = 0; k < way.size(); ++k) way[k] = start_[k] + share * (goal[k] - start_[k]);
    for (std::size_t c = 0; c < columns_; ++c) way[following_[c]] = kept_[c];
    settle(way);
  }
  for (const int joint : following_) q[joint] = way[joint];
}

double LoopJoints::gap(std::span<const double> q) noexcept { return empty() ? 0 : std::sqrt(look(q)); }

}  // namespace murosimf::multibody
