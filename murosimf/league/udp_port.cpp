#include "murosimf/league/udp_port.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::league {
namespace {

constexpr std::size_t longest_datagram = 65536;

sockaddr_in socket_address(std::uint32_t host, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = host;
  address.sin_port = htons(port);
  return address;
}

std::uint32_t host_of(const UdpAddress& address) {
  in_addr host{};
  if (inet_pton(AF_INET, address.host.c_str(), &host) != 1) {
    throw SetupError(fmt::format("'{}' is no address of a machine; write four numbers, like 127.0.0.1", address.host));
  }
  return host.s_addr;
}

const sockaddr* generic(const sockaddr_in& address) { return reinterpret_cast<const sockaddr*>(&address); }

}  // namespace

UdpAddress UdpAddress::parse(std::string_view text) {
  UdpAddress address;
  const auto colon = text.rfind(':');
  if (colon != std::string_view::npos) address.host = text.substr(0, colon);
  const std::string_view port = text.substr(colon == std::string_view::npos ? 0 : colon + 1);
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (error != std::errc{} || end != port.data() + port.size()) {
    throw SetupError(
        fmt::format("'{}' is no place for datagrams; write PORT or HOST:PORT, like 127.0.0.1:{}", text, 3838));
  }
  (void)host_of(address);
  return address;
}

UdpPort::UdpPort(const Options& options)
    : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)), answer_port_(options.answer_port) {
  const auto fail = [&] {
    const std::string why = std::strerror(errno);
    if (socket_ >= 0) ::close(socket_);
    throw SetupError(fmt::format("no datagrams at {}:{}: {}", options.listen.host, options.listen.port, why));
  };
  const sockaddr_in address = socket_address(host_of(options.listen), options.listen.port);
  // A broadcast reaches every program of a machine with the same port; a datagram to one address only one of them: hence sharing
  // for broadcasts only.
  const int shared = host_of(options.listen) == INADDR_ANY && options.listen.port != 0 ? 1 : 0;
  (void)setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &shared, sizeof shared);
  if (socket_ < 0 || bind(socket_, generic(address), sizeof address) != 0) fail();
  const int yes = 1;
  (void)setsockopt(socket_, SOL_SOCKET, SO_BROADCAST, &yes, sizeof yes);
  if (options.send_to) {
    to_host_ = host_of(*options.send_to);
    to_port_ = options.send_to->port;
  }
}

UdpPort::~UdpPort() { ::close(socket_); }

std::uint16_t UdpPort::port() const {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  (void)getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

/// Bounded, so that a flood of datagrams does not stop the step.
std::vector<std::string> UdpPort::take(Duration) {
  std::vector<std::string> taken;
  std::array<char, longest_datagram> bytes;
  for (int i = 0; i < most_at_once; ++i) {
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t count = recvfrom(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (count < 0) break;
    MUROSIMF_ASSERT(static_cast<std::size_t>(count) <= bytes.size());
    taken.emplace_back(bytes.data(), static_cast<std::size_t>(count));
    if (answer_port_ == 0) continue;
    to_host_ = from.sin_addr.s_addr;
    to_port_ = answer_port_;
  }
  return taken;
}

void UdpPort::give(std::string_view bytes) {
  if (to_host_ == 0) return;
  const sockaddr_in address = socket_address(to_host_, to_port_);
  (void)sendto(socket_, bytes.data(), bytes.size(), 0, generic(address), sizeof address);
}

}  // namespace murosimf::league
