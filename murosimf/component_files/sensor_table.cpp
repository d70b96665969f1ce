#include "murosimf/component_files/sensor_table.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "murosimf/component_files/camera_info.h"
#include "murosimf/component_files/sensor_keys.h"
#include "murosimf/component_files/sensor_toml.h"
#include "murosimf/component_files/sensor_types.h"
#include "murosimf/files/data_path.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/sensors/camera_spec.h"

namespace murosimf::component_files {
namespace {

using sensors::SensorSpec;
using Names = std::vector<std::string_view>;

bool contains(const Names& names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }

/// Applies a table to a spec of known type.
class Changer {
 public:
  explicit Changer(SensorSpec& spec) : spec_(spec), type_(sensor_types().find(spec.type)) {}

  /// `keys`: those of sensor_keys that the table may have.
  void take(const SensorTable& table, const Names& keys, const std::filesystem::path& beside) {
    check_keys(table, keys);
    if (const auto file = table.values.find("calibration"); file != table.values.end()) {
      take_calibration(table, file->second, beside);  // first: the keys beside it replace its numbers
    }
    SensorValues signal;
    for (const auto& [key, value] : table.values) {
      const bool own = contains(keys, key) || is_own(key);
      if (own) {
        take_value(key, value);
      } else {
        signal.emplace(key, value);
      }
    }
    if (signal.empty()) return;
    spec_.signals.try_emplace("");
    for (auto& [output, numbers] : spec_.signals) change_signal(numbers, signal);
  }

  void take_outputs(const SensorTable& table, bool of_part) {
    for (const auto& [output, values] : table.outputs) {
      const bool known = spec_.signals.contains(output);
      if (of_part && !known) spec_.part_outputs.insert(output);
      if (!of_part) spec_.part_outputs.erase(output);
      change_signal(spec_.signals.try_emplace(output, spec_.signal(output)).first->second, values);
      // A table of a vector also changes the tables of its components.
      for (auto& [number, signal] : spec_.signals) {
        if (number.starts_with(output + ".")) change_signal(signal, values);
      }
    }
  }

 private:
  void check_keys(const SensorTable& table, Names known) const {
    if (!type_.objects.empty()) known.push_back(type_.objects);
    for (const auto* options : {&type_.options, &signal_keys()}) {
      for (const OptionInfo& option : *options) known.push_back(option.name);
    }
    for (const auto& [key, value] : table.values) {
      if (contains(known, key)) continue;
      fail(value.where, unknown_name(fmt::format("key of sensor type '{}',", type_.name), key, known));
    }
  }

  /// Whether the type has a key of this name.
  [[nodiscard]] bool is_own(std::string_view key) const {
    return (!type_.objects.empty() && key == type_.objects) || find_option(type_.options, key);
  }

  /// Applies the numbers of a calibration file; scaled, if the table gives another size of the picture.
  void take_calibration(const SensorTable& table, const SensorValue& value, const std::filesystem::path& beside) {
    const std::string name = name_of("calibration", value);
    const auto file = with_context(value.where, [&] { return find_lens_file(name, beside); });
    const imaging::LensSpec lens = with_context(value.where, [&] { return read_calibration(file).lens; });
    const auto scale = [&](const char* key, int size) {
      const auto other = table.values.find(key);
      return other == table.values.end() ? 1 : finite_number(key, other->second) / size;
    };
    const double x = scale("width", lens.width), y = scale("height", lens.height);
    // Coefficients of another lens model must not remain.
    for (const std::string_view model : imaging::lens_models()) {
      for (const std::string& key : sensors::lens_coefficients(model)) spec_.numbers.erase(key);
    }
    spec_.texts["lens"] = lens.model;
    spec_.numbers["width"] = lens.width;
    spec_.numbers["height"] = lens.height;
    spec_.numbers["fx"] = x * lens.fx;
    spec_.numbers["fy"] = y * lens.fy;
    spec_.numbers["skew"] = x * lens.skew;
    spec_.numbers["cx"] = x * (lens.cx + 0.5) - 0.5;  // pixels begin half of one before their middle
    spec_.numbers["cy"] = y * (lens.cy + 0.5) - 0.5;
    const auto keys = sensors::lens_coefficients(lens.model);
    for (std::size_t i = 0; i < keys.size() && i < lens.coefficients.size(); ++i) {
      spec_.numbers[keys[i]] = lens.coefficients[i];
    }
  }

  void take_value(const std::string& key, const SensorValue& value) {
    if (key == type_.objects) {
      spec_.objects = names_of(key, value);
    } else if (const OptionInfo* own = find_option(type_.options, key)) {
      if (key != "calibration") take_own(key, checked_value(*own, value));  // that one is taken already
    } else if (key != "type" && key != "part") {                            // so are these
      MUROSIMF_ASSERT(find_option(sensor_keys().infos(), key) != nullptr);
      const OptionInfo& common = *find_option(sensor_keys().infos(), key);
      sensor_keys().apply({{key, checked_value(common, value)}}, spec_);
    }
  }

  void take_own(const std::string& key, const OptionValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) {
      spec_.texts[key] = *text;
    } else if (const bool* truth = std::get_if<bool>(&value)) {
      spec_.numbers[key] = *truth ? 1 : 0;
    } else {
      spec_.numbers[key] = std::get<double>(value);
    }
  }

  SensorSpec& spec_;
  const SensorType& type_;
};

std::optional<std::string> text_of(const SensorTable& table, const std::string& key) {
  const auto found = table.values.find(key);
  if (found == table.values.end()) return std::nullopt;
  return name_of(key, found->second);
}

SensorTable read_part(const std::string& name, const std::string& where, const std::filesystem::path& beside) {
  if (const auto file = files::look_for_data_file(name, "parts", ".toml", beside)) return read_part_file(*file);
  const auto names = sensor_parts();
  fail(where, unknown_name("part", name, Names(names.begin(), names.end())));
}

void check_signals(const SensorSpec& spec) {
  for (const auto& [output, signal] : spec.signals) {
    with_context(spec.where, [&, &name = output, &numbers = signal] {
      with_context(name.empty() ? spec.name : spec.name + "." + name, [&] { sensors::check(numbers); });
    });
  }
}

/// The type that a table gives, if any.
std::optional<std::string> type_of(const SensorTable& table) {
  const auto type = text_of(table, "type");
  if (type) with_context(table.values.at("type").where, [&] { (void)sensor_types().find(*type); });
  return type;
}

/// The sensor before keys are applied: `old`, or a new one. `old` is null if there is none of that name.
SensorSpec begin(const SensorSpec* old, const SensorTable& table, const std::optional<SensorTable>& part) {
  auto type = type_of(table);
  SensorSpec spec;
  if (old && !type) spec = *old;
  // A part may give the type where the table does not.
  if (!old && !type && part) type = type_of(*part);
  if (type) spec.type = *type;
  if (spec.type.empty()) fail(table.where, fmt::format("sensor '{}' needs type = \"...\"", table.name));
  spec.name = table.name;
  spec.where = table.where;
  return spec;
}

/// The sensor that a table makes of `old`.
SensorSpec changed(const SensorSpec* old, const SensorTable& table, const std::filesystem::path& beside) {
  std::optional<SensorTable> part;
  if (const auto name = text_of(table, "part")) part = read_part(*name, table.values.at("part").where, beside);
  SensorSpec spec = begin(old, table, part);
  Changer changer(spec);
  if (part) {
    // A part replaces all earlier numbers: a mixture of two data sheets describes no sensor.
    spec.part = part->name;
    spec.signals.clear();
    spec.numbers.clear();
    spec.texts.clear();
    spec.part_outputs.clear();
    changer.take(*part, {"type", "rate", "delay"}, beside);
    changer.take_outputs(*part, true);
  }
  changer.take(table, option_names(sensor_keys().infos()), beside);
  changer.take_outputs(table, false);
  check_signals(spec);
  return spec;
}

[[noreturn]] void refuse_removal(const SensorTable& table, const std::vector<SensorSpec>& sensors) {
  Names names;
  for (const SensorSpec& spec : sensors) names.push_back(spec.name);
  if (names.empty()) fail(table.where, fmt::format("there is no sensor '{}' to remove", table.name));
  fail(table.where, unknown_name("sensor", table.name, names));
}

}  // namespace

bool is_sensor_name(std::string_view name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && std::ranges::all_of(name, fits);
}

void change_sensors(std::vector<SensorSpec>& sensors, const std::vector<SensorTable>& tables,
                    const std::filesystem::path& beside) {
  for (const SensorTable& table : tables) {
    // In the order of the tables: a later one may change or remove the result of an earlier one.
    const auto found = std::ranges::find(sensors, table.name, &SensorSpec::name);
    const bool known = found != sensors.end();
    if (table.removes) {
      if (!known) refuse_removal(table, sensors);
      sensors.erase(found);
      continue;
    }
    if (!is_sensor_name(table.name)) {
      fail(table.where, fmt::format("'{}' is no name of a sensor: letters, digits, _ and - only", table.name));
    }
    SensorSpec spec = changed(known ? &*found : nullptr, table, beside);
    if (known) {
      *found = std::move(spec);
    } else {
      sensors.push_back(std::move(spec));
    }
  }
}

std::vector<std::string> sensor_parts() { return files::data_file_names("parts", ".toml"); }

}  // namespace murosimf::component_files
