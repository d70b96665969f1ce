#include "murosimf/control_software/tcp/tcp_software.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {

TcpSoftware::TcpSoftware(const Setup& setup, RobotPort& port, SayLine say, std::shared_ptr<TcpClients> clients,
                         ArrivedClient client, const TcpOptions& options, std::uint64_t seed, ExternalInputRecorder pen)
    : clients_(std::move(clients)),
      options_(options),
      robot_{setup.entity().name(),
             setup.entity().options().team,
             setup.model().name(),
             seconds(setup.period()),
             seed,
             options.mode == "lock_step"},
      port_(&port),
      say_(std::move(say)),
      pen_(pen) {
  MUROSIMF_ASSERT(clients_ != nullptr);
  try {
    meet(std::move(client));
    session_->set_up(std::chrono::steady_clock::now() + from_seconds(options_.wait));
  } catch (const network::NetworkError& error) {
    if (session_) session_->say_refused(error.what());
    clients_->leave(false);
    throw SoftwareWent(fmt::format("{}: {} {} before it was ready", robot_.name, client_, error.what()));
  }
}

TcpSoftware::~TcpSoftware() {
  if (session_) session_->send_goodbye();
  clients_->leave(true);
}

void TcpSoftware::meet(ArrivedClient client) {
  client_ = client.name;
  pen_.write(ExternalInput::came, to_bytes(client));
  session_ = std::make_unique<TcpSession>(std::move(client.line), robot_, *port_, say_, pen_);
}

void TcpSoftware::at(Duration now) {
  pen_.at(now);
  clients_->at(now);
}

network::WallTime TcpSoftware::end_of_waiting() const {
  return std::chrono::steady_clock::now() + from_seconds(options_.limit);
}

/// The robot keeps its last commands, and another client may take its place.
void TcpSoftware::drop(const std::string& reason) noexcept {
  pen_.write(ExternalInput::left, reason);
  if (session_) session_->say_refused(reason);
  session_.reset();
  clients_->leave(false);
  last_ = fmt::format("{} {}", client_, reason);
  add_news(fmt::format("{}; its last commands hold until other software comes", last_));
}

void TcpSoftware::add_news(const std::string& line) { news_ += news_.empty() ? line : "; " + line; }

/// Returns false if the client has disconnected or violated the protocol.
template <class Talk>
bool TcpSoftware::guarded(const Talk& talk) noexcept {
  try {
    talk();
  } catch (const network::NetworkError& error) {
    drop(error.what());
    return false;
  }
  return true;
}

CallOutcome TcpSoftware::start() {
  at(before_the_run);
  news_.clear();
  if (robot_.lock_step) {
    exchange_in_step({});
  } else if (session_) {
    guarded([&] { session_->publish_start(); });
  }
  return {};
}

/// After a jump in time, the client first learns of it: its samples are of another past.
CallOutcome TcpSoftware::step(Duration now) noexcept {
  at(now);
  if (std::exchange(jumped_, false)) guarded([&] { catch_up(now); });
  if (robot_.lock_step) {
    exchange_in_step(now);
  } else {
    guarded([&] { exchange_freely(now); });
  }
  return {};
}

/// Sends the cycle and waits for its answer; nothing: the run begins. If the client disconnects, other software may take its place at once.
void TcpSoftware::exchange_in_step(std::optional<Duration> now) noexcept {
  const bool was_there = session_ != nullptr;
  if (was_there && guarded([&] { ask(now); })) return;
  const network::WallTime end = std::chrono::steady_clock::now() + from_seconds(was_there ? options_.absence : 0);
  for (bool has_come = true; has_come && !session_;) {
    has_come = false;
    guarded([&] {
      const Duration left = end - std::chrono::steady_clock::now();
      std::optional<ArrivedClient> client = clients_->wait(std::max(0.0, seconds(left)));
      if (!client) return;
      has_come = true;
      begin_with(std::move(*client));
      if (now) ask(now);
    });
  }
}

void TcpSoftware::ask(std::optional<Duration> now) {
  now ? session_->publish_cycle(*now) : session_->publish_start();
  session_->wait_for_answer(end_of_waiting());
}

void TcpSoftware::begin_with(ArrivedClient client) {
  add_news(fmt::format("{} has come", client.name));
  meet(std::move(client));
  session_->set_up(end_of_waiting());
  ask({});
}

/// Applies received commands; sends the measured values if the client keeps up.
void TcpSoftware::exchange_freely(Duration now) {
  if (!session_) accept_another();
  if (!session_) return;
  const network::WallTime present = std::chrono::steady_clock::now();
  const bool begins = !session_->is_ready();
  session_->receive_pending(present);
  if (begins && session_->is_ready()) session_->publish_start();
  const bool waits = session_->is_live() && session_->is_waited_for();
  if (waits && present - session_->waited_for_since() > from_seconds(options_.limit)) {
    throw network::NetworkError("did not answer in time");
  }
  if (!session_->keeps_up()) return;
  session_->publish_cycle(now);
  pen_.write(ExternalInput::told);  // logged, since its team messages have left the robot's inbox
}

void TcpSoftware::accept_another() {
  auto client = clients_->take();
  if (!client) return;
  add_news(fmt::format("{} has come", client->name));
  meet(std::move(*client));
}

/// Recorded: restores the client that was connected at `now`, independent of the state before the jump.
void TcpSoftware::catch_up(Duration now) {
  const std::vector<ExternalInput> lasting = clients_->jump_to(now);
  if (lasting.empty()) return;
  const ExternalInputRecorder pen = std::exchange(pen_, ExternalInputRecorder{});  // these notes are logged already
  for (const ExternalInput& note : lasting) {
    if (note.kind == ExternalInput::came) {
      ArrivedClient client = arrived_client(note.bytes);
      client.line = clients_->line();
      meet(std::move(client));
    }
    if (note.kind == ExternalInput::asked && session_) session_->ask_again(note.bytes);
    if (note.kind == ExternalInput::left) {
      session_.reset();
      last_ = fmt::format("{} {}", client_, note.bytes);
    }
  }
  pen_ = pen;
  if (session_ && session_->is_ready()) session_->publish_start();
}

std::string TcpSoftware::news() { return std::exchange(news_, {}); }

}  // namespace murosimf::control_software
