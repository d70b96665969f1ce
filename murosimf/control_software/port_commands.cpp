#include "murosimf/control_software/port_commands.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "murosimf/control_software/game_view.h"
#include "murosimf/control_software/signal_row.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/leg.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::control_software {
namespace {

constexpr double any_target = 1e3;    // [rad | m] of joints without a range
constexpr double any_rate = 1e3;      // [rad/s | m/s]
constexpr double any_velocity = 100;  // [m/s, rad/s] far beyond any robot

constexpr std::string_view joint_target = "joint.target", joint_velocity_target = "joint.velocity_target",
                           joint_torque_enabled = "joint.torque_enabled", walk_velocity = "walk.velocity",
                           walk_other_joints = "walk.other_joints", motion_velocity = "motion.velocity",
                           motion_play = "motion.play", motion_kick = "motion.kick", game_answer_name = "game.answer",
                           position_gain = "joint.position_gain", velocity_gain = "joint.velocity_gain",
                           torque_limit = "joint.torque_limit", feed_forward = "joint.feed_forward",
                           joint_led = "joint.led", robot_led = "robot.led", motion_joints = "motion.joints";
constexpr std::array command_names{joint_target,  joint_velocity_target, joint_torque_enabled, position_gain,
                                   velocity_gain, torque_limit,          feed_forward,         joint_led,
                                   robot_led,     walk_velocity,         walk_other_joints,    motion_velocity,
                                   motion_play,   motion_kick,           motion_joints,        game_answer_name};

/// Start value of a servo's command and its upper limit.
std::pair<double, double> start_and_most(const Servo& servo, std::string_view command) {
  constexpr double gains = 21, longest = 0.5, any_torque = 1e6;  // [1], [s], [N m]
  const double own = servo.law == "ideal_pd" ? servo.velocity_gain : 0;
  if (command == position_gain) return {servo.position_gain, gains * servo.position_gain};
  if (command == velocity_gain) return {own, std::max(gains * own, longest * servo.position_gain)};
  const double most = servo.stall_torque > 0 ? servo.stall_torque : any_torque;
  if (command == feed_forward) return {0, most};
  return {most, most};
}

/// Which component moves the joints. [0]: the software itself, [1]: the walk engine, [2]: the motion engine; nothing: none.
std::optional<int> mover_of(std::string_view name) {
  if (name == joint_target) return 0;
  if (name == walk_velocity || name == walk_other_joints) return 1;
  if (name.starts_with("motion.")) return 2;  // signals, too
  return std::nullopt;
}

/// The walk moves these joints: targets for them would have no effect.
std::vector<int> joints_of_legs(const Model& model) {
  std::vector<int> joints;
  for (const locomotion::Leg& leg : locomotion::find_legs(model)) {
    joints.insert(joints.end(), leg.joints.begin(), leg.joints.end());
  }
  return joints;
}

}  // namespace

murosimf_command* PortCommands::find(std::string_view name) {
  const auto found = std::ranges::find(commands_, name, &Command::name);
  return &(found == commands_.end() ? make(name) : *found).row->shown_head<murosimf_command>();
}

const std::vector<std::string>* PortCommands::labels(std::string_view name) const {
  const auto found = std::ranges::find(commands_, name, &Command::name);
  return found == commands_.end() ? nullptr : &found->labels;
}

CommandRange PortCommands::range(std::string_view name) const {
  const auto found = std::ranges::find(commands_, name, &Command::name);
  MUROSIMF_ASSERT(found != commands_.end());
  return {found->lowest, found->highest};
}

bool PortCommands::has(std::string_view command) const {
  return std::ranges::find(commands_, command, &Command::name) != commands_.end();
}

bool PortCommands::walks() const { return has(walk_velocity) || has(walk_other_joints); }

bool PortCommands::uses_motions() const {
  return !watched_.empty() || has(motion_velocity) || has(motion_play) || has(motion_kick) || has(motion_joints);
}

void PortCommands::watch_motions(std::string_view signal) {
  if (!setup_) {
    throw SetupError(
        fmt::format("the signal '{}' was not asked for when the robot was set up, so it cannot be now", signal));
  }
  check_mover(signal);
  watched_ = signal;
}

/// Throws SetupError if another component moves the joints.
void PortCommands::check_mover(std::string_view name) const {
  const auto wanted = mover_of(name);
  const auto check = [&](std::string_view other) {
    const auto taken = mover_of(other);
    if (!wanted || !taken || *wanted == *taken) return;
    if (has(motion_joints) && *wanted != 1 && *taken != 1) return;  // which of them moves a joint is said while it runs
    throw SetupError(
        fmt::format("'{}' and '{}' exclude each other: joints follow joint.target, the walk engine (walk.velocity; "
                    "other joints: walk.other_joints) or the motion engine (motion.velocity); that and joint.target go "
                    "together once "
                    "motion.joints has been asked for",
                    other, name));
  };
  for (const Command& other : commands_) check(other.name);
  if (!watched_.empty()) check(watched_);
}

PortCommands::Command& PortCommands::make(std::string_view name) {
  if (!setup_) {
    throw SetupError(
        fmt::format("the command '{}' was not asked for when the robot was set up, so it cannot be now", name));
  }
  check_mover(name);
  Command command{.name = std::string(name)};
  connect(command);
  command.first.resize(command.places.size());
  MUROSIMF_ASSERT(command.declare && command.labels.size() == command.places.size());
  MUROSIMF_ASSERT(command.lowest.size() == command.places.size() && command.highest.size() == command.places.size());
  command.accepted = command.first;
  const std::size_t count = command.first.size();
  command.row = &rows_->add(command.name, numbers_text(count), sizeof(murosimf_command), count * sizeof(double),
                            GuardedRow::Use::write);
  command.staged = {command.row->body<double>(), count};
  std::ranges::copy(command.first, command.staged.begin());
  command.row->head<murosimf_command>() = {command.staged.data(), count};
  command.row->close_head();
  return commands_.emplace_back(std::move(command));
}

void PortCommands::connect(Command& command) {
  const std::string_view name = command.name;
  if (name == joint_target) {
    connect_joints(command, properties::joint_target, any_target, false);
    return leave_to_motions(command);
  }
  if (name == joint_velocity_target) return connect_joints(command, properties::joint_velocity_target, any_rate, false);
  if (name == walk_other_joints) return connect_joints(command, properties::joint_target, any_target, true);
  if (name == position_gain) return connect_servos(command, properties::servo_position_gain);
  if (name == velocity_gain) return connect_servos(command, properties::servo_velocity_gain);
  if (name == torque_limit) return connect_servos(command, properties::servo_torque_limit);
  if (name == feed_forward) return connect_servos(command, properties::servo_feed_forward);
  if (name == robot_led) return connect_led(command);
  if (name == walk_velocity || name == motion_velocity) return connect_walk(command);
  if (name == motion_play) return connect_motions(command);
  if (name == motion_kick) return connect_kick(command);
  if (name == game_answer_name) return connect_answer(command);
  connect_switch(command);
}

/// For all joints: on (1, the start value of all but the LEDs) or off.
void PortCommands::connect_switch(Command& command) {
  const std::string_view name = command.name;
  if (name != joint_torque_enabled && name != joint_led && name != motion_joints)
    throw SetupError(unknown_name("command", name, {command_names.begin(), command_names.end()}));
  connect_joints(command,
                 name == joint_led       ? properties::servo_led
                 : name == motion_joints ? properties::motion_joints
                                         : properties::torque_enabled,
                 1, false);
  if (name != joint_led) command.first.assign(command.places.size(), 1.0);
  std::ranges::fill(command.lowest, 0.0);
}

/// For all joints; those without a servo accept 0 only.
void PortCommands::connect_servos(Command& command, const Property<double>& property) {
  connect_joints(command, property, 0, false);
  MUROSIMF_ASSERT(command.places.size() == model_->joints().size());
  for (std::size_t i = 0; i < command.places.size(); ++i) {
    const Servo* servo = model_->find(properties::servo, model_->joints()[i]);
    const auto [start, most] = servo ? start_and_most(*servo, command.name) : std::pair(0.0, 0.0);
    command.first.push_back(start);
    command.lowest[i] = command.name == feed_forward ? -most : 0;
    command.highest[i] = most;
  }
}

/// Targets of joints that the motion engine moves are kept, not written.
void PortCommands::leave_to_motions(Command& command) {
  const auto found = std::ranges::find(commands_, motion_joints, &Command::name);
  if (found == commands_.end()) return;
  MUROSIMF_ASSERT(found->places.size() == command.places.size());
  command.others.assign(found->places.begin(), found->places.end());
}

void PortCommands::connect_led(Command& command) {
  Vec3d& color = setup_->write(properties::robot_led)[0];
  command.declare = [](Setup& setup) { (void)setup.write(properties::robot_led); };
  command.labels = {"red", "green", "blue"};
  command.places = {&color.x, &color.y, &color.z};
  command.lowest.assign(3, 0.0);
  command.highest.assign(3, 1.0);
}

void PortCommands::connect_joints(Command& command, const Property<double>& property, double limit, bool beside_legs) {
  const std::span<double> column = setup_->write(property);
  command.declare = [&property](Setup& setup) { (void)setup.write(property); };
  const std::vector<int> legs = beside_legs ? joints_of_legs(*model_) : std::vector<int>{};
  const bool positions = property.name == properties::joint_target.name;
  MUROSIMF_ASSERT(column.size() == model_->objects().size());
  for (const int joint : model_->joints()) {
    if (std::ranges::find(legs, joint) != legs.end()) continue;
    const Vec3d* range = positions ? model_->find(properties::joint_range, joint) : nullptr;
    command.labels.push_back(model_->objects()[joint].name);
    command.places.push_back(&column[joint]);
    command.lowest.push_back(range ? range->x : -limit);
    command.highest.push_back(range ? range->y : limit);
  }
}

void PortCommands::connect_walk(Command& command) {
  Vec3d& velocity = setup_->write(properties::walk_command)[0];
  command.declare = [](Setup& setup) { (void)setup.write(properties::walk_command); };
  command.labels = {"x", "y", "turn"};
  command.places = {&velocity.x, &velocity.y, &velocity.z};
  command.lowest.assign(3, -any_velocity);
  command.highest.assign(3, any_velocity);
}

void PortCommands::connect_motions(Command& command) {
  constexpr double any_request = 1e6;
  const locomotion::NamedMotions* motions = model_->find(properties::given_motions, 0);
  if (!motions || motions->empty()) throw SetupError("the robot's file names no motions ([motions], docs/motions.md)");
  locomotion::MotionRequests& requests = setup_->write(properties::motion_request)[0];
  command.declare = [](Setup& setup) { (void)setup.write(properties::motion_request); };
  // the request has a fixed size, since columns hold plain values
  for (std::size_t i = 0; i < std::min(motions->size(), locomotion::most_motions); ++i) {
    command.labels.push_back((*motions)[i].name);
    command.places.push_back(&requests.number[i]);
  }
  command.lowest.assign(command.places.size(), 0.0);
  command.highest.assign(command.places.size(), any_request);
}

void PortCommands::connect_kick(Command& command) {
  constexpr double any_request = 1e6, farthest = 10;  // [1], [m]
  const locomotion::NamedMotions* motions = model_->find(properties::given_motions, 0);
  if (!motions || !locomotion::has_kick(*motions))
    throw SetupError("no motion of the robot's file says where it kicks a ball (key 'kick', docs/motions.md)");
  locomotion::KickRequest& request = setup_->write(properties::kick_request)[0];
  command.declare = [](Setup& setup) { (void)setup.write(properties::kick_request); };
  command.labels = {"number", "direction", "side", "ball_x", "ball_y"};
  command.places = {&request.number, &request.direction, &request.side, &request.ball_x, &request.ball_y};
  command.lowest = {0, -pi, -1, -farthest, -farthest};
  command.highest = {any_request, pi, 1, farthest, farthest};
}

void PortCommands::connect_answer(Command& command) {
  command.declare = [](Setup& setup) { (void)setup.write(game_answer); };
  command.labels = {"message"};
  command.places = {&setup_->write(game_answer)[0]};
  command.first = {answer_alive};
  command.lowest = {0};
  command.highest = {highest_answer};
}

void PortCommands::use_link(const LinkOptions& options, std::uint64_t seed) {
  link_.emplace(options, seed, setup_->entity().name() + "/commands");
}

void PortCommands::reseed(std::uint64_t seed) {
  if (link_) link_->reseed(seed);
}

void PortCommands::declare(Setup& setup) const {
  for (const Command& command : commands_) command.declare(setup);
}

/// Software that begins again begins with the same commands as at the start.
void PortCommands::restart() noexcept {
  if (link_) link_->restart();
  for (Command& command : commands_) {
    for (std::size_t i = 0; i < command.staged.size(); ++i) {
      command.staged[i] = command.accepted[i] = command.first[i];
      command.write(i, command.first[i]);
    }
  }
}

std::size_t PortCommands::accept(Duration now) noexcept {
  std::size_t count = 0;
  // Refused numbers are replaced by the last accepted ones, in the software's memory, too: it sees what holds.
  refused_.command = nullptr;
  for (Command& command : commands_) {
    for (std::size_t i = 0; i < command.staged.size(); ++i) {
      double& staged = command.staged[i];
      const bool good = staged >= command.lowest[i] && staged <= command.highest[i];  // not if it is NaN
      if (good) {
        command.accepted[i] = staged;
      } else {
        if (count++ == 0) refused_ = {&command, i, staged};
        staged = command.accepted[i];
      }
      if (!link_) command.write(i, command.accepted[i]);
    }
  }
  if (link_) send(now);
  return count;
}

std::vector<double> PortCommands::numbers_set() const {
  const auto same = [](const Command& command) {  // bit for bit: also of numbers that are none
    return std::memcmp(command.staged.data(), command.accepted.data(), command.staged.size() * sizeof(double)) == 0;
  };
  std::vector<double> numbers;
  if (std::ranges::all_of(commands_, same)) return numbers;
  for (const Command& command : commands_) {
    numbers.insert(numbers.end(), command.staged.begin(), command.staged.end());
  }
  return numbers;
}

void PortCommands::set_numbers(std::span<const double> numbers) noexcept {
  for (Command& command : commands_) {
    if (numbers.size() < command.staged.size()) return;
    std::ranges::copy(numbers.first(command.staged.size()), command.staged.begin());
    numbers = numbers.subspan(command.staged.size());
  }
}

void PortCommands::send(Duration now) {
  sent_.clear();
  for (const Command& command : commands_) {
    sent_.insert(sent_.end(), command.accepted.begin(), command.accepted.end());
  }
  link_->send(now, sent_);
}

void PortCommands::deliver(Duration now) noexcept {
  const std::vector<double>* const arrived = link_ ? link_->receive(now) : nullptr;
  if (!arrived) return;
  auto number = arrived->begin();
  for (const Command& command : commands_) {
    for (std::size_t i = 0; i < command.places.size(); ++i) command.write(i, *number++);
  }
}

void PortCommands::settle() noexcept {
  for (const Command& command : commands_) {
    for (std::size_t i = 0; i < command.places.size(); ++i) command.write(i, command.accepted[i]);
  }
  if (link_) link_->restart();
}

std::string PortCommands::refusal() const {
  if (!refused_.command) return {};
  const Command& command = *refused_.command;
  MUROSIMF_ASSERT(refused_.number < command.labels.size());
  return fmt::format("{} of {} is {:.6g}, not in {:.6g} to {:.6g}", command.name, command.labels[refused_.number],
                     refused_.value, command.lowest[refused_.number], command.highest[refused_.number]);
}

void PortCommands::state(StateArchive& archive) {
  for (Command& command : commands_) {
    archive.elements(std::span(command.accepted));
    if (archive.loads()) std::ranges::copy(command.accepted, command.staged.begin());
  }
  if (link_) archive(*link_);
}

}  // namespace murosimf::control_software
