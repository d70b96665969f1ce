#include "murosimf/control_software/robot_port.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "murosimf/control_software/signal_row.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/motion_report.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::control_software {
namespace {

constexpr std::array<std::string_view, 4> motion_signals{"motion.mode", "motion.phase", "motion.odometry",
                                                         "motion.fallen"};

}  // namespace

RobotPort::RobotPort(Setup& setup, const ControlLinkOptions& link, std::uint64_t seed)
    : setup_(&setup),
      model_(&setup.model()),
      commands_(setup, rows_),
      radio_(setup),
      game_(setup, rows_),
      pictures_(setup, rows_),
      pad_(setup) {
  if (link.does_something() && link.signals) link_.emplace(link.one_way(), seed, setup.entity().name() + "/signals");
  if (link.does_something() && link.commands) commands_.use_link(link.one_way(), seed);
  for (const sensors::Reading* reading : sensors::readings_of(setup.entity())) add_sensor(setup, *reading);
  if (model_->joints().empty()) return;
  add_joints("joint.position", setup.read(properties::joint_position), true);
  add_joints("joint.velocity", setup.read(properties::joint_velocity), false);
  add_joints("joint.torque", setup.observe(properties::joint_torque), false);
}

void RobotPort::add_sensor(Setup& setup, const sensors::Reading& found) {
  const sensors::Reading& reading = sensors::read_reading(setup, found.info->name);
  for (const sensors::Output& output : reading.info->outputs) {
    const std::span<const double> values = reading.output(output.name);
    signals_.push_back({.name = reading.info->name + "." + output.name, .labels = output.labels, .reading = &reading});
    if (output.labels.empty() && values.size() == 1) signals_.back().labels = {output.name};
    signals_.back().measured = values;
    if (link_) signals_.back().values.resize(values.size());
  }
}

void RobotPort::add_joints(std::string name, std::span<const double> column, bool in_steps) {
  MUROSIMF_ASSERT(column.size() == model_->objects().size());
  Signal signal{.name = std::move(name)};
  std::vector<double> steps;  // [rad] 0: none
  for (const int joint : model_->joints()) {
    signal.labels.push_back(model_->objects()[joint].name);
    const Servo* servo = model_->find(properties::servo, joint);
    steps.push_back(in_steps && servo ? servo->encoder_step : 0);
  }
  signal.values.resize(signal.labels.size());
  signal.measure = [column, joints = model_->joints(), steps = std::move(steps)](std::size_t i) {
    const double value = column[joints[i]], step = steps[i];
    return step > 0 ? step * std::round(value / step) : value;
  };
  signals_.push_back(std::move(signal));
}

/// Called only when software requests them: other robots have none of these columns.
void RobotPort::add_motions() {
  const locomotion::NamedMotions* const given = model_->find(properties::given_motions, 0);
  static const locomotion::NamedMotions none;
  const auto report = [&motions = given ? *given : none, state = setup_->input(properties::motion_state, {}).data(),
                       gait = setup_->input(properties::gait_state, {}).data(),
                       amplitude = setup_->input(properties::gait_amplitude, 0).data()] {
    return locomotion::motion_report(motions, *state, *gait, *amplitude);
  };
  const Vec3d* const odometry = setup_->input(properties::odometry, {}).data();
  const auto add = [this](std::string name, std::vector<std::string> labels,
                          std::function<double(std::size_t)> number) {
    Signal signal{.name = std::move(name), .labels = std::move(labels), .measure = std::move(number)};
    signal.values.resize(signal.labels.size());
    signals_.push_back(std::move(signal));
  };
  add("motion.mode", {"mode"}, [report](std::size_t) { return static_cast<double>(report().activity); });
  add("motion.fallen", {"fallen"}, [report](std::size_t) { return report().fallen ? 1.0 : 0.0; });
  add("motion.odometry", {"x", "y", "heading"}, [odometry](std::size_t i) {
    return i == 0 ? odometry->x : i == 1 ? odometry->y : odometry->z;
  });
  std::vector<std::string> names;
  for (const locomotion::NamedMotion& motion : given ? *given : none) names.push_back(motion.name);
  add("motion.phase", std::move(names), [report](std::size_t i) {
    const locomotion::MotionReport now = report();
    return now.motion == static_cast<int>(i) ? now.phase : -1.0;
  });
}

std::vector<std::string_view> RobotPort::signal_names() const {
  std::vector<std::string_view> names;
  for (const Signal& signal : signals_) names.push_back(signal.name);
  for (const std::string_view name : motion_signals) names.push_back(name);
  for (const std::string_view name : GameSignals::names()) names.push_back(name);
  return names;
}

const murosimf_signal* RobotPort::signal(std::string_view name) {
  if (const murosimf_signal* of_game = game_.find(name)) return of_game;
  auto found = std::ranges::find(signals_, name, &Signal::name);
  if (found == signals_.end() && std::ranges::find(motion_signals, name) != motion_signals.end()) {
    commands_.watch_motions(name);
    add_motions();
    found = std::ranges::find(signals_, name, &Signal::name);
  }
  if (found == signals_.end()) throw SetupError(unknown_name("signal", name, signal_names()));
  found->asked = true;
  if (!found->row) found->row = &show_numbers(rows_, found->name, found->numbers(), found->now);
  // Rows in transit have another length once a signal is added.
  if (!std::exchange(found->wanted, true) && link_) link_->drop();
  return &found->row->shown_head<const murosimf_signal>();
}

/// Rows on their way have the old length: they are dropped when another signal is requested.
void RobotPort::renew_requests() noexcept {
  bool any = false;
  for (Signal& signal : signals_) {
    any = any || (signal.asked && !signal.wanted);
    signal.wanted = signal.wanted || signal.asked;
  }
  if (any && link_) link_->drop();
}

void RobotPort::listen() {
  heard_ = {};
  used_ = {};
  note_ = &heard_;
  radio_.note_use(&used_);
}

CallNote RobotPort::told() {
  MUROSIMF_ASSERT(note_ != nullptr);
  note_ = nullptr;
  radio_.note_use(nullptr);
  heard_.received = used_.received;
  heard_.sent = std::move(used_.sent);
  heard_.commands = commands_.numbers_set();
  return std::move(heard_);
}

void RobotPort::repeat(const CallNote& note) noexcept {
  for (std::uint64_t i = 0; i < note.received; ++i) (void)radio_.receive();
  for (const std::string& message : note.sent) (void)radio_.send(message);
  for (const DrawnGroup& group : note.drawn) (void)draw(group);
  commands_.set_numbers(note.commands);
}

const std::vector<std::string>* RobotPort::labels(std::string_view name) const {
  if (const auto* of_game = GameSignals::labels(name)) return of_game;
  const auto signal = std::ranges::find(signals_, name, &Signal::name);
  return signal != signals_.end() ? &signal->labels : commands_.labels(name);
}

/// Over a link, software sees what has arrived; without one, what is.
void RobotPort::refresh(Duration now) noexcept {
  now_ = now;
  radio_.refresh(now);
  game_.refresh();
  pictures_.refresh();
  if (link_) {
    send_over_link(now);
    return receive_over_link(now);
  }
  for (Signal& signal : signals_) {
    if (signal.wanted) refresh(signal, now);
  }
}

/// Sends time, number of samples and numbers of each requested signal.
void RobotPort::send_over_link(Duration now) {
  MUROSIMF_ASSERT(link_);
  sent_.clear();
  for (Signal& signal : signals_) {
    if (!signal.wanted) continue;
    const bool of_sensor = signal.reading != nullptr;
    sent_.push_back(static_cast<double>(of_sensor ? signal.reading->time.count() : now.count()));
    sent_.push_back(static_cast<double>(of_sensor ? signal.reading->samples : ++signal.measurements));
    if (of_sensor) {
      sent_.insert(sent_.end(), signal.measured.begin(), signal.measured.end());
    } else {
      for (std::size_t i = 0; i < signal.values.size(); ++i) sent_.push_back(signal.measure(i));
    }
  }
  link_->send(now, sent_);
}

/// The row has the signals that were wanted when it was sent, which renew_requests() guarantees.
void RobotPort::receive_over_link(Duration now) noexcept {
  const std::vector<double>* const arrived = link_->receive(now);
  if (!arrived) return;
  auto number = arrived->begin();
  for (Signal& signal : signals_) {
    if (!signal.wanted) continue;
    signal.now.time = static_cast<std::int64_t>(*number++);
    signal.now.samples = static_cast<std::uint64_t>(*number++);
    for (double& value : signal.values) value = *number++;
    show(signal);
  }
  MUROSIMF_ASSERT(number == arrived->end());
}

/// Over a link, software has seen nothing until the first row arrives.
void RobotPort::restart() noexcept {
  commands_.restart();
  pad_.clear();
  now_ = {};
  if (link_) link_->restart();
  for (Signal& signal : signals_) {
    if (link_) {
      signal.measurements = signal.now.samples = 0;
      signal.now.time = 0;
      std::ranges::fill(signal.values, 0.0);
    }
    show(signal);
  }
}

void RobotPort::reseed(std::uint64_t seed) {
  commands_.reseed(seed);
  if (link_) link_->reseed(seed);
}

void RobotPort::refresh(Signal& signal, Duration now) noexcept {
  if (signal.reading) {
    signal.now.time = signal.reading->time.count();
    signal.now.samples = signal.reading->samples;
    return show(signal);
  }
  for (std::size_t i = 0; i < signal.values.size(); ++i) signal.values[i] = signal.measure(i);
  signal.now.time = now.count();
  ++signal.now.samples;
  show(signal);
}

void RobotPort::show(const Signal& signal) noexcept {
  if (signal.row) show_numbers(*signal.row, signal.numbers(), signal.now);
}

void RobotPort::state(StateArchive& archive) {
  commands_.state(archive);
  if (archive.loads()) pictures_.forget();  // their numbers may repeat with other contents
  for (Signal& signal : signals_) archive(signal.wanted, signal.now.samples);
  if (!link_) return;
  archive(*link_);
  for (Signal& signal : signals_) archive(signal.now.time, signal.measurements, signal.values);
  if (!archive.loads()) return;
  for (const Signal& signal : signals_) show(signal);
}

}  // namespace murosimf::control_software
