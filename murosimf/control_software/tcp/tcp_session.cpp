#include "murosimf/control_software/tcp/tcp_session.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <robot_protocol.pb.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

constexpr std::size_t most_questions = 1000;
constexpr std::size_t most_messages =
    20'000;                                 // in a second; sockets buffer less than this while a simulation is paused
constexpr std::size_t longest_line = 1000;  // for the report

// A cycle has at most 16 MiB, the limit of clients.
constexpr std::size_t most_message_bytes = 1024 * 1024;
constexpr std::size_t most_picture_bytes = 14 * 1024 * 1024;
constexpr std::size_t most_pixel_bytes = 4;

DrawnShape shape_of(const wire::Shape& shape) {
  DrawnShape drawn{.kind = static_cast<DrawnShape::Kind>(shape.kind()), .size = shape.size(), .words = shape.text()};
  // whole points only: a trailing rest of one or two numbers is ignored
  for (int i = 0; i + 2 < shape.points_size(); i += 3) {
    drawn.points.push_back({shape.points(i), shape.points(i + 1), shape.points(i + 2)});
  }
  if (shape.color_size() >= 3) drawn.color = {shape.color(0), shape.color(1), shape.color(2)};
  if (shape.color_size() >= 4) drawn.opacity = shape.color(3);
  return drawn;
}

}  // namespace

TcpSession::TcpSession(std::unique_ptr<ClientLine> line, TcpRobot robot, RobotPort& port, SayLine say,
                       ExternalInputRecorder& pen)
    : line_(std::move(line)),
      robot_(std::move(robot)),
      port_(&port),
      say_(std::move(say)),
      pen_(&pen),
      incoming_(std::make_unique<wire::FromClient>()),
      outgoing_(std::make_unique<wire::ToClient>()) {
  MUROSIMF_ASSERT(line_ != nullptr);
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
  line_->send(bytes_);
}

void TcpSession::set_up(network::WallTime end) {
  while (!ready_) take(line_->receive_until(end));
}

/// The client begins anew: pictures are sent again although their numbers may be known.
void TcpSession::publish_start() {
  wire::Cycle& cycle = *outgoing_->mutable_cycle();
  cycle.Clear();
  cycle.set_start(true);
  for (Asked& asked : pictures_) asked.told = 0;
  started_ = cycle_ + 1;
  tell();
}

void TcpSession::publish_cycle(Duration now) {
  wire::Cycle& cycle = *outgoing_->mutable_cycle();
  cycle.set_start(false);
  cycle.set_now(now.count());
  publish_samples(cycle);
  publish_messages(cycle);
  publish_pictures(cycle);
  tell();
}

/// Reuses the memory of the previous cycle.
void TcpSession::publish_samples(wire::Cycle& cycle) const {
  if (cycle.samples_size() == 0) {
    for (std::size_t i = 0; i < signals_.size(); ++i) cycle.add_samples();
  }
  MUROSIMF_ASSERT(static_cast<std::size_t>(cycle.samples_size()) == signals_.size());
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    const murosimf_signal& signal = *signals_[i];
    wire::Sample& sample = *cycle.mutable_samples(static_cast<int>(i));
    sample.set_time(signal.time);
    sample.set_samples(signal.samples);
    sample.mutable_values()->Clear();
    sample.mutable_values()->Add(signal.values, signal.values + signal.count);
  }
}

/// Messages beyond the limit are sent with the next cycle.
void TcpSession::publish_messages(wire::Cycle& cycle) {
  cycle.clear_messages();
  if (!has_messages_) return;
  std::size_t bytes = 0;
  while (bytes < most_message_bytes) {
    const TeamMessage* received = port_->radio().receive();
    if (!received) return;
    wire::TeamMessage& message = *cycle.add_messages();
    message.set_content(received->bytes);
    message.set_sender(received->sender);
    message.set_sent(received->sent.count());
    bytes += received->bytes.size();
  }
}

/// Only pictures that are new since the last message: they are by far the largest part of it.
void TcpSession::publish_pictures(wire::Cycle& cycle) {
  cycle.clear_pictures();
  for (std::size_t i = 0; i < pictures_.size(); ++i) {
    const murosimf_picture& shown = *pictures_[i].picture;
    if (shown.number == pictures_[i].told || !shown.bytes) continue;
    pictures_[i].told = shown.number;
    wire::Picture& picture = *cycle.add_pictures();
    picture.set_picture(static_cast<std::uint32_t>(i));
    picture.set_time(shown.time);
    picture.set_number(shown.number);
    picture.set_content(shown.bytes, shown.size);
  }
}

void TcpSession::tell() {
  outgoing_->mutable_cycle()->set_cycle(++cycle_);
  if (!owes_answer_) heard_at_ = std::chrono::steady_clock::now();
  owes_answer_ = true;
  send();
}

void TcpSession::wait_for_answer(network::WallTime end) {
  line_->flush_until(end);
  while (owes_answer_) take(line_->receive_until(end));
}

void TcpSession::receive_pending(network::WallTime now) {
  while (const auto bytes = line_->receive()) {
    if (is_live()) check_rate(now);
    take(*bytes);
  }
}

/// A client that sends without end would occupy the thread of the run.
void TcpSession::check_rate(network::WallTime now) {
  if (now - second_ > std::chrono::seconds(1)) {
    second_ = now;
    messages_ = 0;
  }
  if (++messages_ > most_messages) {
    throw network::NetworkError(fmt::format("sends more than {} messages in a second", most_messages));
  }
}

void TcpSession::take(std::string_view bytes) {
  parse(bytes, *incoming_);
  pen_->write(take_message(), bytes);
}

/// Applies the whole message, or nothing of it.
ExternalInput::Kind TcpSession::take_message() {
  const bool at_start = robot_.lock_step && outgoing_->cycle().start();
  switch (incoming_->kind_case()) {
    case wire::FromClient::kAsk:
      if (ready_) throw network::NetworkError("asks for a name after it was ready");
      answer(incoming_->ask());
      return ExternalInput::asked;
    case wire::FromClient::kReady:
      if (ready_) throw network::NetworkError("is ready twice");
      ready_ = true;
      return ExternalInput::asked;
    case wire::FromClient::kCommands:
      if (!ready_) throw network::NetworkError("sends commands before it was ready");
      take_over(incoming_->commands());
      return at_start ? ExternalInput::began : ExternalInput::sent;
    default:
      throw network::NetworkError("says Hello twice");
      // only valid messages are logged: a recording repeats without protocol errors
  }
}

/// An unknown name is no protocol error: the software decides whether it can do without.
void TcpSession::answer(const wire::Ask& ask) {
  if (++asked_ > most_questions)
    throw network::NetworkError(fmt::format("asks for more than {} names", most_questions));
  try {
    wire::Description described;
    switch (ask.name_case()) {
      case wire::Ask::kSignal: describe_signal(ask.signal(), described); break;
      case wire::Ask::kPicture: describe_picture(ask.picture(), described); break;
      case wire::Ask::kMessages:
        port_->radio().open();
        has_messages_ = true;
        break;
      default: describe_command(ask.command(), described);
    }
    *outgoing_->mutable_description() = std::move(described);
  } catch (const SetupError& error) {
    outgoing_->mutable_refusal()->set_reason(error.what());
  }
  send();
}

void TcpSession::describe_signal(const std::string& name, wire::Description& described) {
  signals_.push_back(port_->signal(name));
  for (const std::string& label : *port_->labels(name)) described.add_labels(label);
}

void TcpSession::describe_command(const std::string& name, wire::Description& described) {
  murosimf_command* const command = port_->command(name);
  if (std::ranges::find(commands_, command) != commands_.end()) {
    throw SetupError(fmt::format("the command '{}' was asked for before", name));
  }
  commands_.push_back(command);
  command_names_.push_back(name);
  described.mutable_values()->Add(command->values, command->values + command->count);
  for (const std::string& label : *port_->labels(name)) described.add_labels(label);
}

/// Bounded, so that a message of all pictures fits the largest one.
void TcpSession::describe_picture(const std::string& name, wire::Description& described) {
  const murosimf_picture* const shown = port_->picture(name);
  const std::size_t bytes = std::size_t{most_pixel_bytes} * shown->width * shown->height;
  if (picture_bytes_ + bytes > most_picture_bytes) {
    throw SetupError(fmt::format("the picture '{}' is too large: pictures of one cycle may have {} bytes together",
                                 name, most_picture_bytes));
  }
  picture_bytes_ += bytes;
  pictures_.push_back({shown});
  wire::PictureFormat& format = *described.mutable_picture();
  format.set_width(shown->width);
  format.set_height(shown->height);
  format.set_format(shown->format);
  format.set_period(shown->period);
}

void TcpSession::take_over(const wire::Commands& answer) {
  if (!is_live()) cycle_ = std::max(cycle_, answer.cycle());  // a recording may begin in the middle of the run
  if (answer.cycle() > cycle_ || (robot_.lock_step && answer.cycle() < cycle_)) {
    throw network::NetworkError(fmt::format("answers cycle {} in cycle {}", answer.cycle(), cycle_));
  }
  if (answer.cycle() < started_) return;  // of the previous run
  if (static_cast<std::size_t>(answer.rows_size()) != commands_.size()) {
    throw network::NetworkError(
        fmt::format("sends {} rows of commands, and asked for {}", answer.rows_size(), commands_.size()));
  }
  // all rows are checked before any is applied
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const auto& values = answer.rows(static_cast<int>(i)).values();
    const auto count = static_cast<std::size_t>(values.size());
    if (count != 0 && count != commands_[i]->count) {
      throw network::NetworkError(
          fmt::format("sends {} numbers for '{}', which has {}", count, command_names_[i], commands_[i]->count));
    }
  }
  if (answer.sends_size() > 0 && !has_messages_) {
    throw network::NetworkError("sends messages to its team, and has not asked for them");
  }
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    std::ranges::copy(answer.rows(static_cast<int>(i)).values(), commands_[i]->values);
  }
  send_to_team(answer);
  draw(answer);
  for (const std::string& line : answer.says()) say_(printable(line, longest_line));
  answered_ = std::max(answered_, answer.cycle());
  owes_answer_ = owes_answer_ && answer.cycle() < cycle_;
  heard_at_ = std::chrono::steady_clock::now();
}

/// Messages beyond the limits are counted.
void TcpSession::send_to_team(const wire::Commands& answer) {
  for (const std::string& message : answer.sends()) (void)port_->radio().send(message);
}

/// Drawings beyond the limits, or invalid ones, are ignored.
void TcpSession::draw(const wire::Commands& answer) {
  for (const wire::Drawing& drawing : answer.draws()) {
    DrawnGroup group{.name = drawing.group(), .of_robot = drawing.of_robot()};
    for (const wire::Shape& shape : drawing.shapes()) group.shapes.push_back(shape_of(shape));
    (void)port_->draw(std::move(group));
  }
}

void TcpSession::send_goodbye() noexcept {
  try {
    outgoing_->mutable_goodbye();
    send();
  } catch (const std::exception&) {  // the client has already disconnected
  }
}

void TcpSession::say_refused(const std::string& reason) noexcept {
  try {
    outgoing_->mutable_refusal()->set_reason(reason);
    send();
  } catch (const std::exception&) {  // the client has disconnected
  }
}

}  // namespace murosimf::control_software
