#include "murosimf/catalog/controller_options.h"

#include "murosimf/dds/participant.h"

namespace murosimf::catalog {
namespace {

constexpr double longest_time = 60;     // [s]
constexpr double longest_motion = 1e9;  // [s]
constexpr double cycle = 0.005;         // [s] of AnkleStrategy: shorter filters would not be stable
constexpr double shortest_limit = 0.01, longest_limit = 86400;  // [s] of wall time
constexpr double fastest = 10;                                  // [m/s] beyond all robots
constexpr double longest_length = 100;                          // [m]

}  // namespace

/// Bounds of all tables keep numbers within what the controllers are made for.
const OptionTable<locomotion::AnkleStrategyOptions>& balance_options() {
  using Options = locomotion::AnkleStrategyOptions;
  static const OptionTable<Options> table{
      {"settle_time", &Options::settle_time, "s", "from the start until it answers", cycle, longest_time},
      {"trust_time", &Options::trust_time, "s", "in which the accelerometer corrects the gyroscope", cycle,
       longest_time},
      {"smooth_time", &Options::smooth_time, "s", "of the answer's filter", cycle, longest_time},
      {"gain", &Options::gain, "1", "turn of the soles for a turn of the capture point", 0, 10},
      {"limit", &Options::limit, "rad", "largest turn of the soles", 0, 1.5},
  };
  return table;
}

const OptionTable<control_software::TrajectoryOptions>& trajectory_options() {
  using Options = control_software::TrajectoryOptions;
  static const OptionTable<Options> table{
      {"file", &Options::file, "", "table of angles (CSV): here, beside the scene, or in a folder 'motions'"},
      {"loop", &Options::loop, "", "begins again at its end"},
      {"begin", &Options::begin, "s", "in the file, where it begins; its first time if not given", -longest_motion,
       longest_motion},
      {"delay", &Options::delay, "s", "for which it stays at 'begin' first", 0, longest_motion},
      {"between", &Options::between, "", "two rows: a straight line, or the last one", {"line", "hold"}},
      {"property", &Options::property, "", "that is played from a log"},
      {"entity", &Options::entity, "", "of a log, if it is not this one"},
  };
  return table;
}

/// Longest waits are bounded, so that a wrong number in a file does not stop a run for hours.
const OptionTable<control_software::TcpOptions>& tcp_options() {
  using Options = control_software::TcpOptions;
  static const OptionTable<Options> table{
      {"mode",
       &Options::mode,
       "",
       "lock_step: each cycle waits for the answer; free: the latest commands hold",
       {"lock_step", "free"}},
      {"limit", &Options::limit, "s", "wall time that an answer may take", shortest_limit, longest_limit},
      {"wait", &Options::wait, "s", "wall time for the software to come, and to get ready", shortest_limit,
       longest_limit},
      {"absence", &Options::absence, "s",
       "lock_step: wall time that the run stands still for other software when one has gone", 0, longest_limit},
  };
  return table;
}

const OptionTable<serial::SerialOptions>& serial_options() {
  using Options = serial::SerialOptions;
  constexpr double fastest_line = 1e7;  // [bit/s]
  static const OptionTable<Options> table{
      {"protocol", &Options::protocol, "", "of servos of the MX series and the IMU: 1 or 2", 1, 2},
      {"bus", &Options::bus, "", "table of joints and ids (CSV); not given: ids from 1 on, in the order of the joints"},
      {"baud_rate", &Options::baud_rate, "bit/s", "of all at the start; 0: 1e6, and bytes take no time", 0,
       fastest_line},
      {"torque", &Options::torque, "", "is on at the start"},
      {"imu", &Options::imu, "", "sensor that is on the bus; not given: 'imu', if there is one"},
      {"imu_id", &Options::imu_id, "", "its id", 0, serial::first_no_id - 1},
      {"imu_ping", &Options::imu_ping, "", "it answers broadcast pings"},
  };
  return table;
}

const OptionTable<dds::booster::BoosterOptions>& booster_options() {
  using Options = dds::booster::BoosterOptions;
  static const OptionTable<Options> table{
      {"domain", &Options::domain, "", "of DDS; -1: that of --booster", -1, dds::Participant::highest_domain},
      {"suffix", &Options::suffix, "", "behind the names of all topics, for several robots in a domain"},
      {"mode", &Options::mode, "", "at the start", {"damping", "prepare", "walking", "custom", "soccer"}},
      {"lock_step", &Options::lock_step, "s",
       "wall time that a cycle in custom mode waits for a command; 0: it does not", 0, longest_limit},
  };
  return table;
}

const OptionTable<dds::unitree::UnitreeOptions>& unitree_options() {
  using Options = dds::unitree::UnitreeOptions;
  static const OptionTable<Options> table{
      {"domain", &Options::domain, "", "of DDS; -1: that of --unitree", -1, dds::Participant::highest_domain},
      {"suffix", &Options::suffix, "", "behind the names of all topics, for several robots in a domain"},
      {"stands", &Options::stands, "", "until a program takes its motors; false: they are off until then"},
      {"lock_step", &Options::lock_step, "s",
       "wall time that a cycle waits for a command once a program has the motors; 0: it does not", 0, longest_limit},
  };
  return table;
}

const OptionTable<dds::ros2::RosOptions>& ros2_options() {
  using Options = dds::ros2::RosOptions;
  static const OptionTable<Options> table{
      {"walk", &Options::walk, "", "cmd_vel moves it by the motion engine; false: joints alone are commanded"},
      {"timeout", &Options::timeout, "s", "after which a cmd_vel that is not renewed is over", 0.01, longest_time},
  };
  return table;
}

const OptionTable<locomotion::DriveOptions>& drive_options() {
  using Options = locomotion::DriveOptions;
  static const OptionTable<Options> table{
      {"acceleration", &Options::acceleration, "m/s^2", "largest change of speed", 0, 100},
      {"steering", &Options::steering, "1/(m s)", "largest change of curvature", 0, 1000},
  };
  return table;
}

const OptionTable<soccer::BallChaserOptions>& ball_chaser_options() {
  using Options = soccer::BallChaserOptions;
  static const OptionTable<Options> table{
      {"speed", &Options::speed, "m/s", "forward", 0, fastest},
      {"behind_ball", &Options::behind_ball, "m", "where a push begins", 0, longest_length},
      {"detour", &Options::detour, "m", "sideways, to get around the ball", 0, longest_length},
      {"support_behind", &Options::support_behind, "m", "from the ball to where the others wait", 0, longest_length},
      {"support_aside", &Options::support_aside, "m", "the same sideways", 0, longest_length},
      {"keep_clear", &Options::keep_clear, "m", "of other robots", 0.01, longest_length},
      {"kicks", &Options::kicks, "",
       "with the robot's motions that kick, to the goal; its motion engine keeps its balance and gets up"},
  };
  return table;
}

const OptionTable<soccer::LocalizeOptions>& localize_options() {
  using Options = soccer::LocalizeOptions;
  static const OptionTable<Options> table{
      {"speed", &Options::speed, "m/s", "on its round", 0, fastest},
      {"camera", &Options::camera, "", "name of the sensor"},
  };
  return table;
}

const OptionTable<soccer::ObstacleCourseOptions>& obstacle_course_options() {
  using Options = soccer::ObstacleCourseOptions;
  static const OptionTable<Options> table{
      {"speed", &Options::speed, "m/s", "forward", 0, fastest},
      {"obstacle_radius", &Options::obstacle_radius, "m", "of the poles", 0, longest_length},
      {"robot_radius", &Options::robot_radius, "m", "of the circle around it, swaying included", 0, longest_length},
      {"clearance", &Options::clearance, "m", "besides", 0, longest_length},
      {"farthest", &Options::farthest, "m", "at which poles are looked at", 0, longest_length},
      {"look_ahead", &Options::look_ahead, "m", "on its way, to where it walks", 0.01, longest_length},
      {"camera", &Options::camera, "", "name of the sensor"},
  };
  return table;
}

}  // namespace murosimf::catalog
