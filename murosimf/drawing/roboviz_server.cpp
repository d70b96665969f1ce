#include "murosimf/drawing/roboviz_server.h"

#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include <fmt/format.h>

namespace murosimf::drawing {
namespace {

constexpr std::size_t longest_packet = 65536;

/// A socket for datagrams at that address.
int bound_socket(const network::Address& address) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_DGRAM;
  hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  if (getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found) != 0) {
    throw network::NetworkError(fmt::format("unknown host '{}'", address.host));
  }
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> places(found, &freeaddrinfo);
  int trouble = EADDRNOTAVAIL;
  // The first address that can be bound: a host may have one of version 6 and one of version 4.
  for (const addrinfo* place = found; place; place = place->ai_next) {
    const int number = ::socket(place->ai_family, place->ai_socktype | SOCK_CLOEXEC, place->ai_protocol);
    if (number < 0) continue;
    if (::bind(number, place->ai_addr, place->ai_addrlen) == 0) return number;
    trouble = errno;
    ::close(number);
  }
  throw network::NetworkError(
      fmt::format("{}: {}", to_text(address),
                  trouble == EADDRINUSE ? std::string("the port is in use") : std::system_category().message(trouble)));
}

std::uint16_t port_of(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  if (address.ss_family == AF_INET6) return ntohs(reinterpret_cast<const sockaddr_in6*>(&address)->sin6_port);
  return ntohs(reinterpret_cast<const sockaddr_in*>(&address)->sin_port);
}

}  // namespace

RobovizServer::RobovizServer(const network::Address& address)
    : socket_(bound_socket(address)), wake_(::eventfd(0, EFD_CLOEXEC)), address_{address.host, port_of(socket_)} {
  if (wake_ < 0) {
    ::close(socket_);
    throw network::NetworkError("the system has no more files to give");
  }
  thread_ = std::thread([this] { listen(); });
}

RobovizServer::~RobovizServer() {
  ends_ = true;
  // The thread waits in poll() without a limit: the event ends that.
  (void)::eventfd_write(wake_, 1);
  thread_.join();
  ::close(wake_);
  ::close(socket_);
}

std::shared_ptr<const ExternalDrawings> RobovizServer::shown() const {
  const std::lock_guard lock(mutex_);
  // Copied only if there is something new: observers ask in every picture.
  if (shown_->changes != drawings_.changes()) shown_ = std::make_shared<const ExternalDrawings>(drawings_.shown());
  return shown_;
}

void RobovizServer::listen() {
  std::string packet(longest_packet, '\0');
  while (!ends_) {
    std::array<pollfd, 2> asked{{{wake_, POLLIN, 0}, {socket_, POLLIN, 0}}};
    if (::poll(asked.data(), asked.size(), -1) < 0 || asked[1].revents == 0) continue;
    // One datagram per wait; poll() returns at once if more have arrived.
    const ssize_t size = ::recv(socket_, packet.data(), packet.size(), MSG_DONTWAIT);
    if (size < 0) continue;
    const std::lock_guard lock(mutex_);
    if (!drawings_.take(std::string_view(packet).substr(0, static_cast<std::size_t>(size)))) ++ignored_;
    ++packets_;
  }
}

}  // namespace murosimf::drawing
