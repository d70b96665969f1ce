#include "murosimf/connect/tcp_software.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::connect {

TcpSoftware::TcpSoftware(const Setup& setup, RobotPort& port, SayLine say, std::shared_ptr<TcpReception> reception,
                         TcpClient client, const TcpOptions& options, std::uint64_t seed)
    : reception_(std::move(reception)),
      options_(options),
      robot_{setup.entity().name(),
             setup.entity().options().team,
             setup.model().name(),
             seconds(setup.period()),
             seed,
             options.mode == "lock_step"},
      port_(&port),
      say_(std::move(say)) {
  client_ = client.name();
  try {
    session_ = std::make_unique<TcpSession>(std::move(client), robot_, port, say_);
    session_->set_up(std::chrono::steady_clock::now() + from_seconds(options_.wait));
  } catch (const wire::WireError& error) {
    if (session_) session_->say_refused(error.what());
    reception_->leave(robot_.name, false);
    throw SetupError(fmt::format("{}: {} {} before it was ready", robot_.name, client_, error.what()));
  }
}

TcpSoftware::~TcpSoftware() {
  if (session_) session_->say_goodbye();
  reception_->leave(robot_.name, true);
}

wire::WallTime TcpSoftware::end_of_waiting() const {
  return std::chrono::steady_clock::now() + from_seconds(options_.limit);
}

/// The line that tells it.
std::string TcpSoftware::drop(const std::string& reason) noexcept {
  std::string line = fmt::format("{} {}", client_, reason);
  if (session_) session_->say_refused(reason);
  session_.reset();
  reception_->leave(robot_.name, robot_.lock_step);
  return last_ = line;
}

template <class Talk>
CallOutcome TcpSoftware::guarded(const Talk& talk) noexcept {
  try {
    talk();
  } catch (const wire::WireError& error) {
    const std::string line = drop(error.what());
    if (robot_.lock_step) return {CallOutcome::threw, line};
    news_ = fmt::format("{}; its last commands hold until other software comes", line);
  }
  return {};
}

CallOutcome TcpSoftware::start() {
  news_.clear();
  if (!session_) {
    if (!robot_.lock_step) return {};
    return {CallOutcome::threw, fmt::format("{}: its software cannot begin again: {}", robot_.name, last_)};
  }
  return guarded([&] {
    session_->tell_start();
    if (robot_.lock_step) session_->wait_for_answer(end_of_waiting());
  });
}

CallOutcome TcpSoftware::step(Duration now) noexcept {
  if (robot_.lock_step && !session_) return {CallOutcome::threw, last_};  // somebody went on after a reset that failed
  return guarded([&] {
    if (!robot_.lock_step) return talk_freely(now);
    session_->tell_cycle(now);
    session_->wait_for_answer(end_of_waiting());
  });
}

/// Commands that have come hold now; what is measured now is told if the client takes it.
void TcpSoftware::talk_freely(Duration now) {
  if (!session_) welcome_another();
  if (!session_) return;
  const wire::WallTime present = std::chrono::steady_clock::now();
  const bool begins = !session_->is_ready();
  session_->take_what_has_come(present);
  if (begins && session_->is_ready()) session_->tell_start();
  if (session_->is_waited_for() && present - session_->waited_for_since() > from_seconds(options_.limit)) {
    throw wire::WireError("did not answer in time");
  }
  if (session_->keeps_up()) session_->tell_cycle(now);
}

void TcpSoftware::welcome_another() {
  auto client = reception_->take(robot_.name);
  if (!client) return;
  client_ = client->name();
  news_ = fmt::format("{} has come", client_);
  session_ = std::make_unique<TcpSession>(std::move(*client), robot_, *port_, say_);
}

std::string TcpSoftware::news() { return std::exchange(news_, {}); }

}  // namespace murosimf::connect
