#include "murosimf/connect/robot_port.h"

#include <algorithm>
#include <cmath>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::connect {

RobotPort::RobotPort(Setup& setup) : model_(&setup.model()), commands_(setup), radio_(setup), game_(setup) {
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
    signals_.back().shown = {values.data(), values.size(), 0, 0};
  }
}

void RobotPort::add_joints(std::string name, std::span<const double> column, bool in_steps) {
  signals_.push_back({.name = std::move(name), .column = column});
  Signal& signal = signals_.back();
  for (const int joint : model_->joints()) {
    signal.labels.push_back(model_->objects()[joint].name);
    const Servo* servo = model_->find(properties::servo, joint);
    signal.steps.push_back(in_steps && servo ? servo->encoder_step : 0);
  }
  signal.values.resize(signal.labels.size());
  signal.shown = {signal.values.data(), signal.values.size(), 0, 0};
}

std::vector<std::string_view> RobotPort::signal_names() const {
  std::vector<std::string_view> names;
  for (const Signal& signal : signals_) names.push_back(signal.name);
  for (const std::string_view name : GameSignals::names()) names.push_back(name);
  return names;
}

const murosimf_signal* RobotPort::signal(std::string_view name) {
  if (const murosimf_signal* of_game = game_.find(name)) return of_game;
  const auto found = std::ranges::find(signals_, name, &Signal::name);
  if (found == signals_.end()) throw SetupError(unknown_name("signal", name, signal_names()));
  found->wanted = true;
  return &found->shown;
}

const std::vector<std::string>* RobotPort::labels(std::string_view name) const {
  if (const auto* of_game = GameSignals::labels(name)) return of_game;
  const auto signal = std::ranges::find(signals_, name, &Signal::name);
  return signal != signals_.end() ? &signal->labels : commands_.labels(name);
}

void RobotPort::refresh(Duration now) noexcept {
  radio_.refresh(now);
  game_.refresh();
  for (Signal& signal : signals_) {
    if (signal.wanted) refresh(signal, now);
  }
}

void RobotPort::refresh(Signal& signal, Duration now) noexcept {
  if (signal.reading) {
    signal.shown.time = signal.reading->time.count();
    signal.shown.samples = signal.reading->samples;
    return;
  }
  const std::span<const int> joints = model_->joints();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const double value = signal.column[joints[i]], step = signal.steps[i];
    signal.values[i] = step > 0 ? step * std::round(value / step) : value;
  }
  signal.shown.time = now.count();
  ++signal.shown.samples;
}

void RobotPort::state(StateArchive& archive) {
  commands_.state(archive);
  for (Signal& signal : signals_) archive(signal.shown.samples);
}

}  // namespace murosimf::connect
