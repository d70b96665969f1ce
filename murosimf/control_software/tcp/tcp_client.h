/// tcp_client.h - a connected program that has named the robot it controls.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "murosimf/network/connection.h"

namespace murosimf::wire {
class FromClient;
}

namespace murosimf::control_software {

constexpr std::size_t longest_message = 65536;  // [byte] of clients

struct TcpClient {
  network::Connection connection;
  std::string robot, software, address;
  double rate = 0;  ///< [Hz] requested; 0: any

  /// "walk.py at 127.0.0.1:40312"
  [[nodiscard]] std::string name() const;
};

/// Evaluates the first message of a client. Throws NetworkError: it is no Hello of this version.
void read_hello(TcpClient& client, std::string_view message);

/// Throws NetworkError: "sends what is no message of this protocol".
void parse(std::string_view bytes, wire::FromClient& message);

/// Sends a client the reason for its refusal, if that is possible without waiting.
void refuse(network::Connection& connection, const std::string& reason) noexcept;

/// Text from others, as one line of a report: at most `longest` characters, without control characters.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest);

}  // namespace murosimf::control_software
