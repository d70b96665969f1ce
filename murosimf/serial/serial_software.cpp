#include "murosimf/serial/serial_software.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::serial {

using dynamixel::ImuBoard;
using dynamixel::Protocol;
using dynamixel::ServoDevice;

SerialSoftware::SerialSoftware(Setup& setup, control_software::RobotPort& port, control_software::SayLine say,
                               std::vector<ServoPlace> layout, SerialOptions options,
                               const std::filesystem::path& folder, const ExternalInputOptions& outside)
    : say_(std::move(say)),
      options_(std::move(options)),
      period_(seconds(setup.period())),
      position_(port.signal("joint.position")),
      velocity_(port.signal("joint.velocity")),
      torque_(port.signal("joint.torque")),
      target_(port.command("joint.target")),
      enabled_(port.command("joint.torque_enabled")),
      position_gain_(port.command("joint.position_gain")),
      velocity_gain_(port.command("joint.velocity_gain")),
      torque_limit_(port.command("joint.torque_limit")),
      led_(port.command("joint.led")),
      voltage_(setup.observe(properties::supply_voltage)),
      temperature_(setup.observe(properties::servo_temperature)),
      last_byte_(WallClock::now()),
      notes_(outside.notes),
      pen_(outside.channel("serial:" + setup.entity().name())),
      repeated_(outside.repeated),
      reader_(repeated_ ? repeated_->find("serial:" + setup.entity().name()) : nullptr),
      remembered_(outside.memory),
      memory_(remembered_ ? &remembered_->channel("serial:" + setup.entity().name()) : nullptr) {
  for (const ServoPlace& place : layout) add_joint(setup.model(), place);
  for (const int joint : setup.model().joints()) {
    const Vec3d* range = setup.model().find(properties::joint_range, joint);
    rest_.push_back(range ? std::clamp(0.0, range->x, range->y) : 0.0);
  }
  if (std::ranges::any_of(joints_, &Joint::turns)) rate_ = port.command("joint.velocity_target");
  find_imu(setup, port);
  switch_on();
  if (folder.empty() || repeated_) return;
  terminal_ = std::make_unique<PseudoTerminal>(options_.first_rate());
  link_place_ = folder / setup.entity().name();
  check_link_place(link_place_);
}

void SerialSoftware::add_joint(const Model& model, const ServoPlace& place) {
  constexpr double any = std::numeric_limits<double>::infinity();
  Joint joint{.place = place, .object = model.joints()[place.joint], .range = {-any, any, 0}};
  if (const Vec3d* range = model.find(properties::joint_range, joint.object)) {
    const double first = angle_of(joint, range->x), second = angle_of(joint, range->y);
    joint.options.lowest = std::min(first, second);
    joint.options.highest = std::max(first, second);
    joint.range = *range;
  }
  if (const Servo* servo = model.find(properties::servo, joint.object)) {
    joint.options.stall_torque = servo->stall_torque;
    joint.options.no_load_speed = servo->no_load_speed;
    if (servo->stall_torque > 0 && servo->position_gain > 0) {
      joint.options.full_error = servo->stall_torque / servo->position_gain;
    }
    joint.own = servo;
    joint.turns = dynamics::follows_rate(*servo);
  }
  joint.options.torque = options_.torque;
  joints_.push_back(joint);
}

/// Without a name, an IMU is on the bus only if the robot has one of the usual name.
void SerialSoftware::find_imu(const Setup& setup, control_software::RobotPort& port) {
  const std::string name = options_.imu.empty() ? "imu" : options_.imu;
  const sensors::Reading* reading = sensors::find_reading(setup.entity(), name);
  if (options_.imu.empty() && (!reading || reading->info->type != "imu")) return;
  gyroscope_ = port.signal(name + ".gyroscope");
  accelerometer_ = port.signal(name + ".accelerometer");
  const auto id = static_cast<std::uint8_t>(options_.imu_id);
  if (std::ranges::any_of(joints_, [&](const Joint& joint) { return joint.place.id == id; })) {
    throw SetupError(fmt::format("the IMU and a servo have the id {}; give it another: imu_id", id));
  }
}

/// [rad] Angle of the servo's shaft.
double SerialSoftware::angle_of(const Joint& joint, double q) const {
  MUROSIMF_ASSERT(std::abs(joint.place.direction) == 1);
  return joint.place.direction * (q - joint.place.zero);
}

/// Resets the bus to its state after power-on.
void SerialSoftware::switch_on() {
  bus_ = std::make_unique<dynamixel::Bus>();
  const double rate = options_.first_rate();
  const auto listen_at_rate = [rate](dynamixel::BusDevice& device) {
    if (device.listen_at(rate)) return;
    throw SetupError(fmt::format("baud_rate: '{}' knows no rate near {} bit/s", device.registers().table().name, rate));
  };
  for (Joint& joint : joints_) {
    auto servo = std::make_unique<ServoDevice>(*joint.place.table, joint.place.id, joint.options);
    joint.servo = servo.get();
    listen_at_rate(*servo);
    bus_->add(std::move(servo));
  }
  imu_ = nullptr;
  if (gyroscope_) {
    const Protocol protocol = options_.protocol < 2 ? Protocol::v1 : Protocol::v2;
    auto board = std::make_unique<ImuBoard>(protocol, static_cast<std::uint8_t>(options_.imu_id), options_.imu_ping);
    imu_ = board.get();
    listen_at_rate(*board);
    bus_->add(std::move(board));
  }
  line_.emplace(*bus_, options_.baud_rate);
  line_->set_rate(rate);
}

control_software::CallOutcome SerialSoftware::start() {
  switch_on();
  std::ranges::copy(rest_, target_->values);
  for (const Joint& joint : joints_) enabled_->values[joint.place.joint] = options_.torque ? 1 : 0;
  if (terminal_) terminal_->discard();
  told_of_loss_ = false;
  return {};
}

control_software::CallOutcome SerialSoftware::step(Duration now) noexcept {
  if (terminal_ && !link_ &&
      !remembers()) {  // made at the first step, so that a client that finds the link is answered
    try {
      link_.emplace(link_place_, terminal_->name());
    } catch (const SetupError& error) {
      return {control_software::CallOutcome::threw, error.what()};
    }
  }
  const double time = seconds(now);
  // Measure, communicate, move the servos, command: a read returns the values of this step, a write acts in it.
  sense(time);
  if (terminal_ || repeated_) exchange_bytes(now);
  for (const Joint& joint : joints_) joint.servo->advance(period_);
  if (imu_) imu_->pass(period_);
  command();
  return {};
}

void SerialSoftware::sense(double now) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  for (const Joint& joint : joints_) {
    const std::size_t i = joint.place.joint;
    const auto object = static_cast<std::size_t>(joint.object);
    MUROSIMF_ASSERT(i < position_->count && object < voltage_.size() && joint.servo != nullptr);
    const double voltage = joint.place.own_type && voltage_[object] > 0 ? voltage_[object] : unknown;
    joint.servo->sense({.angle = angle_of(joint, position_->values[i]),
                        .velocity = joint.place.direction * velocity_->values[i],
                        .torque = joint.place.direction * torque_->values[i],
                        .voltage = voltage,
                        .temperature = temperature_[object],
                        .driven = std::isfinite(voltage_[object])},
                       now);
  }
  if (!imu_) return;
  imu_->sense({.count = gyroscope_->samples,
               .time = 1e-9 * static_cast<double>(gyroscope_->time),
               .gyroscope = {gyroscope_->values, 3},
               .accelerometer = {accelerometer_->values, 3}});
}

SerialSoftware::Heard SerialSoftware::listen(double now) {
  Heard heard;
  // A busy wire accepts no more: the client waits, as with a real port.
  constexpr double longest_queue = 0.05;  // [s]
  if (line_->free_at() < now + longest_queue)
    terminal_->receive(heard.bytes);  // includes bytes of a client that has disconnected
  if (!heard.bytes.empty()) {
    last_byte_ = WallClock::now();
    if (terminal_->rate() > 0 && terminal_->rate() != line_->rate()) heard.rate = terminal_->rate();
  } else if (line_->has_partial()) {
    constexpr auto longest_silence = std::chrono::milliseconds(100);  // within a packet, as in servos
    heard.fell_silent = WallClock::now() - last_byte_ > longest_silence;
  }
  const bool client = terminal_->is_open();
  if (client != client_) heard.client = client;
  return heard;
}

namespace {

/// [bit/s]
// [bit/s]
double rate_of(const ExternalInput& note) {
  double rate = 0;
  std::from_chars(note.bytes.data(), note.bytes.data() + note.bytes.size(), rate);
  return std::isfinite(rate) && rate > 0 ? rate : SerialOptions::usual_rate;
}

}  // namespace

SerialSoftware::Heard SerialSoftware::repeat(Duration now) {
  Heard heard;
  for (; const ExternalInput* note = reader_.next(now); reader_.pass()) {
    if (note->kind == ExternalInput::came || note->kind == ExternalInput::left) {
      heard.client = note->kind == ExternalInput::came;
    } else if (note->kind == ExternalInput::asked) {
      heard.rate = rate_of(*note);
    } else if (note->time == now && note->kind == ExternalInput::sent) {
      heard.bytes.insert(heard.bytes.end(), note->bytes.begin(), note->bytes.end());
    } else if (note->time == now && note->kind == ExternalInput::fell_silent) {
      heard.fell_silent = true;
    }
  }
  if (heard.client == client_) heard.client.reset();  // unchanged by the jump in time
  return heard;
}

SerialSoftware::Heard SerialSoftware::remember() {
  Heard heard;
  for (; const ExternalInput* note = memory_->next(); memory_->pass()) {
    if (note->kind == ExternalInput::sent)
      heard.bytes.insert(heard.bytes.end(), note->bytes.begin(), note->bytes.end());
    if (note->kind == ExternalInput::asked) heard.rate = rate_of(*note);
    if (note->kind == ExternalInput::fell_silent) heard.fell_silent = true;
    if (note->kind == ExternalInput::left) line_->hang_up();  // independent of the client that is connected now
  }
  return heard;
}

SerialSoftware::Heard SerialSoftware::heard_at(Duration now) {
  if (remembers()) return remember();
  // bytes in transit at the time of the jump belong to another time
  const bool jumped = std::exchange(jumped_, false) && now != next_;
  if (jumped && !repeated_) line_->hang_up();
  next_ = now + from_seconds(period_);
  return repeated_ ? repeat(now) : listen(seconds(now));
}

/// What clients sent is written down, so that the run can be repeated without them.
void SerialSoftware::write_down(const Heard& heard) {
  const auto write = [&](ExternalInput::Kind kind, const std::string& bytes = {}) {
    pen_.write(kind, bytes);
    if (memory_) memory_->write(kind, bytes);
  };
  if (heard.rate) write(ExternalInput::asked, fmt::format("{:.0f}", *heard.rate));
  if (!heard.bytes.empty()) write(ExternalInput::sent, std::string(heard.bytes.begin(), heard.bytes.end()));
  if (heard.fell_silent) write(ExternalInput::fell_silent);
  if (heard.client) write(*heard.client ? ExternalInput::came : ExternalInput::left);
}

void SerialSoftware::exchange_bytes(Duration now) {
  const double time = seconds(now);
  const Heard heard = heard_at(now);
  pen_.at(now);
  if (!remembers()) write_down(heard);
  if (heard.rate) line_->set_rate(*heard.rate);
  if (!heard.bytes.empty()) line_->push(heard.bytes, time);
  if (heard.fell_silent) line_->forget_partial();
  if (heard.client) look_after(*heard.client);
  to_send_.clear();
  line_->run(time, to_send_);
  if (!to_send_.empty() && client_ && terminal_ && !remembers()) send();
}

void SerialSoftware::send() {
  const std::size_t sent = terminal_->send(to_send_);
  if (sent == to_send_.size() || std::exchange(told_of_loss_, true)) return;
  say_("the client of the serial line does not read: bytes are lost");
}

/// Told once for each client: a controller that reconnects often must not fill the log.
void SerialSoftware::look_after(bool client) {
  client_ = client;
  const std::string place = terminal_ ? link_place_.string() : "the serial line";
  if (client) {
    told_of_loss_ = false;
    say_(fmt::format("{} was opened", place));
  } else {
    line_->hang_up();
    if (terminal_) terminal_->discard();
    say_(fmt::format("{} was closed; torque and goals stay as they are", place));
  }
}

void SerialSoftware::command() {
  for (const Joint& joint : joints_) {
    const std::size_t i = joint.place.joint;
    const ServoDevice& servo = *joint.servo;
    enabled_->values[i] = servo.torque() ? 1 : 0;
    led_->values[i] = servo.led() ? 1 : 0;
    if (joint.own) tune(joint);
    if (rate_ && joint.turns) rate_->values[i] = joint.place.direction * servo.target_velocity();
    if (!servo.torque()) continue;
    const double target = joint.place.zero + joint.place.direction * servo.target();
    target_->values[i] =
        std::clamp(target, joint.range.x, joint.range.y);  // conversion to steps may exceed a limit by rounding
  }
}

/// Applies gains and limits of the registers to the simulated servo.
void SerialSoftware::tune(const Joint& joint) {
  const std::size_t i = joint.place.joint;
  MUROSIMF_ASSERT(joint.own != nullptr);
  const double own_damping = joint.own->law == "ideal_pd" ? joint.own->velocity_gain : 0;
  position_gain_->values[i] = joint.own->position_gain * joint.servo->gain_share();
  velocity_gain_->values[i] = own_damping + joint.own->position_gain * joint.servo->damping_time();
  if (joint.own->stall_torque > 0) torque_limit_->values[i] = joint.own->stall_torque * joint.servo->torque_share();
}

void SerialSoftware::state(StateArchive& archive) {
  for (const auto& device : bus_->devices()) device->state(archive);
  archive(*line_);
  if (!archive.loads()) return;
  jumped_ = true;
  reader_.rewind();
}

}  // namespace murosimf::serial
