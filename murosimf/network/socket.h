/// socket.h - a TCP socket that never blocks, except in functions that are documented to wait.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace murosimf::network {

/// A connection has ended, or the peer has violated the protocol. One line without the peer's name: "closed the connection".
class NetworkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Address {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0: one that is free
};

/// From "PORT", "HOST:PORT" or "[HOST]:PORT"; without a host this computer's loopback. Throws NetworkError.
[[nodiscard]] Address parse_address(std::string_view text);
/// "127.0.0.1:5000", "[::1]:5000"
[[nodiscard]] std::string to_text(const Address& address);

using WallTime = std::chrono::steady_clock::time_point;

class Socket {
 public:
  Socket() = default;
  ~Socket();
  Socket(Socket&& other) noexcept;
  Socket& operator=(Socket&& other) noexcept;

  /// Throw NetworkError: "the port is in use", "connection refused".
  [[nodiscard]] static Socket listen(const Address& address);
  [[nodiscard]] static Socket connect(const Address& address);  ///< waits, as long as the system does

  /// A socket to the next waiting connection; one that is not open if none waits. It ends if the other computer does not answer for a minute
  /// (without power, or off the network), or receives nothing of the waiting data for as long. (TCP keepalive, RFC 9293 section 3.8.4; user timeout, RFC 5482.)
  [[nodiscard]] Socket accept() const;

  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }
  /// Passes the ownership to the caller.
  [[nodiscard]] int release() noexcept { return std::exchange(number_, -1); }
  [[nodiscard]] Address own_address() const;
  [[nodiscard]] Address peer_address() const;

  // As many bytes as can be sent or have come now; 0: none. Throw NetworkError if the connection has ended.
  std::size_t send(std::span<const char> bytes) const;
  std::size_t receive(std::span<char> bytes) const;

  /// Whether the peer has closed its end, or the connection has broken; what it has sent before may still be there.
  [[nodiscard]] bool has_ended() const;
  /// Another socket of the same connection, which lasts until both are closed: to be observed from another thread.
  [[nodiscard]] Socket watcher() const;

  /// Waits until something can be received, or (`to_send`) sent. False: not until `end`.
  [[nodiscard]] bool wait(WallTime end, bool to_send = false) const;

 private:
  explicit Socket(int number) : number_(number) {}
  void close() noexcept;

  int number_ = -1;
};

}  // namespace murosimf::network
