#include "murosimf/control_software/tcp/tcp_client.h"

#include <cmath>

#include <fmt/format.h>
#include <robot_protocol.pb.h>

#include "murosimf/world/rate.h"

namespace murosimf::control_software {
namespace {

constexpr unsigned protocol_version = 1;
constexpr std::size_t longest_software = 200;

}  // namespace

std::string TcpClient::name() const { return fmt::format("{} at {}", software, address); }

std::string printable(std::string_view text, std::size_t longest) {
  std::string line;
  for (const char c : text.substr(0, longest)) line += static_cast<unsigned char>(c) < ' ' || c == 0x7f ? ' ' : c;
  if (text.size() > longest) line += "...";
  return line;
}

void parse(std::string_view bytes, wire::FromClient& message) {
  const bool known = message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  if (!known || message.kind_case() == wire::FromClient::KIND_NOT_SET) {
    throw network::NetworkError("sends what is no message of this protocol");
  }
}

/// The version is compared first: other versions may have other messages.
void read_hello(TcpClient& client, std::string_view bytes) {
  wire::FromClient message;
  parse(bytes, message);
  if (!message.has_hello()) throw network::NetworkError("does not begin with a Hello");
  const wire::Hello& hello = message.hello();
  if (hello.version() != protocol_version) {
    throw network::NetworkError(
        fmt::format("speaks version {} of the protocol, this program {}", hello.version(), protocol_version));
  }
  if (hello.rate() != 0 && !(hello.rate() >= slowest_rate && hello.rate() <= fastest_rate)) {
    throw network::NetworkError(
        fmt::format("wants a rate of {} Hz, not between {} and {} Hz", hello.rate(), slowest_rate, fastest_rate));
  }
  client.robot = hello.robot();
  client.rate = hello.rate();
  client.software = hello.software().empty() ? "software" : printable(hello.software(), longest_software);
}

void refuse(network::Connection& connection, const std::string& reason) noexcept {
  try {
    wire::ToClient message;
    message.mutable_refusal()->set_reason(reason);
    connection.send(message.SerializeAsString());
  } catch (const std::exception&) {  // the client has disconnected
  }
}

}  // namespace murosimf::control_software
