/// controller_task.h - algorithm: runs control software at its rate, between the sensors and the motion of its robot.
///
/// In each cycle it publishes the robot's signals, calls the software, applies its commands and records the duration. Software that throws
/// or does not return ends, and the robot keeps its last commands; other software continues. Software that crashes ends the run.
///
/// When an instant is repeated (external_input_history.h), software with private state is not called again: the recorded effects of its
/// earlier call are applied instead.
#pragma once

#include <memory>

#include "murosimf/control_software/control_software.h"
#include "murosimf/control_software/crash_note.h"
#include "murosimf/control_software/software_report.h"
#include "murosimf/runtime/external_input_history.h"
#include "murosimf/world/algorithm.h"

namespace murosimf::control_software {

struct ControllerTaskOptions {
  std::string software;                               ///< what reports call it
  Duration budget{};                                  ///< wall time that a call may take; 0: any
  std::shared_ptr<CrashNote> crashes = {};            ///< null: crashes are not recorded
  ControlLinkOptions link{};                          ///< between the robot and the software
  std::uint64_t seed = 1;                             ///< of the link's random numbers
  std::shared_ptr<ExternalInputHistory> memory = {};  ///< where its calls are written down; null: nowhere
  Phase phase = Phase::control;                       ///< in which it is called
};

class ControllerTask final : public Algorithm {
 public:
  /// Throws what `make` throws.
  ControllerTask(Setup& setup, const SoftwareMaker& make, ControllerTaskOptions options);

  [[nodiscard]] Phase phase() const noexcept override { return options_.phase; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;
  void state(StateArchive& archive) override;
  void reseed(std::uint64_t seed) override {
    port_.reseed(seed);
    software_->reseed(seed);
  }

  [[nodiscard]] const RobotPort& port() const { return port_; }
  [[nodiscard]] RobotPort& port() { return port_; }

 private:
  template <class Call>
  [[nodiscard]] CallOutcome noted(ExternalInput::Kind kind, const Call& call);
  [[nodiscard]] bool repeats() const;
  [[nodiscard]] bool repeat_call(ExternalInput::Kind kind);
  void begin();
  void publish_news();
  void end(const CallOutcome& outcome);
  [[noreturn]] void refuse(const CallOutcome& outcome);
  void take_over_commands();
  void count_messages();
  void count_link();

  ControllerTaskOptions options_;
  const Entity* robot_;
  RobotPort port_;
  SoftwareInterface& interface_;
  SoftwareReport report_;
  Duration now_{};                                   // of the step that is being made, for messages
  ExternalInputHistory::Channel* memory_ = nullptr;  // null: time does not jump, or the software repeats itself
  bool over_ = false;                                // it has ended for good
  bool jumped_ = false;                              // a state was loaded since the last call
  std::unique_ptr<ControlSoftware> software_;
};

/// Report of an entity's software; null: the entity has none.
[[nodiscard]] const SoftwareReport* software_report(const Entity& entity);

}  // namespace murosimf::control_software
