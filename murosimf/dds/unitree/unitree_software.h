/// unitree_software.h - a Unitree G1 as low-level programs know it: they read its motors and inertial sensors, and command its motors, over DDS.
///
/// In every cycle, 500 per simulated second, messages that have arrived are taken and answered, then the robot's state is sent and its joints are
/// commanded. The robot stands by the motion engine (locomotion/motion_engine.h) until a program releases its motors (motion_switcher.h) or commands
/// them (dds/low_level.h). Messages are written down with the step that takes them, so that a recorded run is repeated without the program.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/control_software/control_software.h"
#include "murosimf/dds/command_wait.h"
#include "murosimf/dds/external_messages.h"
#include "murosimf/dds/imu_sensing.h"
#include "murosimf/dds/joint_sensing.h"
#include "murosimf/dds/low_level.h"
#include "murosimf/dds/said_once.h"
#include "murosimf/dds/unitree/low_messages.h"
#include "murosimf/dds/unitree/unitree_link.h"
#include "murosimf/dds/unitree/unitree_options.h"

namespace murosimf::dds::unitree {

class UnitreeSoftware final : public control_software::ControlSoftware {
 public:
  /// Without `domain`, or if input is repeated, there is no DDS. Throws SetupError.
  UnitreeSoftware(Setup& setup, control_software::RobotPort& port, control_software::SayLine say,
                  const UnitreeOptions& options, std::optional<int> domain, const ExternalInputOptions& outside = {});

  [[nodiscard]] control_software::CallOutcome start() override;
  [[nodiscard]] control_software::CallOutcome step(Duration now) noexcept override;
  void state(StateArchive& archive) override;
  [[nodiscard]] bool repeats_itself() const override { return true; }

  static constexpr double rate_hz = 500;

 private:
  void take(const Arrival& arrival);
  void take_low_command(const LowCommand& command);
  void answer(const Request& request);
  void command();
  void command_joint(std::size_t joint);
  void send(Duration now);
  void wait_for_command();

  control_software::SayLine say_;
  bool stands_first_;
  std::vector<std::size_t> places_;
  std::vector<int> objects_;        // of the model, by motor
  std::span<const double> target_;  // [rad] of all joints, by object
  LowLevel low_level_;
  JointSensing joints_;
  ImuSensing pelvis_;
  std::optional<ImuSensing> torso_;    // nothing: it has no second sensor
  std::unique_ptr<UnitreeLink> link_;  // null: nothing is sent
  ExternalMessages outside_;
  CommandWait command_wait_;
  CdrWriter message_;
  bool stands_;                         // the motion engine has the motors
  std::vector<double> held_;            // [rad] by motor: where they are until they are commanded
  std::vector<MotorCommand> commands_;  // the last low-level command; empty: none since the motors were released
  std::uint64_t cycle_ = 0;
  SaidOnce crc_, cranks_, garbage_, numbers_;
};

}  // namespace murosimf::dds::unitree
