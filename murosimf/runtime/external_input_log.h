/// external_input_log.h - what has come into a run from outside of it, with the simulated instants at which it was taken: messages of
/// software over TCP, bytes of serial lines, datagrams of referees and teams. A run that is given it again is the same run.
///
/// Channels are "tcp:ROBOT", "serial:ROBOT", "dds:ROBOT", "game" and "team:TEAM".
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/world/time.h"

namespace murosimf {

class ExternalInputHistory;  // external_input_history.h

struct ExternalInput {
  enum Kind : std::uint8_t {
    came = 1,         ///< software or a program: its name (for TCP with the requested rate)
    asked = 2,        ///< TCP: a message of its set-up; serial line: the rate [bit/s] that its program has chosen
    began = 3,        ///< TCP, lock-step: its answer to the start
    sent = 4,         ///< a message, bytes, a datagram
    told = 5,         ///< TCP, free: it was told a cycle
    fell_silent = 6,  ///< serial line: within a packet, for so long that the servos wait for a new one
    left = 7,         ///< and why
  };
  Duration time{};  ///< before_the_run: of its set-up
  Kind kind = sent;
  std::string bytes{};

  friend bool operator==(const ExternalInput&, const ExternalInput&) = default;
};

inline constexpr Duration before_the_run{-1};

/// Whether a run that continues from a later instant needs it as well.
[[nodiscard]] constexpr bool lasts(ExternalInput::Kind kind) {
  return kind == ExternalInput::came || kind == ExternalInput::asked || kind == ExternalInput::began ||
         kind == ExternalInput::left;
}

class ExternalInputLog {
 public:
  using Channel = std::vector<ExternalInput>;

  /// By time. It stays where it is, and each may be written by a thread of its own; new ones while the scene is set up only.
  [[nodiscard]] Channel& channel(const std::string& name) { return channels_[name]; }
  /// Null: there is none.
  [[nodiscard]] const Channel* find(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] bool empty() const;
  /// Moves out all that is there, channel by channel.
  [[nodiscard]] std::vector<std::pair<std::string, ExternalInput>> take();

 private:
  std::map<std::string, Channel, std::less<>> channels_;
};

/// What a scene does with what comes from outside.
struct ExternalInputOptions {
  std::shared_ptr<ExternalInputLog> notes{};           ///< is written down there; null: nowhere
  std::shared_ptr<const ExternalInputLog> repeated{};  ///< the only source of input; null: the run is live
  std::shared_ptr<ExternalInputHistory> memory{};      ///< for going back in time; of a scene never null

  /// Of a channel; null: it is not written down.
  [[nodiscard]] ExternalInputLog::Channel* channel(const std::string& name) const {
    return notes ? &notes->channel(name) : nullptr;
  }
};

/// Writes down what comes by one channel.
class ExternalInputRecorder {
 public:
  explicit ExternalInputRecorder(ExternalInputLog::Channel* channel = nullptr) : channel_(channel) {}
  void at(Duration now) { now_ = now; }
  void write(ExternalInput::Kind kind, std::string_view bytes = {}) {
    if (channel_) channel_->push_back({now_, kind, std::string(bytes)});
  }

 private:
  ExternalInputLog::Channel* channel_;
  Duration now_ = before_the_run;
};

/// Reads a channel from one note to the next.
class ExternalInputReader {
 public:
  /// Null: there is nothing.
  explicit ExternalInputReader(const ExternalInputLog::Channel* channel) : channel_(channel) {}
  /// The next one that has come by `now`; null: there is none.
  [[nodiscard]] const ExternalInput* next(Duration now) const {
    return channel_ && at_ < channel_->size() && (*channel_)[at_].time <= now ? &(*channel_)[at_] : nullptr;
  }
  void pass() { ++at_; }
  void rewind() { at_ = 0; }

 private:
  const ExternalInputLog::Channel* channel_;
  std::size_t at_ = 0;
};

}  // namespace murosimf
