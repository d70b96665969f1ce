#include "murosimf/network/socket.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <charconv>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace murosimf::network {
namespace {

constexpr int waiting_connections = 128;                           // kept by the system until they are accepted
constexpr int silent = 30, between_questions = 10, questions = 3;  // [s], [s], [1] until a silent computer is gone
constexpr int receive_buffer = 256 * 1024;  // [byte] of a socket: unread bytes that a client may send

using Addresses = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

Addresses resolve(const Address& address, bool to_listen) {
  // Both versions of the protocol.
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_NUMERICSERV | (to_listen ? AI_PASSIVE : 0);
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found);
  if (error != 0) throw NetworkError(fmt::format("no host '{}': {}", address.host, ::gai_strerror(error)));
  return {found, &::freeaddrinfo};
}

std::string reason(int error) {
  switch (error) {
    case EADDRINUSE: return "the port is in use";
    case ECONNREFUSED: return "connection refused";
    case ECONNRESET:
    case EPIPE: return "closed the connection";
    case ETIMEDOUT: return "does not answer any more";
    default: return std::generic_category().message(error);
  }
}

void set_option(int socket, int level, int option, int value) {
  assert(socket >= 0);
  (void)::setsockopt(socket, level, option, &value, sizeof value);  // an optimization: errors are ignored
}

/// Enables keepalive: a computer without power, or behind an unplugged cable, closes no connection.
void expect_life(int socket) {
  set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, silent);
  set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, between_questions);
  set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, questions);
  set_option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, 1000 * (silent + questions * between_questions));
}

bool would_wait(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

template <class AskSystem>
Address address_of(int socket, const AskSystem& ask) {
  sockaddr_storage storage{};
  socklen_t length = sizeof storage;
  char host[NI_MAXHOST]{}, port[NI_MAXSERV]{};
  auto* const address = reinterpret_cast<sockaddr*>(&storage);
  if (ask(socket, address, &length) != 0 ||
      ::getnameinfo(address, length, host, sizeof host, port, sizeof port, NI_NUMERICHOST | NI_NUMERICSERV) != 0) {
    return {"?", 0};
  }
  return {host, static_cast<std::uint16_t>(std::stoi(port))};
}

}  // namespace

Address parse_address(std::string_view text) {
  Address address;
  std::string_view port = text;
  // The last colon separates the port: addresses of version 6 contain colons as well.
  if (const std::size_t colon = text.rfind(':'); colon != std::string_view::npos) {
    std::string_view host = text.substr(0, colon);
    port = text.substr(colon + 1);
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
    address.host = host;
  }
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (port.empty() || address.host.empty() || error != std::errc{} || end != port.data() + port.size()) {
    throw NetworkError(fmt::format("'{}' is no PORT or HOST:PORT", text));
  }
  return address;
}

std::string to_text(const Address& address) {
  const bool colons = address.host.find(':') != std::string::npos;
  return fmt::format(fmt::runtime(colons ? "[{}]:{}" : "{}:{}"), address.host, address.port);
}

Socket::~Socket() { close(); }

Socket::Socket(Socket&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Socket& Socket::operator=(Socket&& other) noexcept {
  if (this == &other) return *this;
  close();
  number_ = std::exchange(other.number_, -1);
  return *this;
}

void Socket::close() noexcept {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

Socket Socket::listen(const Address& address) {
  const Addresses found = resolve(address, true);
  int error = 0;
  for (const bool version_4 : {true, false}) {  // "localhost" has both, and clients look for 127.0.0.1 first
    for (const addrinfo* one = found.get(); one; one = one->ai_next) {
      if ((one->ai_family == AF_INET) != version_4) continue;
      Socket socket(::socket(one->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
      if (socket.is_open()) {
        set_option(socket.number_, SOL_SOCKET, SO_REUSEADDR, 1);
        set_option(socket.number_, SOL_SOCKET, SO_RCVBUF, receive_buffer);
        const bool bound = ::bind(socket.number_, one->ai_addr, one->ai_addrlen) == 0;
        if (bound && ::listen(socket.number_, waiting_connections) == 0) return socket;
      }
      if (error == 0) error = errno;
    }
  }
  throw NetworkError(reason(error));
}

Socket Socket::connect(const Address& address) {
  const Addresses found = resolve(address, false);
  int error = 0;
  for (const addrinfo* one = found.get(); one; one = one->ai_next) {
    Socket socket(::socket(one->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
    if (socket.is_open() && ::connect(socket.number_, one->ai_addr, one->ai_addrlen) == 0) {
      // Connecting blocks, everything later does not.
      (void)::fcntl(socket.number_, F_SETFL, ::fcntl(socket.number_, F_GETFL) | O_NONBLOCK);
      set_option(socket.number_, IPPROTO_TCP, TCP_NODELAY, 1);
      return socket;
    }
    error = errno;
  }
  throw NetworkError(reason(error));
}

Socket Socket::accept() const {
  Socket socket(::accept4(number_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (!socket.is_open()) return socket;
  set_option(socket.number_, IPPROTO_TCP, TCP_NODELAY, 1);
  expect_life(socket.number_);
  return socket;
}

Address Socket::own_address() const { return address_of(number_, ::getsockname); }
Address Socket::peer_address() const { return address_of(number_, ::getpeername); }

std::size_t Socket::send(std::span<const char> bytes) const {
  const ssize_t sent = ::send(number_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (sent >= 0) return static_cast<std::size_t>(sent);
  if (would_wait(errno)) return 0;
  throw NetworkError(reason(errno));
}

std::size_t Socket::receive(std::span<char> bytes) const {
  assert(!bytes.empty());
  const ssize_t received = ::recv(number_, bytes.data(), bytes.size(), 0);
  if (received > 0) return static_cast<std::size_t>(received);
  if (received < 0 && would_wait(errno)) return 0;
  throw NetworkError(reason(received == 0 ? ECONNRESET : errno));
}

bool Socket::has_ended() const {
  pollfd asked{number_, POLLRDHUP, 0};
  return ::poll(&asked, 1, 0) > 0;
}

Socket Socket::watcher() const { return Socket(::fcntl(number_, F_DUPFD_CLOEXEC, 0)); }

bool Socket::wait(WallTime end, bool to_send) const {
  using namespace std::chrono;
  for (;;) {
    // Rounded up: the last wait must not spin.
    const auto left = std::max(0LL, static_cast<long long>(ceil<milliseconds>(end - steady_clock::now()).count()));
    pollfd asked{number_, static_cast<short>(to_send ? POLLOUT : POLLIN), 0};
    const int ready = ::poll(&asked, 1, static_cast<int>(std::min(left, 1'000'000LL)));
    if (ready > 0) return true;
    if (left == 0) return false;
  }
}

}  // namespace murosimf::network
