/// library_software.h - control software in a shared library: one instance of it, for one robot.
///
/// Every call is guarded (guard/guarded_call.h): an error in the library ends the instance and is reported with the library's name.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/control_software/control_software.h"
#include "murosimf/control_software/controller_library.h"
#include "murosimf/control_software/guard/guarded_call.h"
#include "murosimf/control_software/library_robot.h"
#include "murosimf/model/option.h"

namespace murosimf::control_software {

struct LibraryOptions {
  std::filesystem::path file;
  OptionValues options;    ///< of the instance
  std::uint64_t seed = 1;  ///< of the run
  Duration budget{};       ///< wall time that a call may take; 0: any
  bool reload = false;     ///< reloads the library when its file changes
};

/// Wall time after which a call is aborted: a second or ten budgets, whichever is longer; 10 s without a budget.
[[nodiscard]] Duration longest_call(Duration budget);

/// Serializes instances whose library shares global variables, in the order of attaching, which makes results
/// independent of threads. `common` is that of the world.
void one_after_the_other(const Setup& setup, Entity& common, const ControllerLibrary& library);

class LibrarySoftware final : public ControlSoftware {
 public:
  /// Throws SetupError: the library rejects the robot, requests what does not exist, throws, or has no such option. Throws SoftwareCrash.
  LibrarySoftware(Setup& setup, RobotPort& port, SayLine say, std::shared_ptr<const ControllerLibrary> library,
                  LibraryOptions options);
  ~LibrarySoftware() override;
  LibrarySoftware(const LibrarySoftware&) = delete;
  LibrarySoftware& operator=(const LibrarySoftware&) = delete;

  [[nodiscard]] CallOutcome start() override;
  [[nodiscard]] CallOutcome step(Duration now) noexcept override;
  [[nodiscard]] std::string news() override;
  void state(StateArchive& archive) override;
  [[nodiscard]] bool keeps_state() const override { return !library_->functions().save || !library_->functions().load; }

 private:
  using WallClock = std::chrono::steady_clock;

  [[nodiscard]] void* create(const ControllerLibrary& library);
  void destroy(const std::shared_ptr<const ControllerLibrary>& library, void*& instance);
  void give_up(const CallOutcome& outcome) noexcept;
  [[nodiscard]] CallOutcome guarded(const char* what, const std::function<void()>& call);
  [[nodiscard]] CallOutcome guarded_with(const GuardedRows& rows, const char* what, const std::function<void()>& call);
  [[nodiscard]] CallOutcome with_threads(CallOutcome outcome) noexcept;
  void must(const CallOutcome& outcome);
  [[nodiscard]] std::vector<std::byte> saved();
  [[nodiscard]] bool loaded(const ControllerLibrary& library, void* instance, const std::vector<std::byte>& bytes);
  void look_for_a_newer_one();
  void exchange();
  void begin(const ControllerLibrary& library, void* instance);

  std::shared_ptr<const ControllerLibrary> library_;
  LibraryOptions options_;
  GuardedRows* rows_;                  // of the port
  const GuardedRow* error_ = nullptr;  // that create may write to
  LibraryRobot robot_;
  std::shared_ptr<ForeignThreads> threads_;  // that the instance begins
  GuardedCall step_;
  void* instance_ = nullptr;  // null: it has ended
  bool fresh_ = true;         // it has not begun yet
  bool crashed_ = false;
  std::string crash_;       // why
  ProcessChanges changes_;  // that are not told yet
  WallClock::time_point looked_, since_;
  std::filesystem::file_time_type seen_{}, tried_{};  // of a newer file
  std::string news_;
};

}  // namespace murosimf::control_software
