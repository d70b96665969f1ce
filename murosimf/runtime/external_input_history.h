/// external_input_history.h - what has come from outside into a run that can go back in time, kept in memory: an instant that was there
/// before is answered from it, and external programs are asked for no instant twice.
///
/// Each robot's software, serial line, referee and team has a channel. While the run goes on live, what comes by it is written down; while
/// the run is repeated, it comes from there. The owner of the run (session/live_source.h) takes what was written
/// after each step, and says what is to be repeated. What is written are notes as those of recordings (external_input_log.h).
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/runtime/external_input_log.h"

namespace murosimf {

/// A note, and by which channel it came.
struct RememberedInput {
  std::size_t channel = 0;
  ExternalInput note;

  /// [byte] of memory, about.
  [[nodiscard]] std::size_t size() const { return sizeof(RememberedInput) + note.bytes.size(); }
};

class ExternalInputHistory {
 public:
  class Channel {
   public:
    explicit Channel(const ExternalInputHistory& memory) : memory_(&memory) {}
    /// The present instant has been recorded: its input is next(), and no external program is asked.
    [[nodiscard]] bool repeats() const { return memory_->repeats_; }
    /// Records the present input, if recording is requested.
    void write(ExternalInput::Kind kind, std::string bytes = {}) {
      if (keeps()) written_.push_back({memory_->now_, kind, std::move(bytes)});
    }
    [[nodiscard]] bool keeps() const { return memory_->keeps_ && !memory_->repeats_; }
    /// The next one of the present instant, of what is repeated; null: there is none any more.
    [[nodiscard]] const ExternalInput* next() const;
    void pass() { ++at_; }

   private:
    friend class ExternalInputHistory;
    const ExternalInputHistory* memory_;
    std::vector<ExternalInput> written_, repeated_;  // by time
    std::size_t at_ = 0;                             // of repeated_
  };

  ExternalInputHistory() = default;
  ExternalInputHistory(const ExternalInputHistory&) = delete;  // channels look into it
  ExternalInputHistory& operator=(const ExternalInputHistory&) = delete;

  /// It stays where it is, and each may be used by a thread of its own; new ones between two steps only.
  [[nodiscard]] Channel& channel(const std::string& name);

  /// Registers a source of input besides the software of robots that keeps its own history: "the GameController".
  void expect(std::string source) { others_.push_back(std::move(source)); }
  [[nodiscard]] const std::vector<std::string>& others() const { return others_; }

  // ---- for the owner of the run, between two steps ----

  /// Starts recording; initially nothing is recorded.
  void keep() { keeps_ = true; }
  /// The instant of all that comes next.
  void at(Duration now) { now_ = now; }
  /// Moves out what was written since the last call, by channel.
  [[nodiscard]] std::vector<RememberedInput> take();
  /// Until live(), this comes again. By time within each channel.
  void repeat(std::vector<RememberedInput> notes);
  void live();

 private:
  std::deque<Channel> channels_;
  std::map<std::string, std::size_t, std::less<>> names_;
  std::vector<std::string> others_;
  bool keeps_ = false, repeats_ = false;
  Duration now_{};
};

}  // namespace murosimf
