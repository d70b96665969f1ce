/// game_log.h - external input of a run, with its instants, so that the run can be repeated: a file of lines.
///
///     MuRoSimF game log 1
///     2500000000 game 52476d65...
///     2612000000 team:blue 48656c6c6f
///
/// Each line has the simulated time [ns], the source, and the bytes of the datagram as hexadecimal digits.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/league/datagrams.h"
#include "murosimf/runtime/external_input_history.h"
#include "murosimf/runtime/external_input_log.h"

namespace murosimf::league {

class GameLog {
 public:
  struct Entry {
    Duration time{};
    std::string bytes;
    friend bool operator==(const Entry&, const Entry&) = default;
  };

  /// Throws SetupError with file:line: no such log, lines that are malformed or go back in time.
  [[nodiscard]] static GameLog read(const std::filesystem::path& file);
  /// From its text; `name` is for messages.
  [[nodiscard]] static GameLog parse(std::string_view text, const std::string& name);

  /// Notes of a recording about games and teams.
  [[nodiscard]] static GameLog of(const ExternalInputLog& notes);

  /// Ordered by time; empty for an unknown channel. Addresses of channels are stable: each may be written by a thread of its own.
  [[nodiscard]] std::vector<Entry>& channel(const std::string& name) { return channels_[name]; }
  [[nodiscard]] std::string to_text() const;

 private:
  std::map<std::string, std::vector<Entry>> channels_;
};

/// Datagrams of another source, logged.
class RecordedDatagrams final : public Datagrams {
 public:
  /// All must outlive it.
  RecordedDatagrams(Datagrams& source, GameLog& log, const std::string& channel)
      : source_(&source), entries_(&log.channel(channel)) {}
  [[nodiscard]] std::vector<std::string> take(Duration now) override;
  void give(std::string_view bytes) override { source_->give(bytes); }

 private:
  Datagrams* source_;
  std::vector<GameLog::Entry>* entries_;
  Duration last_{-1};  // of take()
};

/// Datagrams of another source, logged in a recording.
class NotedDatagrams final : public Datagrams {
 public:
  /// All must outlive it.
  NotedDatagrams(Datagrams& source, ExternalInputLog::Channel& notes) : source_(&source), notes_(&notes) {}
  [[nodiscard]] std::vector<std::string> take(Duration now) override;
  void give(std::string_view bytes) override { source_->give(bytes); }

 private:
  Datagrams* source_;
  ExternalInputLog::Channel* notes_;
};

/// Datagrams of another source, which is not asked again for a repeated instant, and receives nothing from it.
class RememberedDatagrams final : public Datagrams {
 public:
  /// All must outlive it.
  RememberedDatagrams(Datagrams& source, ExternalInputHistory::Channel& memory) : source_(&source), memory_(&memory) {}
  [[nodiscard]] std::vector<std::string> take(Duration now) override;
  void give(std::string_view bytes) override {
    if (!memory_->repeats()) source_->give(bytes);
  }

 private:
  Datagrams* source_;
  ExternalInputHistory::Channel* memory_;
};

/// Datagrams of a log; those given are dropped. Stateless, so a run may jump in time.
class RepeatedDatagrams final : public Datagrams {
 public:
  /// `period`: between two times of take().
  RepeatedDatagrams(GameLog& log, const std::string& channel, Duration period)
      : entries_(log.channel(channel)), period_(period) {}
  [[nodiscard]] std::vector<std::string> take(Duration now) override;
  void give(std::string_view) override {}

 private:
  std::vector<GameLog::Entry> entries_;
  Duration period_;
};

}  // namespace murosimf::league
