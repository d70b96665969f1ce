#include "murosimf/logging/run_log.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/files/output_file.h"
#include "murosimf/logging/log_npy.h"
#include "murosimf/model/error.h"

namespace murosimf::logging {
namespace {

void check_rate(const RunLogOptions& options) {
  const double rate = options.property_rate;
  if (rate >= slowest_rate && rate <= options.step_rate) return;
  throw SetupError(fmt::format("properties cannot be logged at {} Hz; write a rate from {} to the {} steps per second",
                               rate, slowest_rate, options.step_rate));
}

LoggedSensor& sensor_named(std::vector<LoggedSensor>& sensors, const std::string& name) {
  for (LoggedSensor& known : sensors) {
    if (known.sensor == name) return known;
  }
  sensors.push_back({.sensor = name, .numbers = {}, .names = {}});
  return sensors.back();
}

}  // namespace

RunLog::RunLog(Simulation& simulation, const std::vector<std::string>& patterns, const RunLogOptions& options)
    : simulation_(simulation),
      patterns_(patterns),
      step_rate_(options.step_rate),
      property_rate_(options.property_rate) {
  check_rate(options);
  add(logged_at_start(options));
  // scheduled after the simulation's own events: a loaded state does not contain the log
  simulation_.after_start([this] {
    notes_begun_ = !properties_.empty();
    if (notes_begun_) simulation_.at(Duration{}, [this] { note_properties(); });
  });
  simulation_.after_addition([this](Entity& entity) { add_newcomer(entity); });
}

std::vector<LoggedNumber> RunLog::logged_at_start(const RunLogOptions& options) const {
  if (!options.others_come) return find_logged(simulation_.world(), patterns_);
  std::vector<std::string> known;
  for (const std::string& pattern : patterns_) {
    if (denotes_entity(simulation_.world(), pattern)) {
      known.push_back(pattern);
    } else {
      simulation_.warn(
          fmt::format("--log '{}': nobody is called so yet; its columns begin when somebody comes", pattern));
    }
  }
  return find_logged(simulation_.world(), known);
}

void RunLog::add(const std::vector<LoggedNumber>& logged) {
  for (const auto& entity : simulation_.world().entities()) attach_sensor_log(*entity, logged);
  for (const LoggedNumber& number : logged) {
    if (number.sensor.empty()) add_property(number);
  }
}

/// In a running simulation: properties are noted with the next ones of all, the first ones at the instants that they would have had.
void RunLog::add_newcomer(Entity& entity) {
  add(find_logged(entity, patterns_));
  if (notes_begun_ || properties_.empty()) return;
  notes_begun_ = true;
  note_again(simulation_.now());
}

void RunLog::attach_sensor_log(Entity& entity, const std::vector<LoggedNumber>& logged) {
  std::vector<LoggedSensor> sensors;
  for (const LoggedNumber& number : logged) {
    if (number.entity != &entity || number.sensor.empty()) continue;
    LoggedSensor& sensor = sensor_named(sensors, number.sensor);
    sensor.numbers.push_back(number.index);
    sensor.names.push_back(number.name());
  }
  if (sensors.empty()) return;
  sensor_logs_.push_back(&simulation_.attach<SensorLog>("sensor_log", entity, step_rate_, sensors));
}

/// Numbers of one property follow each other: they share one series, whose row is read at once.
void RunLog::add_property(const LoggedNumber& number) {
  const bool next = properties_.empty() || properties_.back().entity != number.entity ||
                    properties_.back().object != number.object || properties_.back().property != number.property;
  if (next) properties_.push_back({number.entity, number.object, number.property, {}, {}});
  properties_.back().numbers.push_back(number.index);
  properties_.back().series.names.push_back(number.name());
}

void RunLog::note_properties() {
  for (PropertyLog& one : properties_) {
    const ColumnBase* column = one.entity->find(one.property);
    if (!column || !one.entity->present()) continue;  // its level was exchanged, or it has left
    const Quantity quantity = ObjectAccess(*one.entity, one.object).get(one.property);
    one.series.times.push_back(simulation_.now());
    for (const std::size_t number : one.numbers) one.series.values.push_back(quantity.numbers[number]);
  }
  note_again(simulation_.now() + Duration{1});
}

/// At the next of its instants that is not before `earliest`: after a state was loaded, it is not just the next one.
void RunLog::note_again(Duration earliest) {
  Duration next{};
  do {
    next = from_seconds(static_cast<double>(++notes_) / property_rate_);
  } while (next < earliest);
  simulation_.at(next, [this] { note_properties(); });
}

std::vector<const LogSeries*> RunLog::noted() const {
  std::vector<const LogSeries*> all;
  for (const SensorLog* log : sensor_logs_) {
    for (const LogSeries& series : log->series()) all.push_back(&series);
  }
  for (const PropertyLog& log : properties_) all.push_back(&log.series);
  return all;
}

void RunLog::write(const std::filesystem::path& file) const {
  files::write_file(file, is_named_npy(file) ? to_npy(noted()) : csv());
}

}  // namespace murosimf::logging
