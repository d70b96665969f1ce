/// software_report.h - report on control software after a run: calls, deadlines, refused commands, and its output lines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/control_software/guard/process_change.h"
#include "murosimf/control_software/link_options.h"
#include "murosimf/control_software/message_box.h"
#include "murosimf/model/property.h"
#include "murosimf/model/value.h"
#include "murosimf/world/state_archive.h"
#include "murosimf/world/time.h"

namespace murosimf::control_software {

struct SoftwareReport {
  struct Message {
    Duration time{};  ///< simulated
    std::string text;
  };

  /// A property of the process or thread that it has changed (process_change.h) and that was restored.
  struct Changed {
    std::string what;         ///< "the rounding mode"
    std::uint64_t times = 0;  ///< calls
    Duration first{};         ///< simulated
  };

  struct LinkReport {
    LinkCounts signals, commands;
  };

  std::string software;       ///< "build/libwalk.so"
  double rate_hz = 0;         ///< of its steps
  std::int64_t calls = 0;     ///< of its step
  Duration spent{}, worst{};  ///< wall time of these calls together, and of the longest
  Duration worst_at{};        ///< simulated time of that one
  Duration budget{};          ///< wall time that a call may take; 0: any
  std::int64_t over_budget = 0;
  std::uint64_t refused = 0;              ///< numbers of commands
  std::string first_refusal;              ///< with its time
  std::optional<MessageCounts> messages;  ///< to and from its team; nothing: it has not asked for them
  std::string first_refused_message;      ///< with its time
  std::optional<LinkReport> link;         ///< what has gone over it; nothing: there is none
  std::vector<Changed> changed;           ///< each of them once
  std::string ended;                      ///< reason why it no longer runs; empty: it runs
  bool keeps_state = false;               ///< it has state outside of the states of the run: no save and load
  std::vector<Message> said;              ///< at most most_messages
  std::uint64_t not_kept = 0;             ///< messages after these

  static constexpr std::size_t most_messages = 100;

  /// A call of its step that took this wall time, at the simulated time `now`.
  void count(Duration took, Duration now) noexcept;
  /// Each kind of change is told once: software that changes something does so in every call.
  void note(ProcessChanges changes, Duration now);
  /// Bounded: software may write a line in every cycle.
  void say(Duration now, const std::string& line);
};

/// Points to the report of an entity's software; null: it has none.
struct SoftwareInterface {
  const SoftwareReport* report = nullptr;
};
inline void append_hash(Hasher&, const SoftwareInterface&) {}
inline void state(StateArchive&, SoftwareInterface&) {}

/// No state: wall times differ from run to run.
inline constexpr Property<SoftwareInterface> software_interface{
    {"software_interface", "-", "-", "report of the entity's control software", Scope::wiring}};

}  // namespace murosimf::control_software
