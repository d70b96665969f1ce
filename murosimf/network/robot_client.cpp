#include "murosimf/network/robot_client.h"

#include <algorithm>
#include <exception>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <robot_protocol.pb.h>

#include "murosimf/network/connection.h"

namespace murosimf::client {
namespace {

constexpr unsigned protocol_version = 1;
constexpr std::size_t longest_message = 16 * 1024 * 1024;  // [byte] of the simulator
constexpr auto try_again = std::chrono::milliseconds(100);

using WallClock = std::chrono::steady_clock;

network::WallTime after(std::chrono::duration<double> s) {
  return WallClock::now() + std::chrono::duration_cast<WallClock::duration>(s);
}

}  // namespace

RobotClient::RobotClient(const ClientOptions& options)
    : patience_(options.patience),
      draws_(std::make_unique<wire::Commands>()),
      outgoing_(std::make_unique<wire::FromClient>()),
      incoming_(std::make_unique<wire::ToClient>()) {
  connect(options);
  wire::Hello& hello = *outgoing_->mutable_hello();
  // The first message on every connection: the simulator checks the version before anything else.
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

/// Connects; tries again for a while, since the simulator may start after its clients.
void RobotClient::connect(const ClientOptions& options) {
  const network::WallTime end = after(patience_);
  for (;;) {
    try {
      connection_ = std::make_unique<network::Connection>(network::Socket::connect({options.host, options.port}),
                                                          longest_message);
      return;
    } catch (const network::NetworkError& error) {
      if (WallClock::now() >= end) {
        throw ClientError(fmt::format("{}: {}", to_text(network::Address{options.host, options.port}), error.what()));
      }
    }
    std::this_thread::sleep_for(try_again);
  }
}

void RobotClient::send() {
  try {
    connection_->send(outgoing_->SerializeAsString());
    connection_->flush_until(after(patience_));
  } catch (const network::NetworkError&) {
    // The simulator has closed the connection: its last message, which is read next, gives the reason.
  }
}

const wire::ToClient& RobotClient::receive(bool in_time) {
  try {
    const network::WallTime end = in_time ? after(patience_) : network::WallTime::max();
    const std::string_view bytes = connection_->receive_until(end);
    if (!incoming_->ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
      throw ClientError("the simulator sends what is no message of this protocol");
    }
  } catch (const network::NetworkError& error) {
    throw ClientError(fmt::format("the simulator {}", error.what()));
  }
  if (incoming_->has_refusal()) {
    throw ClientError(fmt::format("the simulator refuses: {}", incoming_->refusal().reason()));
  }
  return *incoming_;
}

const wire::Description& RobotClient::ask(const wire::Ask& question, std::string_view name) {
  if (ready_) throw ClientError(fmt::format("'{}' is asked for after ready()", name));
  *outgoing_->mutable_ask() = question;
  send();
  const wire::ToClient& answer = receive(true);
  if (!answer.has_description()) throw ClientError(fmt::format("the simulator does not describe '{}'", name));
  return answer.description();
}

const Signal& RobotClient::signal(std::string_view name) {
  wire::Ask question;
  question.set_signal(std::string(name));
  const auto& labels = ask(question, name).labels();
  signals_.push_back({.values = std::vector<double>(static_cast<std::size_t>(labels.size())),
                      .labels = {labels.begin(), labels.end()}});
  return signals_.back();
}

CommandRow& RobotClient::command(std::string_view name) {
  wire::Ask question;
  question.set_command(std::string(name));
  const wire::Description& described = ask(question, name);
  commands_.push_back({.values = {described.values().begin(), described.values().end()},
                       .labels = {described.labels().begin(), described.labels().end()}});
  return commands_.back();
}

const Picture& RobotClient::picture(std::string_view name) {
  wire::Ask question;
  question.set_picture(std::string(name));
  const wire::PictureFormat& format = ask(question, name).picture();
  pictures_.push_back({.width = static_cast<int>(format.width()),
                       .height = static_cast<int>(format.height()),
                       .format = format.format(),
                       .period = format.period()});
  return pictures_.back();
}

void RobotClient::use_messages() {
  wire::Ask question;
  question.set_messages(true);
  (void)ask(question, "messages");
}

void RobotClient::ready() {
  if (std::exchange(ready_, true)) return;
  outgoing_->mutable_ready();
  send();
}

void RobotClient::answer() {
  if (!std::exchange(owes_answer_, false)) return;
  wire::Commands& commands = *outgoing_->mutable_commands();
  // The message object is reused: its memory grows once.
  commands.Clear();
  commands.set_cycle(cycle_);
  for (const CommandRow& row : commands_) {
    commands.add_rows()->mutable_values()->Add(row.values.begin(), row.values.end());
  }
  for (std::string& line : says_) commands.add_says(std::move(line));
  for (std::string& message : sends_) commands.add_sends(std::move(message));
  commands.mutable_draws()->Swap(draws_->mutable_draws());
  draws_->Clear();
  says_.clear();
  sends_.clear();
  send();
}

void RobotClient::draw(std::string_view group, const std::vector<Shape>& shapes, bool of_robot) {
  wire::Drawing& drawing = *draws_->add_draws();
  drawing.set_group(std::string(group));
  drawing.set_of_robot(of_robot);
  for (const Shape& shape : shapes) {
    wire::Shape& one = *drawing.add_shapes();
    one.set_kind(static_cast<wire::Shape::Kind>(shape.kind));
    one.mutable_points()->Add(shape.points.begin(), shape.points.end());
    one.set_size(shape.size);
    one.mutable_color()->Add(shape.color.begin(), shape.color.end());
    one.set_text(shape.words);
  }
}

bool RobotClient::next() {
  ready();
  answer();
  return read_cycle();
}

bool RobotClient::read_cycle() {
  const wire::ToClient& message = receive(false);
  if (message.has_goodbye()) return false;
  if (!message.has_cycle()) throw ClientError("the simulator sends no cycle");
  const wire::Cycle& cycle = message.cycle();
  cycle_ = cycle.cycle();
  now_ = cycle.now();
  starts_ = cycle.start();
  owes_answer_ = true;
  read_samples(cycle);
  read_messages(cycle);
  read_pictures(cycle);
  return true;
}

void RobotClient::read_samples(const wire::Cycle& cycle) {
  // In the order in which the signals were requested.
  for (std::size_t i = 0; i < signals_.size() && std::cmp_less(i, cycle.samples_size()); ++i) {
    const wire::Sample& sample = cycle.samples(static_cast<int>(i));
    signals_[i].time = sample.time();
    signals_[i].samples = sample.samples();
    signals_[i].values.assign(sample.values().begin(), sample.values().end());
  }
}

void RobotClient::read_messages(const wire::Cycle& cycle) {
  messages_.clear();
  for (const wire::TeamMessage& message : cycle.messages()) {
    messages_.push_back({message.content(), message.sender(), message.sent()});
  }
}

void RobotClient::read_pictures(const wire::Cycle& cycle) {
  for (const wire::Picture& come : cycle.pictures()) {
    if (come.picture() >= pictures_.size()) throw ClientError("the simulator sends a picture that was not requested");
    Picture& picture = pictures_[come.picture()];
    picture.bytes = come.content();
    picture.time = come.time();
    picture.number = come.number();
  }
}

}  // namespace murosimf::client
