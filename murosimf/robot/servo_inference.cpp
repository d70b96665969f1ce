#include "murosimf/robot/servo_inference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "murosimf/component_files/servo_sections.h"
#include "murosimf/math/assert.h"
#include "murosimf/robot/robot_soles.h"
#include "murosimf/robot_formats/joint_inertia.h"

namespace murosimf::robot {
namespace {

using robot_formats::BodyDescription;
using robot_formats::JointDescription;
using robot_formats::RobotDescription;

constexpr double gravity = 9.81;           // [m/s^2]
constexpr double full_torque_bend = 0.1;   // [rad] error at which a guessed servo has its full torque
constexpr double full_force_shift = 0.02;  // [m] the same of a slider
constexpr double damping_time = 0.05;      // [s] damping over gain of a guessed servo
constexpr double shortest_step = 0.002;    // [s] steps in which joints outside the legs can be simulated in every pose
constexpr int most_joints = 1000;          // more are not bounded: that would take minutes

// Of a robot on two soles; the stiffness with which it topples is m g z_c.
constexpr double biped_share = 4;             // [1] of the gain F / 0.1 rad
constexpr double least_gain = 4;              // [1] of that stiffness, in the legs
constexpr double most_gain = 40;              // [1] the same, of all joints
constexpr double most_torque = 10;            // [1] of m g z_c
constexpr double torque_without = 0.4;        // [1] the same, of a joint without any data in the file
constexpr double rotor_without = 0.005;       // [1] of m z_c^2
constexpr double biped_damping_time = 0.025;  // [s]

constexpr double no_inertia = 1e-9;  // [kg m^2 | kg] unknown, or rounding: at a base that floats without mass

struct Weight {
  double mass = 0;    ///< [kg]
  double height = 0;  ///< [m] of the center of mass above the lowest point
  [[nodiscard]] double stiffness() const { return mass * gravity * height; }  ///< [N m/rad]
};

Weight weight_of(const RobotDescription& description) {
  const robot_formats::MassProperties robot = whole_solid(description);
  if (!(robot.mass > 0)) return {};
  return {robot.mass, robot.center.z - lowest_point(description)};
}

/// Bodies between the base and a foot, feet included.
std::set<std::size_t> bodies_of_legs(const RobotDescription& description, const std::set<std::size_t>& feet) {
  std::set<std::size_t> legs;
  for (const std::size_t foot : feet) {
    for (int body = static_cast<int>(foot); body > 0; body = description.bodies[body].parent) legs.insert(body);
    MUROSIMF_ASSERT(foot < description.bodies.size());
  }
  return legs;
}

/// [N m | N] of the drive of the joint in the file; 0: none.
double largest_torque(const JointDescription& joint) {
  if (joint.servo && joint.servo->stall_torque > 0) return joint.servo->stall_torque;
  return joint.effort_limit;
}

bool has_gain(const Servo& servo) { return servo.position_gain > 0 || servo.velocity_gain > 0; }

/// With the file's torque and rate, without gains.
Servo servo_without_gains(const JointDescription& joint) {
  Servo servo;
  servo.type = component_files::guessed_servo;
  servo.law = "ideal_pd";
  servo.stall_torque = largest_torque(joint);
  if (joint.servo) {
    servo.lowest_share = joint.servo->lowest_share;
    servo.highest_share = joint.servo->highest_share;
    servo.command_filter = joint.servo->command_filter;
  }
  servo.no_load_speed = joint.rate_limit;
  return servo;
}

double usual_gain(const JointDescription& joint, double torque) {
  return torque / (joint.kind == Kind::prismatic ? full_force_shift : full_torque_bend);
}

/// Inertias at the joints, in the order of bodies; empty if they are not computed.
std::vector<double> inertias_of(const RobotDescription& description) {
  std::size_t count = 0;
  for (const BodyDescription& body : description.bodies) count += body.joints.size();
  return count > most_joints ? std::vector<double>{} : robot_formats::free_inertias(description);
}

/// Guesses servos one by one and counts the guesses.
class Guesser {
 public:
  Guesser(RobotDescription& description, const RobotConfig& table) : description_(description), table_(table) {
    for (const robot_formats::MimicDescription& mimic : description.mimics) followers_.insert(mimic.joint);
    const std::set<std::size_t> feet = bodies_with_soles(description, table);
    if (feet.size() != 2) return;
    weight_ = weight_of(description);
    if (weight_.stiffness() > 0) legs_ = bodies_of_legs(description, feet);
  }

  void run() {
    const std::vector<double> inertias = inertias_of(description_);
    std::size_t number = 0;
    for (std::size_t i = 0; i < description_.bodies.size(); ++i) {
      for (JointDescription& joint : description_.bodies[i].joints) {
        const double inertia = number < inertias.size() ? inertias[number++] : 0;
        // Without computed inertias, 0 stands for unknown: soften() leaves such servos unchanged.
        if (!is_open(joint)) continue;
        if (largest_torque(joint) > 0) {
          give_gains(joint, legs_.contains(i), inertia);
        } else if (legs_.contains(i) && joint.kind == Kind::revolute && joint.stiffness == 0) {
          give_all(joint);
        }
      }
    }
    note();
  }

 private:
  [[nodiscard]] bool is_open(const JointDescription& joint) const {
    const bool driven = (joint.servo && has_gain(*joint.servo)) || table_.servos.contains(joint.name);
    return !driven && !followers_.contains(joint.name);
  }

  [[nodiscard]] bool stands_on_two() const { return !legs_.empty(); }

  void give_gains(JointDescription& joint, bool of_leg, double inertia) {
    Servo servo = servo_without_gains(joint);
    servo.position_gain = usual_gain(joint, servo.stall_torque);
    MUROSIMF_ASSERT(servo.stall_torque > 0);
    servo.velocity_gain = damping_time * servo.position_gain;
    if (stands_on_two() && joint.kind == Kind::revolute) stiffen(joint, of_leg, servo);
    if (!of_leg) soften(inertia, servo);
    joint.servo = servo;
    ++gains_;
  }

  void stiffen(const JointDescription& joint, bool of_leg, Servo& servo) {
    const double topples = weight_.stiffness();
    MUROSIMF_ASSERT(topples > 0);
    if (servo.stall_torque > most_torque * topples) {
      absurd_.push_back(fmt::format("'{}' {:g}", joint.name, servo.stall_torque));
      servo.stall_torque = most_torque * topples;
    }
    const double wanted = biped_share * usual_gain(joint, servo.stall_torque);
    servo.position_gain = std::min(std::max(wanted, of_leg ? least_gain * topples : 0.0), most_gain * topples);
    servo.velocity_gain = biped_damping_time * servo.position_gain;
  }

  /// Stiffer servos oscillate and grow: a step of semi-implicit Euler is stable up to k = 4 I / dt^2, and the inertia changes with the pose. A
  /// leg's joint moves more than its foot, when that stands.
  void soften(double inertia, Servo& servo) {
    const double most = inertia / (shortest_step * shortest_step);
    if (servo.position_gain <= most || inertia < no_inertia) return;
    servo.velocity_gain *= most / servo.position_gain;
    servo.position_gain = most;
    ++softened_;
  }

  /// The file has no drive of the joint, and a robot cannot stand on a leg without one.
  void give_all(JointDescription& joint) {
    Servo servo = servo_without_gains(joint);
    MUROSIMF_ASSERT(weight_.stiffness() > 0);
    servo.stall_torque = torque_without * weight_.stiffness();
    servo.position_gain = least_gain * weight_.stiffness();
    servo.velocity_gain = biped_damping_time * servo.position_gain;
    joint.servo = servo;
    joint.armature = std::max(joint.armature, rotor_without * weight_.mass * weight_.height * weight_.height);
    ++whole_;
  }

  void note() const {
    std::vector<std::string>& notes = description_.notes;
    const std::string& where = description_.bodies[0].where;
    if (gains_ > 0 && !stands_on_two()) {
      notes.push_back(
          fmt::format("{}: guessed: position gains of {} servos, all torque at {} rad, all force at {} m; the "
                      "file has only their largest torques",
                      where, gains_, full_torque_bend, full_force_shift));
    }
    if (gains_ > 0 && stands_on_two()) {
      notes.push_back(
          fmt::format("{}: guessed: position gains of {} servos, all torque at {} rad, in the legs at least "
                      "{:.4g} N m/rad, anywhere at most {:.4g}; the file has only their largest torques",
                      where, gains_, full_torque_bend / biped_share, least_gain * weight_.stiffness(),
                      most_gain * weight_.stiffness()));
    }
    if (softened_ > 0) {
      notes.push_back(
          fmt::format("{}: guessed: {} of these gains are as large as what moves at their joints lets steps of {} s be",
                      where, softened_, shortest_step));
    }
    if (whole_ > 0) {
      notes.push_back(
          fmt::format("{}: guessed: {} servos in the legs of which the file says nothing: {:.4g} N m, {:.4g} "
                      "N m/rad",
                      where, whole_, torque_without * weight_.stiffness(), least_gain * weight_.stiffness()));
    }
    if (!absurd_.empty()) {
      notes.push_back(fmt::format("{}: largest torques that no joint of this robot needs are taken as {:.4g} N m: {}{}",
                                  where, most_torque * weight_.stiffness(), absurd_.front(),
                                  absurd_.size() > 1 ? fmt::format(" and {} more", absurd_.size() - 1) : ""));
    }
  }

  RobotDescription& description_;
  const RobotConfig& table_;
  std::set<std::string> followers_;
  Weight weight_;
  std::set<std::size_t> legs_;  ///< empty: not a robot on two soles
  int gains_ = 0, softened_ = 0, whole_ = 0;
  std::vector<std::string> absurd_;  ///< joints with their torques
};

}  // namespace

void guess_servos(RobotDescription& description, const RobotConfig& table) { Guesser(description, table).run(); }

}  // namespace murosimf::robot
