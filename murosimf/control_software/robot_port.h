/// robot_port.h - signals and commands of one robot for its control software: rows of numbers, by name at set-up, by pointer in
/// the loop. The same for software in shared libraries, behind sockets and at serial lines.
///
/// To read (murosimf_signal):
///     SENSOR.OUTPUT        the last sample that has arrived, with the instant at which it was taken: imu.gyroscope
///     joint.position       [rad | m] of all joints as their bus reports it now: in whole steps of the servo's encoder
///     joint.velocity       [rad/s | m/s] likewise
///     joint.torque         [N m | N] of servo and gear; NaN at levels that have none
///     motion.mode          state of the motion engine: 0 stands, 1 walks, 2 plays, 3 dives, 4 falls, 5 protects itself, 6 lies, 7 gets up
///     motion.phase         [1] of each motion of the robot's file, by its name: completed share; -1: not playing
///     motion.odometry      [m, m, rad] x, y, heading: the robot's own estimate of its pose, in its frame at the start
///     motion.fallen        1: it lies or gets up, or the torso leans over 60 degrees as the robot's own sensors say; else 0
///     game.state, ...      last message of the referee (game_view.h); of a robot in a game
/// To set (murosimf_command), zero until set; numbers that are not finite or out of range are refused and counted:
///     joint.target         [rad | m] of all joints, within their ranges
///     joint.velocity_target [rad/s | m/s] of all joints: what wheels follow; of others what their velocity gain damps to, where levels have servos
///     joint.torque_enabled [1] of all joints, 0 or 1 (the start value); where levels have servos
///     joint.position_gain  [N m/rad] of all joints' servos, 0 where there is none; starts with the model's; where levels have servos
///     joint.velocity_gain  [N m s/rad] likewise
///     joint.torque_limit   [N m] likewise, of the motor; starts with the stall torque, which is no limit
///     joint.feed_forward   [N m] likewise, added to what the gains give; up to the stall torque
///     joint.led            [1] brightness of the LEDs at the servos, 0 to 1
///     robot.led            [1] red, green, blue of the robot's LED, 0 to 1
///     walk.velocity        [m/s, m/s, rad/s] command of the library's walk engine, which moves the legs
///     walk.other_joints    [rad | m] targets of joints outside the legs
///     motion.velocity      [m/s, m/s, rad/s] the motion engine walks so, with feedback, and gets up when it has fallen; it moves all joints
///     motion.play          [1] of each motion of the robot's file, by its name: a change to another number than 0 has it played once
///     motion.kick          [1, rad, 1, m, m] number, direction, side, ball_x, ball_y: a change to another number than 0 has the robot kick the
///                          ball in that direction (locomotion/motion_state.h, KickRequest)
///     motion.joints        [1] of all joints: 1 (the start value): the motion engine moves it; 0: joint.target does, and nothing moves what is
///                          left of the engine's joints unless it has all of the legs
///     game.answer          [1] answer to the referee, 0 to 4 (2, alive)
/// The simulator's walk engine, its motion engine and joint.target exclude each other; reading motion.* selects the motion engine, too. Once
/// motion.joints has been requested, both the motion engine and joint.target may be, and it says at any time which of them moves a joint.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control_software/control_link_options.h"
#include "murosimf/control_software/game_signals.h"
#include "murosimf/control_software/guard/guarded_row.h"
#include "murosimf/control_software/murosimf_controller.h"
#include "murosimf/control_software/port_commands.h"
#include "murosimf/control_software/port_pictures.h"
#include "murosimf/control_software/team_radio.h"
#include "murosimf/drawing/sketch_pad.h"
#include "murosimf/sensors/reading.h"
#include "murosimf/world/drawing.h"
#include "murosimf/world/setup.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::control_software {

/// Effects of a call of control software on its robot, so that they can be repeated without the software.
struct CallNote {
  bool good = true;               ///< it returned; otherwise none of its settings apply
  std::vector<double> commands;   ///< all numbers of all commands, in the order of asking; empty: as before
  std::uint64_t received = 0;     ///< number of team messages read
  std::vector<std::string> sent;  ///< messages to the team, also those that were refused
  std::vector<DrawnGroup> drawn;  ///< including refused ones
  std::vector<double> written;    ///< besides commands (ControlSoftware::written)

  void state(StateArchive& archive) { archive(good, commands, received, sent, drawn, written); }
};

class RobotPort {
 public:
  /// Reads all sensors of the robot, which must be attached before. Signals and commands go over the link; seed: of its random numbers. Throws
  /// SetupError.
  explicit RobotPort(Setup& setup, const ControlLinkOptions& link = {}, std::uint64_t seed = 1);
  RobotPort(const RobotPort&) = delete;  // software has pointers into it
  RobotPort& operator=(const RobotPort&) = delete;

  // By name, while the robot is set up; a requested name stays valid, and can be requested again later. Throw SetupError:
  // there is nothing of that name (with the nearest), or it excludes an earlier request; a command that was not
  // requested before close().
  [[nodiscard]] const murosimf_signal* signal(std::string_view name);
  [[nodiscard]] murosimf_command* command(std::string_view name) { return commands_.find(name); }
  /// Labels of the numbers of a requested signal or command; null if it is none of them.
  [[nodiscard]] const std::vector<std::string>* labels(std::string_view name) const;

  /// Of a requested command: numbers outside are refused. Stays valid.
  [[nodiscard]] CommandRange range(std::string_view command) const { return commands_.range(command); }

  /// Of a camera, likewise (port_pictures.h).
  [[nodiscard]] const murosimf_picture* picture(std::string_view name) { return pictures_.find(name); }

  /// Messages between the robots of a team.
  [[nodiscard]] TeamRadio& radio() { return radio_; }
  [[nodiscard]] const TeamRadio& radio() const { return radio_; }

  /// Debug drawing for observers (sketch_pad.h).
  bool draw(DrawnGroup group) {
    group.time = now_;
    if (note_) note_->drawn.push_back(group);
    return pad_.draw(std::move(group));
  }

  /// Called when the algorithm is constructed: no new commands afterwards.
  void close() {
    setup_ = nullptr;
    commands_.close();
    radio_.close();
    game_.close();
    pictures_.close();
  }
  /// Whether the walk engine must be attached, after the algorithm that has this port.
  [[nodiscard]] bool walks() const { return commands_.walks(); }
  /// The same of the motion engine.
  [[nodiscard]] bool uses_motions() const { return commands_.uses_motions(); }

  /// All memory that software has pointers to.
  [[nodiscard]] GuardedRows& rows() { return rows_; }

  /// Resets all commands to their start values.
  void restart() noexcept;
  /// Before the software's step that begins at `now`: updates the signals.
  void refresh(Duration now) noexcept;
  /// After it: applies its commands, or sends them over the link. Returns the number of refused values.
  std::size_t accept(Duration now) noexcept { return commands_.accept(now); }
  /// At the start: applies the commands at once.
  void settle() noexcept { commands_.settle(); }
  /// In every tick: applies commands that have arrived over the link (command_arrival.h).
  void deliver(Duration now) noexcept { commands_.deliver(now); }
  /// Records the effects of the software from now on, until told() returns them.
  void listen();
  [[nodiscard]] CallNote told();
  /// Applies recorded effects of the software.
  void repeat(const CallNote& note) noexcept;
  /// Called when newly connected software has requested signals that are not part of the loaded state.
  void renew_requests() noexcept;

  void declare_commands(Setup& setup) const { commands_.declare(setup); }
  void reseed(std::uint64_t seed);
  /// Counts of the link; null: there is none.
  [[nodiscard]] const DelayedRows* signal_link() const { return link_ ? &*link_ : nullptr; }
  [[nodiscard]] const DelayedRows* command_link() const { return commands_.link(); }
  /// The first number that the last accept() refused: "joint.target of l_knee is 9.5, beyond -0.1 to 2.3".
  [[nodiscard]] std::string refusal() const { return commands_.refusal(); }

  void state(StateArchive& archive);

 private:
  struct Signal {
    std::string name;
    std::vector<std::string> labels;
    const sensors::Reading* reading = nullptr;   // null: of no sensor
    std::function<double(std::size_t)> measure;  // a number, where it is of no sensor
    std::vector<double> values;                  // of no sensor, and of all that has come over a link
    std::span<const double> measured{};          // of a sensor, before the link
    std::uint64_t measurements = 0;              // of no sensor, before the link
    murosimf_signal now{};                       // but where its values stand
    const GuardedRow* row = nullptr;             // as the software sees it; null: not requested
    [[nodiscard]] std::span<const double> numbers() const { return values.empty() ? measured : values; }
    bool asked = false;   // requested by the present software
    bool wanted = false;  // refreshed and sent over the link; part of the state
  };
  void add_sensor(Setup& setup, const sensors::Reading& reading);
  void add_joints(std::string name, std::span<const double> column, bool in_steps);
  void add_motions();
  void refresh(Signal& signal, Duration now) noexcept;
  void show(const Signal& signal) noexcept;
  void send_over_link(Duration now);
  void receive_over_link(Duration now) noexcept;
  [[nodiscard]] std::vector<std::string_view> signal_names() const;

  Setup* setup_;  // null: closed
  const Model* model_;
  GuardedRows rows_;
  std::deque<Signal> signals_;       // stay where they are
  std::optional<DelayedRows> link_;  // of signals; nothing: no delay
  std::vector<double> sent_;         // memory of the link
  PortCommands commands_;
  TeamRadio radio_;
  GameSignals game_;
  PortPictures pictures_;
  drawing::SketchPad pad_;
  Duration now_{};
  CallNote* note_ = nullptr;  // null: not recording
  CallNote heard_;
  RadioUse used_;
};

}  // namespace murosimf::control_software
