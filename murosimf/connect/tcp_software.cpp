#include "murosimf/connect/tcp_software.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::connect {

TcpSoftware::TcpSoftware(const Setup& setup, RobotPort& port, SayLine say, std::shared_ptr<TcpClients> clients,
                         ArrivedClient client, const TcpOptions& options, std::uint64_t seed, OutsidePen pen)
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
  try {
    meet(std::move(client));
    session_->set_up(std::chrono::steady_clock::now() + from_seconds(options_.wait));
  } catch (const wire::WireError& error) {
    if (session_) session_->say_refused(error.what());
    clients_->leave(false);
    throw SetupError(fmt::format("{}: {} {} before it was ready", robot_.name, client_, error.what()));
  }
}

TcpSoftware::~TcpSoftware() {
  if (session_) session_->say_goodbye();
  clients_->leave(true);
}

void TcpSoftware::meet(ArrivedClient client) {
  client_ = client.name;
  pen_.write(OutsideNote::came, to_bytes(client));
  session_ = std::make_unique<TcpSession>(std::move(client.line), robot_, *port_, say_, pen_);
}

void TcpSoftware::at(Duration now) {
  pen_.at(now);
  clients_->at(now);
}

wire::WallTime TcpSoftware::end_of_waiting() const {
  return std::chrono::steady_clock::now() + from_seconds(options_.limit);
}

/// The line that tells it.
std::string TcpSoftware::drop(const std::string& reason) noexcept {
  std::string line = fmt::format("{} {}", client_, reason);
  pen_.write(OutsideNote::left, reason);
  if (session_) session_->say_refused(reason);
  session_.reset();
  clients_->leave(robot_.lock_step);
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
  at(before_the_run);
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
  at(now);
  if (std::exchange(jumped_, false)) {
    if (const CallOutcome outcome = guarded([&] { catch_up(now); }); !outcome) return outcome;
  }
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
  const bool waits = session_->is_live() && session_->is_waited_for();
  if (waits && present - session_->waited_for_since() > from_seconds(options_.limit)) {
    throw wire::WireError("did not answer in time");
  }
  if (!session_->keeps_up()) return;
  session_->tell_cycle(now);
  pen_.write(OutsideNote::told);  // its messages have been taken out of the robot's box
}

void TcpSoftware::welcome_another() {
  auto client = clients_->take();
  if (!client) return;
  news_ = fmt::format("{} has come", client->name);
  meet(std::move(*client));
}

/// Of a recording: the client that was there at `now`, as it was, whatever has been before.
void TcpSoftware::catch_up(Duration now) {
  const std::vector<OutsideNote> lasting = clients_->jump_to(now);
  if (lasting.empty()) return;
  const OutsidePen pen = std::exchange(pen_, OutsidePen{});  // it is written down already
  for (const OutsideNote& note : lasting) {
    if (note.kind == OutsideNote::came) {
      ArrivedClient client = arrived_client(note.bytes);
      client.line = clients_->line();
      meet(std::move(client));
    }
    if (note.kind == OutsideNote::asked && session_) session_->ask_again(note.bytes);
    if (note.kind == OutsideNote::left) {
      session_.reset();
      last_ = fmt::format("{} {}", client_, note.bytes);
    }
  }
  pen_ = pen;
  if (session_ && session_->is_ready()) session_->tell_start();
}

std::string TcpSoftware::news() { return std::exchange(news_, {}); }

}  // namespace murosimf::connect
