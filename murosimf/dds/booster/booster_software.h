/// booster_software.h - a Booster robot as the vendor's SDK knows it: the SDK, unchanged, in programs of this machine, controls the simulated robot.
///
/// In every cycle, 500 per simulated second, messages that have arrived are taken and answered, then the robot's state is sent and its joints are
/// commanded. In the modes prepare, walking and soccer the motion engine moves the robot (locomotion/motion_engine.h), in custom mode low-level commands
/// do (dds/low_level.h). Messages are written down with the step that takes them, so that a recorded run is repeated without the SDK.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/control_software/control_software.h"
#include "murosimf/dds/booster/body_frames.h"
#include "murosimf/dds/booster/booster_link.h"
#include "murosimf/dds/booster/booster_options.h"
#include "murosimf/dds/booster/head_motion.h"
#include "murosimf/dds/booster/joint_order.h"
#include "murosimf/dds/booster/motion_requests.h"
#include "murosimf/dds/booster/robot_modes.h"
#include "murosimf/dds/booster/robot_sensing.h"
#include "murosimf/dds/booster/rpc.h"
#include "murosimf/dds/booster/visual_kick.h"
#include "murosimf/dds/command_wait.h"
#include "murosimf/dds/external_messages.h"
#include "murosimf/dds/low_level.h"
#include "murosimf/dds/said_once.h"

namespace murosimf::dds::booster {

class BoosterSoftware final : public control_software::ControlSoftware {
 public:
  /// Without `domain`, or if input is repeated, there is no DDS. Throws SetupError.
  BoosterSoftware(Setup& setup, control_software::RobotPort& port, control_software::SayLine say,
                  const BoosterOptions& options, std::optional<int> domain, const ExternalInputOptions& outside = {});

  [[nodiscard]] control_software::CallOutcome start() override;
  [[nodiscard]] control_software::CallOutcome step(Duration now) noexcept override;
  void state(StateArchive& archive) override;
  [[nodiscard]] bool repeats_itself() const override { return true; }

  static constexpr double rate_hz = 500;

 private:
  void handle_requests();
  void handle_modes();
  void handle_motions();
  void handle_questions();
  RpcAnswer turn_head(const RpcParameters& given);
  RpcAnswer wave(const RpcParameters& given);
  RpcAnswer kick_what_is_seen(const RpcParameters& given);
  [[nodiscard]] RpcAnswer frame_transform(const RpcParameters& given) const;
  void take(const Arrival& arrival);
  void take_low_command(LowCommand command);
  void answer(const RpcMessage& request);
  void command();
  void command_joint(std::size_t joint);
  [[nodiscard]] bool follows_low_level(std::size_t joint) const;
  void send();
  void wait_for_command();
  [[nodiscard]] std::string robot_info() const;

  control_software::SayLine say_;
  std::string name_;
  double period_;  // [s]
  Mode first_mode_;
  PlacedJoints joints_;
  std::vector<int> objects_;        // of the model, by joint
  std::span<const double> target_;  // [rad] of all joints, by object
  LowLevel low_level_;
  RobotSensing sensing_;
  BodyFrames frames_;
  MotionRequests motions_;
  RpcHandlers handlers_;
  std::unique_ptr<BoosterLink> link_;  // null: nothing is sent
  ExternalMessages outside_;
  CommandWait command_wait_;
  CdrWriter message_;
  RobotModes modes_;
  std::vector<double> held_;            // [rad] by joint: where commands begin
  std::vector<MotorCommand> commands_;  // the last low-level command; empty: none in this mode
  HeadMotion head_;
  VisualKick visual_kick_;
  bool upper_body_ = false;  // arms follow low-level commands, whatever moves the legs
  std::uint64_t cycle_ = 0;
  SaidOnce size_, garbage_;
};

}  // namespace murosimf::dds::booster
