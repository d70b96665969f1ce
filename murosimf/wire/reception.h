/// reception.h - accepts connections in a thread of its own, until each has sent its first message.
///
/// Whoever sends nothing for too long, or what the door does not take, is turned away with one line. There are never more of them than
/// most_strangers, and none of them is waited for.
#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <string>
#include <string_view>
#include <thread>

#include "murosimf/wire/connection.h"

namespace murosimf::wire {

/// Somebody who has connected.
struct Caller {
  Connection connection;
  std::string address;  ///< "127.0.0.1:40312"
};

struct ReceptionOptions {
  Address address;
  std::size_t longest = 65536;  ///< [byte] of messages
  double hello_limit = 5;       ///< [s] of wall time in which the first message comes
};

class Reception {
 public:
  /// Both are called by the thread. `admit` has the first message; it takes the connection, or throws WireError, which turns the caller
  /// away ("speaks another version").
  struct Door {
    std::function<void(Caller& caller, std::string_view message)> admit;
    std::function<void(Caller& caller, const std::string& reason)> turn_away;  ///< "it closed the connection"
  };
  /// Throws WireError if nobody can listen there ("the port is in use").
  Reception(const ReceptionOptions& options, Door door);
  ~Reception();
  Reception(const Reception&) = delete;
  Reception& operator=(const Reception&) = delete;

  [[nodiscard]] Address address() const { return listener_.own_address(); }

  static constexpr std::size_t most_strangers = 64;

 private:
  struct Stranger {
    Caller caller;
    WallTime end;  // by which it has said who it is
  };
  void receive_all();
  void accept_all(WallTime now);
  [[nodiscard]] bool look_at(Stranger& stranger, WallTime now) const;

  ReceptionOptions options_;
  Door door_;
  Socket listener_;
  int wake_ = -1;                  // event that ends the thread's waiting
  std::list<Stranger> strangers_;  // the thread's own
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace murosimf::wire
