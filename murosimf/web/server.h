/// server.h - HTTP and WebSocket on one port, in a thread of its own (libwebsockets).
///
///     web::Server server({.address = {"127.0.0.1", 8080}, .protocols = {{"own.v1", [] { return std::make_unique<Own>(); }}}, ...});
///
/// A client that violates the protocol, or does not read its answers, is disconnected; other clients are not affected.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/network/socket.h"
#include "murosimf/web/entry.h"
#include "murosimf/web/outbox.h"

namespace murosimf::web {

/// A client has violated the protocol: it receives the reason, and is disconnected.
class ClientError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The server's side of one WebSocket. All calls in the server's thread.
class Conversation {
 public:
  virtual ~Conversation() = default;
  /// A complete message. May throw ClientError.
  virtual void receive(std::string_view message, bool binary) = 0;
  /// About once in Server::Options::period: puts news into the outbox.
  virtual void look() = 0;

  Outbox outbox;
};

/// Answer to a GET.
struct Answer {
  std::string_view bytes;  ///< memory of the caller
  std::string type;        ///< "text/html; charset=utf-8"
  bool gzip = false;       ///< bytes are compressed
};

class Server {
 public:
  struct Options {
    network::Address address;
    std::string token;  ///< for clients on other computers, and for pages of other servers
    /// By name, as in Sec-WebSocket-Protocol.
    std::vector<std::pair<std::string, std::function<std::unique_ptr<Conversation>()>>> protocols;
    std::vector<std::pair<std::string, Answer>> pages;  ///< by path: "/"
    std::function<void()> look = {};                    ///< called before that of the conversations, even without any
    std::chrono::milliseconds period{16};
  };

  /// Throws SetupError: the port is in use, no such host, this build has no server.
  explicit Server(Options options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] const network::Address& address() const;
  /// Number of open WebSockets; from any thread.
  [[nodiscard]] int clients() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

inline constexpr std::size_t longest_message = 1 << 20;  ///< [byte] of a client's message
inline constexpr std::size_t most_waiting = 64 << 20;    ///< [byte] of unread answers of a client
inline constexpr int most_clients = 64;

}  // namespace murosimf::web
