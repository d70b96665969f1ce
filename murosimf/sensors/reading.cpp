#include "murosimf/sensors/reading.h"

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::sensors {
namespace {

constexpr std::string_view prefix = "sensor.";

std::string column_name(std::string_view sensor) { return std::string(prefix) + std::string(sensor); }

/// `name` must outlive the use of the descriptor; columns keep a copy.
Property<Reading> property_of(const std::string& name) {
  return {{name, "-", "-", "last sample of a sensor", Scope::sensor}};
}

[[noreturn]] void refuse_unknown(const Entity& entity, std::string_view sensor) {
  std::vector<std::string_view> names;
  for (const Reading* reading : readings_of(entity)) names.push_back(reading->info->name);
  if (names.empty()) throw SetupError(fmt::format("'{}' has no sensor '{}', nor any other", entity.name(), sensor));
  throw SetupError(fmt::format("'{}': {}", entity.name(), unknown_name("sensor", sensor, names)));
}

}  // namespace

std::size_t SensorInfo::numbers() const {
  std::size_t sum = 0;
  for (const Output& output : outputs) sum += output.size();
  return sum;
}

std::span<const double> Reading::output(std::string_view name) const {
  std::size_t first = 0;
  MUROSIMF_ASSERT(info);
  std::vector<std::string_view> names;
  for (const Output& output : info->outputs) {
    if (output.name == name) return std::span(values).subspan(first, output.size());
    first += output.size();
    names.push_back(output.name);
  }
  throw SetupError(fmt::format("sensor '{}': {}", info->name, unknown_name("output", name, names)));
}

void append_hash(Hasher& hasher, const Reading& reading) {
  hasher.add(static_cast<std::uint64_t>(reading.time.count()));
  hasher.add(reading.samples);
  for (const double value : reading.values) hasher.add(value);
}

void state(StateArchive& archive, Reading& reading) {
  archive(reading.time, reading.samples);
  archive.elements(std::span(reading.values));
}

std::uint64_t hash_of(const Reading& reading) {
  Hasher hasher;
  append_hash(hasher, reading);
  return hasher.value();
}

Reading& write_reading(Setup& setup, SensorInfo info) {
  // two sensors would write one column
  if (find_reading(setup.entity(), info.name)) {
    throw SetupError(fmt::format("'{}' has two sensors called '{}'", setup.entity().name(), info.name));
  }
  const std::string name = column_name(info.name);
  Reading& reading = setup.write(property_of(name))[0];
  reading.values.assign(info.numbers(), 0.0);
  reading.info = std::make_shared<const SensorInfo>(std::move(info));
  MUROSIMF_ASSERT(reading.values.size() == reading.info->numbers());
  return reading;
}

const Reading& read_reading(Setup& setup, std::string_view sensor) {
  if (!find_reading(setup.entity(), sensor)) refuse_unknown(setup.entity(), sensor);
  const std::string name = column_name(sensor);
  return setup.read(property_of(name))[0];
}

std::span<const double> read_output(Setup& setup, std::string_view path) {
  const std::size_t dot = path.find('.');
  const Reading& reading = read_reading(setup, path.substr(0, dot));
  // "sensor.output", or just "sensor" if it has one output
  if (dot != std::string_view::npos) return reading.output(path.substr(dot + 1));
  if (reading.info->outputs.size() == 1) return reading.values;
  throw SetupError(fmt::format("sensor '{}' has several outputs: say which, like '{}.{}'", path, path,
                               reading.info->outputs[0].name));
}

const Reading* find_reading(const Entity& entity, std::string_view sensor) {
  const std::string name = column_name(sensor);
  const Column<Reading>* column = entity.find(property_of(name));
  return column && column->values[0].info ? &column->values[0] : nullptr;
}

std::vector<const Reading*> readings_of(const Entity& entity) {
  std::vector<const Reading*> readings;
  for (const auto& [name, column] : entity.columns()) {
    if (column->info().scope == Scope::sensor && column->type() == typeid(Reading)) {
      readings.push_back(&static_cast<const Column<Reading>&>(*column).values[0]);
    }
  }
  return readings;
}

}  // namespace murosimf::sensors
