#include "murosimf/identification/servo_log_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/input_file.h"
#include "murosimf/files/text_encoding.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::identification {
namespace {

namespace fs = std::filesystem;
using identification::ServoLog;
using identification::ServoSample;
using nlohmann::json;

constexpr double longest_log = 3600;  // [s]; more is an error in the unit

/// Message "line 3: 'NaN' is ..." for the place where the parser stopped.
std::string what_is_wrong(const std::string& text, std::size_t byte) {
  const auto place = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  const auto line = 1 + std::count(text.begin(), place, '\n');
  const std::string around(place - std::min<std::ptrdiff_t>(4, place - text.begin()), place);
  // Python writes NaN and Infinity, which are not JSON: a frequent case with its own advice.
  const bool no_number = around.find('N') != std::string::npos || around.find('I') != std::string::npos;
  return fmt::format("line {}: {}", line,
                     no_number ? "a value is NaN or infinite; leave that entry out" : "this is no JSON");
}

json parse(const std::string& text) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    throw SetupError(what_is_wrong(text, error.byte));
  } catch (const json::exception&) {
    throw SetupError("a number in it is too large");
  }
}

const json& field(const json& object, const char* name) {
  if (!object.is_object()) throw SetupError("this is no object with fields in braces");
  const auto found = object.find(name);
  if (found == object.end()) throw SetupError(fmt::format("field '{}' is missing", name));
  return *found;
}

double number(const json& object, const char* name) {
  const json& value = field(object, name);
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    throw SetupError(fmt::format("'{}' must be a finite number", name));
  }
  return value.get<double>();
}

double positive(const json& object, const char* name) {
  const double value = number(object, name);
  if (!(value > 0)) throw SetupError(fmt::format("'{}' must be above 0", name));
  return value;
}

double not_negative(const json& object, const char* name) {
  const double value = number(object, name);
  if (!(value >= 0)) throw SetupError(fmt::format("'{}' must be at least 0", name));
  return value;
}

bool yes_or_no(const json& object, const char* name) {
  const json& value = field(object, name);
  if (!value.is_boolean()) throw SetupError(fmt::format("'{}' must be true or false", name));
  return value.get<bool>();
}

std::string name_of(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

ServoSample sample_of(const json& entry) {
  return {.time = number(entry, "timestamp"),
          .position = number(entry, "position"),
          .rate = number(entry, "speed"),
          .voltage = positive(entry, "input_volts"),
          .goal = number(entry, "goal_position"),
          .enabled = yes_or_no(entry, "torque_enable")};
}

std::vector<ServoSample> samples_of(const json& entries) {
  if (!entries.is_array()) throw SetupError("'entries' must be a list");
  if (entries.size() < 2) throw SetupError(fmt::format("'entries' has {} entries; at least 2", entries.size()));
  std::vector<ServoSample> samples;
  for (const json& entry : entries) {
    with_context(fmt::format("entry {}", samples.size() + 1), [&] {
      const ServoSample sample = sample_of(entry);
      if (!samples.empty() && !(sample.time > samples.back().time)) {
        throw SetupError(
            fmt::format("timestamp {} is not after {} of the entry before", sample.time, samples.back().time));
      }
      samples.push_back(sample);
    });
  }
  const double start = samples.front().time;
  for (ServoSample& sample : samples) sample.time -= start;
  if (samples.back().time > longest_log) {
    throw SetupError(fmt::format("it lasts {} s; 'timestamp' is in seconds", samples.back().time));
  }
  MUROSIMF_ASSERT(samples.size() >= 2 && samples.front().time == 0);
  return samples;
}

ServoLog log_of(const json& log) {
  return {.name = {},
          .motor = name_of(log, "motor"),
          .trajectory = name_of(log, "trajectory"),
          .mass = positive(log, "mass"),
          .length = positive(log, "length"),
          .arm_mass = log.contains("arm_mass") ? not_negative(log, "arm_mass") : 0,
          .firmware_gain = not_negative(log, "kp"),
          .samples = samples_of(field(log, "entries"))};
}

std::vector<fs::path> files_of(const fs::path& name) {
  std::error_code error;
  if (!fs::exists(name, error)) throw SetupError(fmt::format("there is no log '{}'", name.string()));
  if (!fs::is_directory(name, error)) return {name};
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(name, error)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (error) throw SetupError(fmt::format("folder '{}' cannot be read: {}", name.string(), error.message()));
  if (files.empty()) throw SetupError(fmt::format("folder '{}' has no logs (*.json)", name.string()));
  std::ranges::sort(files);
  return files;
}

}  // namespace

ServoLog read_servo_log(const fs::path& file) {
  const std::string text = files::read_text_file(file, files::most_record_bytes);
  return with_context(file.string(), [&] {
    const json content = parse(text);
    ServoLog log = log_of(content);
    log.name = file.stem().string();
    return log;
  });
}

std::vector<ServoLog> read_servo_logs(const std::vector<std::string>& names) {
  if (names.empty()) throw SetupError("no log is named");
  std::vector<ServoLog> logs;
  for (const std::string& name : names) {
    for (const fs::path& file : files_of(name)) logs.push_back(read_servo_log(file));
  }
  return logs;
}

}  // namespace murosimf::identification
