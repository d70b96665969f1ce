#include "murosimf/connect/tcp_reception.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::connect {
namespace {

using namespace std::chrono_literals;
using WallClock = std::chrono::steady_clock;

constexpr std::size_t most_lines = 100;    // about clients that were refused
constexpr auto longest_pause = 500ms;      // after which limits are looked at
constexpr auto out_of_descriptors = 50ms;  // until accepting is tried again
constexpr auto ask_for_stop = 20ms;

wire::WallTime after(double s) { return WallClock::now() + from_seconds(s); }

wire::Socket listener_at(const wire::Address& address) {
  try {
    return wire::Socket::listen(address);
  } catch (const wire::WireError& error) {
    throw SetupError(fmt::format("cannot listen on {}: {}", to_text(address), error.what()));
  }
}

}  // namespace

TcpReception::TcpReception(TcpServerOptions options)
    : options_(std::move(options)), listener_(listener_at(options_.address)), wake_(::eventfd(0, EFD_CLOEXEC)) {
  if (wake_ < 0) throw SetupError("too many open files: nobody can connect");
  thread_ = std::thread([this] { receive_all(); });
}

TcpReception::~TcpReception() {
  ends_ = true;
  (void)::eventfd_write(wake_, 1);
  thread_.join();
  ::close(wake_);
}

void TcpReception::expect(std::vector<std::string> robots) {
  const std::lock_guard lock(mutex_);
  robots_.emplace(robots.begin(), robots.end());
  // those of a scene before do not count
  closed_.clear();
  std::erase_if(busy_, [&](const std::string& robot) { return !waiting_.contains(robot); });
  for (TcpClient& client : std::exchange(early_, {})) admit(std::move(client));
}

/// Why no client may come for a robot; empty: it may.
std::string TcpReception::objection(const std::string& robot) const {
  if (!robots_->contains(robot)) {
    const std::vector<std::string_view> known(robots_->begin(), robots_->end());
    return unknown_name("robot with the controller 'tcp'", printable(robot, 100), known);
  }
  if (closed_.contains(robot)) return fmt::format("the software of '{}' has ended, and no other one is taken", robot);
  if (busy_.contains(robot)) return fmt::format("'{}' has its software already", robot);
  return {};
}

/// Under the lock.
void TcpReception::admit(TcpClient client) {
  if (!robots_) return early_.push_back(std::move(client));
  if (const std::string reason = objection(client.robot); !reason.empty()) {
    refuse(client.connection, reason);
    return tell(client, reason);
  }
  busy_.insert(client.robot);
  const std::string robot = client.robot;
  waiting_.emplace(robot, std::move(client));
  arrived_.notify_all();
}

/// Under the lock.
std::optional<TcpClient> TcpReception::taken(const std::string& robot) {
  auto found = waiting_.extract(robot);
  if (!found) return {};
  return std::move(found.mapped());
}

std::optional<TcpClient> TcpReception::take(const std::string& robot) {
  const std::lock_guard lock(mutex_);
  return taken(robot);
}

std::optional<TcpClient> TcpReception::wait_for(const std::string& robot, double limit) {
  const wire::WallTime end = after(limit);
  std::unique_lock lock(mutex_);
  if (!robots_) robots_.emplace();
  robots_->insert(robot);  // a robot that comes later
  for (;;) {
    if (auto client = taken(robot)) return client;
    if (WallClock::now() >= end || is_stopped()) return {};
    arrived_.wait_for(lock, ask_for_stop);
  }
}

void TcpReception::leave(const std::string& robot, bool for_good) {
  const std::lock_guard lock(mutex_);
  busy_.erase(robot);
  if (for_good) closed_.insert(robot);
}

void TcpReception::tell(const TcpClient& client, const std::string& reason) {
  if (!options_.say || told_ > most_lines) return;
  if (told_++ == most_lines) return options_.say("more clients were refused; they are not told of any more");
  options_.say(fmt::format("client {} was refused: {}", client.address, reason));
}

/// Whoever has waited longest makes room.
void TcpReception::accept_all(wire::WallTime now) {
  for (;;) {
    wire::Socket socket = listener_.accept();
    if (!socket.is_open()) {
      if (errno == EMFILE || errno == ENFILE) std::this_thread::sleep_for(out_of_descriptors);
      return;
    }
    std::string address = to_text(socket.peer_address());
    Stranger stranger{{.connection = {std::move(socket), longest_message}, .address = std::move(address)},
                      now + from_seconds(options_.hello_limit)};
    if (strangers_.size() >= most_strangers) {
      turn_away(strangers_.front(), "too many connect and do not say who they are");
      strangers_.pop_front();
    }
    strangers_.push_back(std::move(stranger));
  }
}

/// Whether it is a stranger no more: admitted or refused.
bool TcpReception::look_at(Stranger& stranger, wire::WallTime now) {
  TcpClient& client = stranger.client;
  try {
    const auto message = client.connection.receive();
    if (!message && now < stranger.end) return false;
    if (!message) throw wire::WireError("has not said in time whose software it is");
    read_hello(client, *message);
    const std::lock_guard lock(mutex_);
    admit(std::move(client));
  } catch (const wire::WireError& error) {
    turn_away(stranger, fmt::format("it {}", error.what()));
  }
  return true;
}

void TcpReception::turn_away(Stranger& stranger, const std::string& reason) {
  refuse(stranger.client.connection, reason);
  const std::lock_guard lock(mutex_);
  tell(stranger.client, reason);
}

void TcpReception::receive_all() {
  std::vector<pollfd> asked;
  while (!ends_) {
    asked.assign({{wake_, POLLIN, 0}, {listener_.number(), POLLIN, 0}});
    for (const Stranger& stranger : strangers_) {
      asked.push_back({stranger.client.connection.socket().number(), POLLIN, 0});
    }
    (void)::poll(asked.data(), asked.size(), strangers_.empty() ? -1 : static_cast<int>(longest_pause / 1ms));
    const wire::WallTime now = WallClock::now();
    strangers_.remove_if([&](Stranger& stranger) { return look_at(stranger, now); });
    if (asked[1].revents != 0) accept_all(now);
  }
}

}  // namespace murosimf::connect
