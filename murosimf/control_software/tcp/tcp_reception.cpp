#include "murosimf/control_software/tcp/tcp_reception.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

using namespace std::chrono_literals;
using WallClock = std::chrono::steady_clock;

constexpr std::size_t most_lines = 100;  // about clients that were refused
constexpr auto ask_for_stop = 20ms;

network::WallTime after(double s) { return WallClock::now() + from_seconds(s); }

std::unique_ptr<network::Reception> reception_at(const TcpServerOptions& options, network::Reception::Door door) {
  try {
    const network::ReceptionOptions at{.address = options.address,
                                       .longest = longest_message,
                                       .hello_limit = options.hello_limit};
    return std::make_unique<network::Reception>(at, std::move(door));
  } catch (const network::NetworkError& error) {
    throw SetupError(fmt::format("cannot listen on {}: {}", to_text(options.address), error.what()));
  }
}

}  // namespace

TcpReception::TcpReception(TcpServerOptions options) : options_(std::move(options)) {
  reception_ =
      reception_at(options_, {[this](network::Caller& caller, std::string_view message) { inspect(caller, message); },
                              [this](network::Caller& caller, const std::string& reason) { reject(caller, reason); }});
}

TcpReception::~TcpReception() = default;

void TcpReception::expect(std::vector<std::string> robots) {
  const std::lock_guard lock(mutex_);
  robots_.emplace(robots.begin(), robots.end());
  // those of the previous scene do not count
  closed_.clear();
  busy_.clear();
  for (TcpClient& client : std::exchange(early_, {})) admit(std::move(client));
}

/// Reason why no client is accepted for a robot; empty: one is.
std::string TcpReception::objection(const std::string& robot) {
  MUROSIMF_ASSERT(robots_.has_value());
  if (!robots_->contains(robot)) {
    const std::vector<std::string_view> known(robots_->begin(), robots_->end());
    return unknown_name("robot with the controller 'tcp'", printable(robot, 100), known);
  }
  if (closed_.contains(robot)) return fmt::format("the software of '{}' has ended, and no other one is taken", robot);
  remove_disconnected(robot);
  if (busy_.contains(robot) || waiting_.contains(robot)) return fmt::format("'{}' has its software already", robot);
  return {};
}

/// Another client may take the robot over, also while the run is paused and the old connection is not used. Under the lock.
void TcpReception::remove_disconnected(const std::string& robot) {
  const auto present = busy_.find(robot);
  if (present != busy_.end() && present->second.has_ended()) busy_.erase(present);
  const auto waiting = waiting_.find(robot);
  if (waiting == waiting_.end() || !waiting->second.connection.socket().has_ended()) return;
  publish_refusal(waiting->second.address, "it closed the connection before its robot was there");
  waiting_.erase(waiting);
}

/// Under the lock.
void TcpReception::admit(TcpClient client) {
  if (!robots_) return early_.push_back(std::move(client));
  if (const std::string reason = objection(client.robot); !reason.empty()) {
    refuse(client.connection, reason);
    return publish_refusal(client.address, reason);
  }
  const std::string robot = client.robot;
  waiting_.emplace(robot, std::move(client));
  arrived_.notify_all();
}

/// Under the lock.
std::optional<TcpClient> TcpReception::taken(const std::string& robot) {
  remove_disconnected(robot);
  auto found = waiting_.extract(robot);
  if (!found) return {};
  busy_[robot] = found.mapped().connection.socket().watcher();
  return std::move(found.mapped());
}

std::optional<TcpClient> TcpReception::take(const std::string& robot) {
  const std::lock_guard lock(mutex_);
  return taken(robot);
}

std::optional<TcpClient> TcpReception::wait_for(const std::string& robot, double limit) {
  const network::WallTime end = after(limit);
  std::unique_lock lock(mutex_);
  if (!robots_) robots_.emplace();
  robots_->insert(robot);  // a robot that comes later
  for (;;) {
    // polled, since a stop request comes from a signal handler and cannot notify
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

void TcpReception::tell(const std::string& line) {
  const std::lock_guard lock(mutex_);
  say(line);
}

/// Under the lock.
void TcpReception::say(const std::string& line) {
  if (!options_.say || told_ > most_lines) return;
  options_.say(told_++ == most_lines ? "more clients were refused; they are not told of any more" : line);
}

/// Under the lock.
void TcpReception::publish_refusal(const std::string& address, const std::string& reason) {
  say(fmt::format("client {} was refused: {}", address, reason));
}

void TcpReception::inspect(network::Caller& caller, std::string_view message) {
  TcpClient client{.connection = std::move(caller.connection), .address = caller.address};
  try {
    read_hello(client, message);
  } catch (const network::NetworkError&) {
    caller.connection = std::move(client.connection);  // it receives the reason
    throw;
  }
  const std::lock_guard lock(mutex_);
  admit(std::move(client));
}

void TcpReception::reject(network::Caller& caller, const std::string& reason) {
  refuse(caller.connection, reason);
  const std::lock_guard lock(mutex_);
  publish_refusal(caller.address, reason);
}

}  // namespace murosimf::control_software
