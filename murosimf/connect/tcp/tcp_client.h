/// tcp_client.h - a program that has said whose software it is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "murosimf/wire/connection.h"

namespace murosimf::wire {
class FromClient;
}

namespace murosimf::connect {

constexpr std::size_t longest_message = 65536;  // [byte] of clients

struct TcpClient {
  wire::Connection connection;
  std::string robot, software, address;
  double rate = 0;  ///< [Hz] wanted; 0: any

  /// "walk.py at 127.0.0.1:40312"
  [[nodiscard]] std::string name() const;
};

/// Takes over what a client has sent first. Throws WireError: it is no Hello of this version.
void read_hello(TcpClient& client, std::string_view message);

/// Throws WireError: "sends what is no message of this protocol".
void parse(std::string_view bytes, wire::FromClient& message);

/// Tells a client why it is not wanted, if it can be told without waiting.
void refuse(wire::Connection& connection, const std::string& reason) noexcept;

/// What others have sent, as one line of a report: at most `longest` characters, without control characters.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest);

}  // namespace murosimf::connect
