/// session_requests.h - what the viewer has asked of its session and waits for, and what it tells people of the answers.
#pragma once

#include <chrono>
#include <deque>
#include <future>
#include <map>
#include <string>
#include <vector>

#include "murosimf/session/session.h"

namespace murosimf::viewer {

/// What the viewer tells people.
struct Message {
  std::string text;
  bool error = false;
  std::chrono::steady_clock::time_point when = std::chrono::steady_clock::now();
};

/// The last ones.
class MessageLog {
 public:
  void tell(std::string text, bool error = false);
  [[nodiscard]] const std::deque<Message>& all() const noexcept { return messages_; }

 private:
  std::deque<Message> messages_;
};

class SessionRequests {
 public:
  /// Messages outlive it.
  explicit SessionRequests(MessageLog& messages) : messages_(messages) {}

  /// Answers are told when they come: `what` was done, unless `silent`; or why not.
  void ask(std::string what, std::future<void> done, bool silent = false);
  /// PATH = VALUE, of what moves continuously: only one such change is on its way at a time, and of those of one path that come meanwhile the
  /// last one is asked for.
  void move(const std::string& path, std::string value) { moves_[path] = std::move(value); }
  /// Tells the answers that have come, and asks for the next move.
  void collect(session::Session& session);

  [[nodiscard]] bool waits() const noexcept { return !asked_.empty(); }
  /// Neither is anything on its way nor to come.
  [[nodiscard]] bool settled() const noexcept { return asked_.empty() && moves_.empty(); }
  /// Of a session that is no more.
  void forget();

 private:
  struct Asked {
    std::string what;
    std::future<void> done;
    bool silent = false;
    bool moves = false;
  };

  MessageLog& messages_;
  std::vector<Asked> asked_;
  std::map<std::string, std::string> moves_;  // PATH = VALUE: that wait until the last one has been done
  bool moving_ = false;
};

/// Whether the answer has come.
[[nodiscard]] bool is_ready(const std::future<void>& done);

}  // namespace murosimf::viewer
