/// course.h - the behavior of examples that cross an obstacle course, as shared library (course.cpp), over TCP (course_tcp.cpp) and over a
/// serial line (course_serial.cpp): joint angles in, joint angles out. It does not depend on how its robot is connected.
///
/// Its own gait for kid21 without balance: at `kinematic_walking`. Its position follows from its joints alone: the lower foot stands still.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

class CourseRunner {
 public:
  static constexpr double period = 0.01;  // [s] from one step to the next
  /// Of each leg, left and right; the others stay at 0.
  static constexpr std::size_t of_leg = 4, joint_count = 8;
  static constexpr std::array<const char*, joint_count> joints{"j_l_hip_yaw", "j_l_thigh", "j_l_shin", "j_l_ankle",
                                                               "j_r_hip_yaw", "j_r_thigh", "j_r_shin", "j_r_ankle"};
  using Angles = std::array<double, joint_count>;  // [rad]

  /// From where the joints are to where they shall be. True when it has just arrived.
  bool step(const Angles& measured, Angles& target) {
    follow(measured);
    const bool at_goal = look_for_goal();
    const bool arrives = at_goal && !arrived;
    arrived = at_goal;
    if (cycle_ < crouching) {
      crouch();
    } else if (!arrived || (cycle_ - crouching) % cycles != 0) {  // a step that has begun is ended
      walk((cycle_ - crouching) % cycles);
    }
    if (!arrived || (cycle_ - crouching) % cycles != 0) ++cycle_;
    for (std::size_t side = 0; side < 2; ++side) bend(feet_[side], &target[of_leg * side]);
    return arrives;
  }

  bool arrived = false;
  /// [m, m, rad] estimated pose, which starts at 0, 0, 0.
  [[nodiscard]] std::array<double, 3> place() const { return {x_, y_, heading_}; }

 private:
  static constexpr double thigh = 0.12, hip_to_side = 0.05;  // [m] of kid21; its shin is as long
  static constexpr double height = 0.225, lift = 0.02,
                          stride = 0.03;             // [m] hip over ankle; of the swinging foot; half a step
  static constexpr double most_turn = 0.12;          // [rad] half of what a step turns
  static constexpr int crouching = 50, cycles = 30;  // [cycles] at the start; of a step
  static constexpr double close = 0.1;               // [m] a point of the way is reached
  static constexpr std::array<std::array<double, 2>, 4> way{{{0.9, -0.35}, {1.5, 0.0}, {2.1, 0.35}, {3.0, 0.0}}};

  struct Foot {                                        // under the hip
    double forward = 0, turned = 0, down = 2 * thigh;  // [m], [rad], [m]
  };

  static double side_of(std::size_t side) { return side == 0 ? hip_to_side : -hip_to_side; }

  static Foot foot_of(const double* q) {
    return {-thigh * (std::sin(q[1]) + std::sin(q[1] + q[2])), q[0], thigh * (std::cos(q[1]) + std::cos(q[1] + q[2]))};
  }

  /// Two links of one length, and an ankle that keeps the sole level.
  static void bend(const Foot& foot, double* q) {
    const double reach = std::min(std::hypot(foot.forward, foot.down), 2 * thigh);
    const double half_knee = std::acos(reach / (2 * thigh));
    q[0] = foot.turned;
    q[1] = std::atan2(-foot.forward, foot.down) - half_knee;
    q[2] = 2 * half_knee;
    q[3] = -(q[1] + q[2]);
  }

  /// The standing foot has not moved, so the robot has. The lower one stands.
  void follow(const Angles& measured) {
    constexpr double clearly = 2e-4;  // [m] more than an encoder's steps make
    const Foot feet[2] = {foot_of(&measured[0]), foot_of(&measured[of_leg])};
    const auto in_base = [&](std::size_t side, double heading, double& x, double& y) {
      const double fx = feet[side].forward * std::cos(feet[side].turned);
      const double fy = side_of(side) + feet[side].forward * std::sin(feet[side].turned);
      x = std::cos(heading) * fx - std::sin(heading) * fy;
      y = std::sin(heading) * fx + std::cos(heading) * fy;
    };
    double x = 0, y = 0;
    if (!started_) {
      in_base(standing_, 0, standing_x_, standing_y_);
      standing_heading_ = feet[standing_].turned;
      started_ = true;
    }
    heading_ = standing_heading_ - feet[standing_].turned;
    in_base(standing_, heading_, x, y);
    x_ = standing_x_ - x;
    y_ = standing_y_ - y;
    const std::size_t other = 1 - standing_;
    if (feet[other].down < feet[standing_].down + clearly) return;
    standing_ = other;
    in_base(other, heading_, x, y);
    standing_x_ = x_ + x;
    standing_y_ = y_ + y;
    standing_heading_ = heading_ + feet[other].turned;
  }

  bool look_for_goal() {
    while (next_ < way.size() && std::hypot(way[next_][0] - x_, way[next_][1] - y_) < close) ++next_;
    return next_ == way.size();
  }

  void crouch() {
    const double share = (cycle_ + 1.0) / crouching;
    for (Foot& foot : feet_) foot.down = 2 * thigh + share * (height - 2 * thigh);
  }

  /// Where the feet go in this step is decided at its beginning.
  void begin_step() {
    from_ = feet_;
    swinging_ = 1 - swinging_;
    const std::array<double, 2> goal = way[std::min(next_, way.size() - 1)];
    const double turn = std::remainder(std::atan2(goal[1] - y_, goal[0] - x_) - heading_, 6.283185307179586);
    half_turn_ = std::clamp(0.5 * turn, -most_turn, most_turn);
    half_step_ = std::abs(turn) < 0.7 ? stride * std::cos(turn) : 0;
  }

  void walk(int cycle) {
    if (cycle == 0) begin_step();
    const double share = (cycle + 1.0) / cycles;
    for (std::size_t side = 0; side < 2; ++side) {
      const double way_on = side == swinging_ ? 1 : -1;
      feet_[side].forward = from_[side].forward + share * (way_on * half_step_ - from_[side].forward);
      feet_[side].turned = from_[side].turned + share * (way_on * half_turn_ - from_[side].turned);
      feet_[side].down = height - (side == swinging_ ? lift * std::sin(3.141592653589793 * share) : 0);
    }
  }

  std::array<Foot, 2> feet_{}, from_{};
  double x_ = 0, y_ = 0, heading_ = 0;                             // [m, m, rad]
  double standing_x_ = 0, standing_y_ = 0, standing_heading_ = 0;  // [m, m, rad]
  double half_turn_ = 0, half_step_ = 0;                           // [rad], [m] of the present step
  std::size_t standing_ = 0, swinging_ = 0, next_ = 0;
  int cycle_ = 0;
  bool started_ = false;
};
