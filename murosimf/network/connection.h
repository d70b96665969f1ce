/// connection.h - whole messages over a socket: each is preceded by its length, 4 bytes, the most significant one first.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/network/socket.h"

namespace murosimf::network {

class Connection {
 public:
  /// Longer messages than `longest` [byte] are not received.
  Connection(Socket socket, std::size_t longest);

  [[nodiscard]] const Socket& socket() const { return socket_; }

  // Without waiting. Throw NetworkError if the connection has ended, or the peer has announced a message that is too long.

  /// Queues and sends a message; flush() sends the rest later.
  void send(std::string_view message);
  /// Sends the rest; true if nothing is left.
  bool flush();
  /// The next message, if it is complete; valid until the next call. Messages from before the end of the connection are still returned.
  [[nodiscard]] std::optional<std::string_view> receive();

  // The same, waiting until `end`; also NetworkError: "did not answer in time", "does not take what it is sent".
  void flush_until(WallTime end);
  [[nodiscard]] std::string_view receive_until(WallTime end);

 private:
  [[nodiscard]] std::optional<std::string_view> next_in_buffer();
  void fill();

  Socket socket_;
  std::size_t longest_;
  std::string outgoing_;
  std::size_t sent_ = 0;  // of outgoing_
  std::vector<char> incoming_;
  std::size_t begin_ = 0, end_ = 0;  // of the received bytes in incoming_
};

}  // namespace murosimf::network
