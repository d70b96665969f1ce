#include "murosimf/client/robot_client.h"

#include <algorithm>
#include <exception>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <robot_protocol.pb.h>

#include "murosimf/wire/connection.h"

namespace murosimf::client {
namespace {

constexpr unsigned protocol_version = 1;
constexpr std::size_t longest_message = 16 * 1024 * 1024;  // [byte] of the simulator
constexpr auto try_again = std::chrono::milliseconds(100);

using WallClock = std::chrono::steady_clock;

wire::WallTime after(std::chrono::duration<double> s) {
  return WallClock::now() + std::chrono::duration_cast<WallClock::duration>(s);
}

}  // namespace

RobotClient::RobotClient(const ClientOptions& options)
    : patience_(options.patience),
      outgoing_(std::make_unique<wire::FromClient>()),
      incoming_(std::make_unique<wire::ToClient>()) {
  connect(options);
  wire::Hello& hello = *outgoing_->mutable_hello();
  hello.set_version(protocol_version);
  hello.set_robot(options.robot);
  hello.set_rate(options.rate);
  hello.set_software(options.software);
  send();
  const wire::ToClient& answer = receive(true);
  if (!answer.has_welcome()) throw ClientError("the simulator does not answer Hello with Welcome");
  const wire::Welcome& welcome = answer.welcome();
  info_ = {welcome.robot(), welcome.team(), welcome.model(), welcome.period(), welcome.seed(), welcome.lock_step()};
}

RobotClient::~RobotClient() = default;

/// The simulator may start after its clients.
void RobotClient::connect(const ClientOptions& options) {
  const wire::WallTime end = after(patience_);
  for (;;) {
    try {
      connection_ =
          std::make_unique<wire::Connection>(wire::Socket::connect({options.host, options.port}), longest_message);
      return;
    } catch (const wire::WireError& error) {
      if (WallClock::now() >= end) {
        throw ClientError(fmt::format("{}: {}", to_text(wire::Address{options.host, options.port}), error.what()));
      }
    }
    std::this_thread::sleep_for(try_again);
  }
}

void RobotClient::send() {
  try {
    connection_->send(outgoing_->SerializeAsString());
    connection_->flush_until(after(patience_));
  } catch (const wire::WireError&) {
    // the simulator has closed the connection: why, or that the run is over, is what it has sent before
  }
}

const wire::ToClient& RobotClient::receive(bool in_time) {
  try {
    const wire::WallTime end = in_time ? after(patience_) : wire::WallTime::max();
    const std::string_view bytes = connection_->receive_until(end);
    if (!incoming_->ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
      throw ClientError("the simulator sends what is no message of this protocol");
    }
  } catch (const wire::WireError& error) {
    throw ClientError(fmt::format("the simulator {}", error.what()));
  }
  if (incoming_->has_refusal()) {
    throw ClientError(fmt::format("the simulator refuses: {}", incoming_->refusal().reason()));
  }
  return *incoming_;
}

std::vector<std::string> RobotClient::ask(std::string_view name, bool for_signal) {
  if (ready_) throw ClientError(fmt::format("'{}' is asked for after ready()", name));
  wire::Ask& ask = *outgoing_->mutable_ask();
  (for_signal ? *ask.mutable_signal() : *ask.mutable_command()) = name;
  send();
  const wire::ToClient& answer = receive(true);
  if (!answer.has_description()) throw ClientError(fmt::format("the simulator does not describe '{}'", name));
  const auto& labels = answer.description().labels();
  return {labels.begin(), labels.end()};
}

const Signal& RobotClient::signal(std::string_view name) {
  std::vector<std::string> labels = ask(name, true);
  signals_.push_back({.values = std::vector<double>(labels.size()), .labels = std::move(labels)});
  return signals_.back();
}

CommandRow& RobotClient::command(std::string_view name) {
  std::vector<std::string> labels = ask(name, false);
  const auto& values = incoming_->description().values();
  commands_.push_back({.values = {values.begin(), values.end()}, .labels = std::move(labels)});
  return commands_.back();
}

void RobotClient::ready() {
  if (std::exchange(ready_, true)) return;
  outgoing_->mutable_ready();
  send();
}

void RobotClient::answer() {
  if (!std::exchange(owes_answer_, false)) return;
  wire::Commands& commands = *outgoing_->mutable_commands();
  commands.Clear();
  commands.set_cycle(cycle_);
  for (const CommandRow& row : commands_) {
    commands.add_rows()->mutable_values()->Add(row.values.begin(), row.values.end());
  }
  for (std::string& line : says_) commands.add_says(std::move(line));
  says_.clear();
  send();
}

bool RobotClient::next() {
  ready();
  answer();
  return take_cycle();
}

bool RobotClient::take_cycle() {
  const wire::ToClient& message = receive(false);
  if (message.has_goodbye()) return false;
  if (!message.has_cycle()) throw ClientError("the simulator sends no cycle");
  const wire::Cycle& cycle = message.cycle();
  cycle_ = cycle.cycle();
  now_ = cycle.now();
  starts_ = cycle.start();
  owes_answer_ = true;
  for (std::size_t i = 0; i < signals_.size() && std::cmp_less(i, cycle.samples_size()); ++i) {
    const wire::Sample& sample = cycle.samples(static_cast<int>(i));
    signals_[i].time = sample.time();
    signals_[i].samples = sample.samples();
    signals_[i].values.assign(sample.values().begin(), sample.values().end());
  }
  return true;
}

}  // namespace murosimf::client
