#include "murosimf/connect/tcp_session.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <robot_protocol.pb.h>

#include "murosimf/model/error.h"

namespace murosimf::connect {
namespace {

constexpr std::size_t most_questions = 1000;
constexpr std::size_t most_messages =
    20'000;                                 // in a second; what sockets buffer while a simulation stands still is less
constexpr std::size_t longest_line = 1000;  // for the report

}  // namespace

TcpSession::TcpSession(TcpClient client, TcpRobot robot, RobotPort& port, SayLine say)
    : client_(std::move(client)),
      robot_(std::move(robot)),
      port_(&port),
      say_(std::move(say)),
      incoming_(std::make_unique<wire::FromClient>()),
      outgoing_(std::make_unique<wire::ToClient>()) {
  heard_at_ = std::chrono::steady_clock::now();
  wire::Welcome& welcome = *outgoing_->mutable_welcome();
  welcome.set_robot(robot_.name);
  welcome.set_team(robot_.team);
  welcome.set_model(robot_.model);
  welcome.set_period(robot_.period);
  welcome.set_seed(robot_.seed);
  welcome.set_lock_step(robot_.lock_step);
  send();
}

TcpSession::~TcpSession() = default;

void TcpSession::send() {
  bytes_.clear();
  outgoing_->AppendToString(&bytes_);
  client_.connection.send(bytes_);
}

void TcpSession::set_up(wire::WallTime end) {
  while (!ready_) take(client_.connection.receive_until(end));
}

void TcpSession::tell_start() {
  wire::Cycle& cycle = *outgoing_->mutable_cycle();
  cycle.Clear();
  cycle.set_start(true);
  started_ = cycle_ + 1;
  tell();
}

void TcpSession::tell_cycle(Duration now) {
  wire::Cycle& cycle = *outgoing_->mutable_cycle();
  cycle.set_start(false);
  cycle.set_now(now.count());
  if (cycle.samples_size() == 0) {
    for (std::size_t i = 0; i < signals_.size(); ++i) cycle.add_samples();
  }
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    const murosimf_signal& signal = *signals_[i];
    wire::Sample& sample = *cycle.mutable_samples(static_cast<int>(i));
    sample.set_time(signal.time);
    sample.set_samples(signal.samples);
    sample.mutable_values()->Clear();
    sample.mutable_values()->Add(signal.values, signal.values + signal.count);
  }
  tell();
}

void TcpSession::tell() {
  outgoing_->mutable_cycle()->set_cycle(++cycle_);
  if (!owes_answer_) heard_at_ = std::chrono::steady_clock::now();
  owes_answer_ = true;
  send();
}

void TcpSession::wait_for_answer(wire::WallTime end) {
  client_.connection.flush_until(end);
  while (owes_answer_) take(client_.connection.receive_until(end));
}

void TcpSession::take_what_has_come(wire::WallTime now) {
  while (const auto bytes = client_.connection.receive()) {
    check_rate(now);
    take(*bytes);
  }
}

void TcpSession::check_rate(wire::WallTime now) {
  if (now - second_ > std::chrono::seconds(1)) {
    second_ = now;
    messages_ = 0;
  }
  if (++messages_ > most_messages) {
    throw wire::WireError(fmt::format("sends more than {} messages in a second", most_messages));
  }
}

void TcpSession::take(std::string_view bytes) {
  parse(bytes, *incoming_);
  switch (incoming_->kind_case()) {
    case wire::FromClient::kAsk:
      if (ready_) throw wire::WireError("asks for a name after it was ready");
      return answer(incoming_->ask());
    case wire::FromClient::kReady:
      if (ready_) throw wire::WireError("is ready twice");
      ready_ = true;
      return;
    case wire::FromClient::kCommands:
      if (!ready_) throw wire::WireError("sends commands before it was ready");
      return take_over(incoming_->commands());
    default: throw wire::WireError("says Hello twice");
  }
}

/// A name that is not there is its software's to judge: it may do without.
void TcpSession::answer(const wire::Ask& ask) {
  if (++asked_ > most_questions) throw wire::WireError(fmt::format("asks for more than {} names", most_questions));
  try {
    const bool of_signal = ask.has_signal();
    wire::Description described;
    const std::string& name = of_signal ? ask.signal() : ask.command();
    if (of_signal) {
      signals_.push_back(port_->signal(name));
    } else {
      murosimf_command* const command = port_->command(name);
      if (std::ranges::find(commands_, command) != commands_.end()) {
        throw SetupError(fmt::format("the command '{}' was asked for before", name));
      }
      commands_.push_back(command);
      command_names_.push_back(name);
      described.mutable_values()->Add(command->values, command->values + command->count);
    }
    for (const std::string& label : *port_->labels(name)) described.add_labels(label);
    *outgoing_->mutable_description() = std::move(described);
  } catch (const SetupError& error) {
    outgoing_->mutable_refusal()->set_reason(error.what());
  }
  send();
}

void TcpSession::take_over(const wire::Commands& answer) {
  if (answer.cycle() > cycle_ || (robot_.lock_step && answer.cycle() < cycle_)) {
    throw wire::WireError(fmt::format("answers cycle {} in cycle {}", answer.cycle(), cycle_));
  }
  if (answer.cycle() < started_) return;  // of the run before
  if (static_cast<std::size_t>(answer.rows_size()) != commands_.size()) {
    throw wire::WireError(
        fmt::format("sends {} rows of commands, and asked for {}", answer.rows_size(), commands_.size()));
  }
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const auto& values = answer.rows(static_cast<int>(i)).values();
    const auto count = static_cast<std::size_t>(values.size());
    if (count != 0 && count != commands_[i]->count) {
      throw wire::WireError(
          fmt::format("sends {} numbers for '{}', which has {}", count, command_names_[i], commands_[i]->count));
    }
  }
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    std::ranges::copy(answer.rows(static_cast<int>(i)).values(), commands_[i]->values);
  }
  for (const std::string& line : answer.says()) say_(printable(line, longest_line));
  answered_ = std::max(answered_, answer.cycle());
  owes_answer_ = owes_answer_ && answer.cycle() < cycle_;
  heard_at_ = std::chrono::steady_clock::now();
}

void TcpSession::say_goodbye() noexcept {
  try {
    outgoing_->mutable_goodbye();
    send();
  } catch (const std::exception&) {  // it has gone before
  }
}

}  // namespace murosimf::connect
