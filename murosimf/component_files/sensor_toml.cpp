#include "murosimf/component_files/sensor_toml.h"

#include <fmt/format.h>

namespace murosimf::component_files {
namespace {

SensorValue list_of(const std::string& key, const toml::array& array) {
  const std::string place = files::where(array.source());
  // An empty list has no type of elements; it is read as one of names.
  if (!array.empty() && array.front().is_number()) {
    if (auto numbers = files::numbers_of(array)) return {*std::move(numbers), place};
  }
  std::vector<std::string> texts;
  for (const toml::node& element : array) {
    if (!element.is_string()) {
      files::fail_at(element.source(), fmt::format("'{}' must be a list of numbers, or of names in quotes", key));
    }
    texts.push_back(**element.as_string());
  }
  return {std::move(texts), place};
}

SensorValue value_of(const std::string& key, const toml::node& node) {
  const std::string place = files::where(node.source());
  if (const auto* list = node.as_array()) return list_of(key, *list);
  if (const auto* text = node.as_string()) return {text->get(), place};
  if (const auto* truth = node.as_boolean()) return {truth->get(), place};
  if (node.is_number()) return {files::numbers_of(node)->front(), place};
  files::fail_at(node.source(), fmt::format("'{}' is a date or time; no key of a sensor is", key));
}

/// Sets the place of a table. Tables made by --set have none: they get the place of their first value.
void take_place(SensorTable& table, const toml::source_region& source) {
  if (source.begin.line > 0) {
    table.where = files::where(source);
  } else if (!table.values.empty()) {
    table.where = table.values.begin()->second.where;
  } else if (!table.outputs.empty() && !table.outputs.begin()->second.empty()) {
    table.where = table.outputs.begin()->second.begin()->second.where;
  }
}

SensorTable table_of(std::string name, const toml::table& node) {
  SensorTable table{std::move(name), {}};
  for (const auto& [key, value] : node) {
    const std::string word(key.str());
    if (const toml::table* output = value.as_table()) {
      if (output->empty()) files::fail_at(value.source(), fmt::format("'{}' is an empty table: it says nothing", word));
      SensorValues& values = table.outputs[word];
      for (const auto& [inner, number] : *output) {
        if (number.is_table()) files::fail_at(inner.source(), fmt::format("'{}' must not be a table", inner.str()));
        values.emplace(inner.str(), value_of(std::string(inner.str()), number));
      }
    } else {
      table.values.emplace(word, value_of(word, value));
    }
  }
  return table;
}

SensorTable read_one(const toml::key& key, const toml::node& node) {
  const std::string name(key.str());
  if (const toml::table* inside = node.as_table()) {
    SensorTable table = table_of(name, *inside);
    take_place(table, key.source());
    return table;
  }
  if (node.is_boolean() && !**node.as_boolean()) {
    return {.name = name, .where = files::where(node.source()), .removes = true, .values = {}, .outputs = {}};
  }
  files::fail_at(node.source(),
                 fmt::format("sensor '{}' must be a table, like [sensors.{}], or false: it is removed", name, name));
}

}  // namespace

std::vector<SensorTable> read_sensor_tables(const toml::table& sensors) {
  std::vector<SensorTable> tables;
  for (const auto& [key, node] : sensors) tables.push_back(read_one(key, node));
  return tables;
}

SensorTable read_part_file(const std::filesystem::path& file) {
  const toml::table root = files::parse_toml_file(file);
  SensorTable part = table_of(file.stem().string(), root);
  part.where = file.string();
  return part;
}

void read_sensor_changes(const toml::node* node, SensorChanges& changes) {
  if (!node) return;
  if (const auto* all = node->as_boolean()) {
    // true and false replace the changes of [defaults]; tables add to them.
    changes = {!all->get(), {}};
    return;
  }
  const toml::table* tables = node->as_table();
  if (!tables) {
    files::fail_at(node->source(),
                   "'sensors' must be false (none), true (those of the robot's files), or tables, like "
                   "[robots.sensors.imu]");
  }
  for (SensorTable& table : read_sensor_tables(*tables)) changes.tables.push_back(std::move(table));
}

}  // namespace murosimf::component_files
