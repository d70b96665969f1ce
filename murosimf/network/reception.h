/// reception.h - accepts connections in its own thread, until each has sent its first message.
///
/// Callers that send nothing for too long, or that the door rejects, receive one line and are disconnected. There are never more of them
/// than most_strangers, and the thread waits for none of them.
#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <string>
#include <string_view>
#include <thread>

#include "murosimf/network/connection.h"

namespace murosimf::network {

/// A connected peer.
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
  /// Both are called by the thread. `admit` receives the first message; it takes the connection, or throws NetworkError, which rejects the
  /// caller ("speaks another version").
  struct Door {
    std::function<void(Caller& caller, std::string_view message)> admit;
    std::function<void(Caller& caller, const std::string& reason)> turn_away;  ///< "it closed the connection"
  };
  /// Throws NetworkError if the address cannot be listened at ("the port is in use").
  Reception(const ReceptionOptions& options, Door door);
  ~Reception();
  Reception(const Reception&) = delete;
  Reception& operator=(const Reception&) = delete;

  [[nodiscard]] Address address() const { return listener_.own_address(); }

  static constexpr std::size_t most_strangers = 64;

 private:
  struct Stranger {
    Caller caller;
    WallTime end;  // by which its first message must arrive
  };
  void receive_all();
  void accept_all(WallTime now);
  [[nodiscard]] bool inspect(Stranger& stranger, WallTime now) const;

  ReceptionOptions options_;
  Door door_;
  Socket listener_;
  int wake_ = -1;                  // event that ends the thread's waiting
  std::list<Stranger> strangers_;  // the thread's own
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace murosimf::network
