#include "murosimf/connect/tcp_reception.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::connect {
namespace {

using namespace std::chrono_literals;
using WallClock = std::chrono::steady_clock;

constexpr std::size_t most_lines = 100;  // about clients that were refused
constexpr auto ask_for_stop = 20ms;

wire::WallTime after(double s) { return WallClock::now() + from_seconds(s); }

std::unique_ptr<wire::Reception> reception_at(const TcpServerOptions& options, wire::Reception::Door door) {
  try {
    const wire::ReceptionOptions at{.address = options.address,
                                    .longest = longest_message,
                                    .hello_limit = options.hello_limit};
    return std::make_unique<wire::Reception>(at, std::move(door));
  } catch (const wire::WireError& error) {
    throw SetupError(fmt::format("cannot listen on {}: {}", to_text(options.address), error.what()));
  }
}

}  // namespace

TcpReception::TcpReception(TcpServerOptions options) : options_(std::move(options)) {
  reception_ =
      reception_at(options_, {[this](wire::Caller& caller, std::string_view message) { look_at(caller, message); },
                              [this](wire::Caller& caller, const std::string& reason) { turn_away(caller, reason); }});
}

TcpReception::~TcpReception() = default;

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
    return tell(client.address, reason);
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

void TcpReception::tell(const std::string& address, const std::string& reason) {
  if (!options_.say || told_ > most_lines) return;
  if (told_++ == most_lines) return options_.say("more clients were refused; they are not told of any more");
  options_.say(fmt::format("client {} was refused: {}", address, reason));
}

void TcpReception::look_at(wire::Caller& caller, std::string_view message) {
  TcpClient client{.connection = std::move(caller.connection), .address = caller.address};
  try {
    read_hello(client, message);
  } catch (const wire::WireError&) {
    caller.connection = std::move(client.connection);  // it is told why
    throw;
  }
  const std::lock_guard lock(mutex_);
  admit(std::move(client));
}

void TcpReception::turn_away(wire::Caller& caller, const std::string& reason) {
  refuse(caller.connection, reason);
  const std::lock_guard lock(mutex_);
  tell(caller.address, reason);
}

}  // namespace murosimf::connect
