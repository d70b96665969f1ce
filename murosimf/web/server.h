/// server.h - HTTP and WebSocket on one port, in a thread of its own (libwebsockets).
///
///     web::Server server({.address = {"127.0.0.1", 8080}, .protocols = {{"own.v1", [] { return std::make_unique<Own>(); }}}, ...});
///
/// A client that says what it must not, or takes nothing of what it has to be sent, loses its connection; nobody else notices.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/web/entry.h"
#include "murosimf/web/outbox.h"
#include "murosimf/wire/socket.h"

namespace murosimf::web {

/// A client has said what it must not: it is told why, and its connection ends.
class ClientError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The server's side of one WebSocket. All in the server's thread.
class Conversation {
 public:
  virtual ~Conversation() = default;
  /// A whole message has come. May throw ClientError.
  virtual void receive(std::string_view message, bool binary) = 0;
  /// About once in Server::Options::period: what is new goes into the outbox.
  virtual void look() = 0;

  Outbox outbox;
};

/// What a GET is answered.
struct Answer {
  std::string_view bytes;  ///< stay the owner's
  std::string type;        ///< "text/html; charset=utf-8"
  bool gzip = false;       ///< bytes are compressed
};

class Server {
 public:
  struct Options {
    wire::Address address;
    std::string token;  ///< for who is not on this computer, and for pages from elsewhere
    /// By name, as in Sec-WebSocket-Protocol.
    std::vector<std::pair<std::string, std::function<std::unique_ptr<Conversation>()>>> protocols;
    std::vector<std::pair<std::string, Answer>> pages;  ///< by path: "/"
    std::function<void()> look = {};                    ///< before that of the conversations, which may be none
    std::chrono::milliseconds period{16};
  };

  /// Throws SetupError: the port is in use, no such host, this build has no server.
  explicit Server(Options options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] const wire::Address& address() const;
  /// Of open WebSockets; from any thread.
  [[nodiscard]] int clients() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

inline constexpr std::size_t longest_message = 1 << 20;  ///< [byte] that a client may send
inline constexpr std::size_t most_waiting = 64 << 20;    ///< [byte] of answers that a client leaves unread
inline constexpr int most_clients = 64;

}  // namespace murosimf::web
