// [[algorithms]] of a scene file: classes in Python that are no controllers.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/robot_options.h"
#include "murosimf/scene_file/section_readers.h"
#include "murosimf/world/rate.h"

namespace murosimf::scene_file {
namespace {

constexpr double longest_sensor_delay = 10;  // [s]

double deviation_of(const toml::node& node, std::string_view output) {
  const auto numbers = node.is_number() ? files::numbers_of(node) : std::nullopt;
  if (!numbers || !(numbers->front() >= 0) || !std::isfinite(numbers->front()))
    files::fail_at(node.source(), fmt::format("'{}' must be a deviation: a number of at least 0", output));
  return numbers->front();
}

/// A number for all outputs, or a table with one for each that has any.
void read_noise(const files::TomlTable& table, std::string_view key, AlgorithmSpec& algorithm) {
  const toml::node* const node = table.find(key);
  if (!node) return;
  const toml::table* const outputs = node->as_table();
  if (!outputs) {
    algorithm.noise[""] = deviation_of(*node, key);
    return;
  }
  for (const auto& [output, deviation] : *outputs)
    algorithm.noise[std::string(output.str())] = deviation_of(deviation, output.str());
}

AlgorithmSpec read_algorithm(const toml::table& node) {
  const files::TomlTable table(node, algorithm_section().names());
  AlgorithmSpec algorithm;
  algorithm_section().read(table, algorithm);
  const std::size_t colon = algorithm.target.rfind(':');
  const bool named = colon != std::string::npos && colon > 0 && colon + 1 < algorithm.target.size();
  require(named, table, "class", "is needed: \"module:Class\"");
  algorithm.where = table.where("class");
  if (algorithm.name.empty()) algorithm.name = algorithm.target.substr(colon + 1);
  require(algorithm.name.find('.') == std::string::npos, table, "name", "must have no dot");
  if (const toml::table* options = table.table("options")) algorithm.options = read_any_options(*options);
  return algorithm;
}

}  // namespace

const Section<AlgorithmSpec>& algorithm_section() {
  static const Section<AlgorithmSpec> section(
      "[[algorithms]]",
      {{"name", &AlgorithmSpec::name, "", "of it in reports, and of the sensor that it is", {}, "that of the class"},
       {"class", &AlgorithmSpec::target, "", "in Python: module:Class; needs --libraries", {}, "(needed)"},
       {"on", &AlgorithmSpec::on, "", "the entity that it belongs to", {}, "the whole scene"},
       {"rate", &AlgorithmSpec::rate, "Hz", "of its calls; 0: that of the class", between(0, fastest_rate)},
       {"delay", &AlgorithmSpec::delay, "s", "of a sensor: until its samples can be read",
        between(0, longest_sensor_delay)},
       {"noise", &read_noise, "", "of a sensor: deviation of all numbers, or {output = deviation}", {}, "0"},
       {"call_budget", &AlgorithmSpec::call_budget, "s", "of wall time for each of its calls; 0: any", not_negative},
       {"options", {}, "", "arguments of the class", {}, "the class's"}});
  return section;
}

void read_algorithms(const files::TomlTable& scene, SceneSpec& spec) {
  for (const toml::table* node : scene.tables("algorithms")) {
    AlgorithmSpec algorithm = read_algorithm(*node);
    if (std::ranges::find(spec.algorithms, algorithm.name, &AlgorithmSpec::name) != spec.algorithms.end()) {
      files::fail_at(node->source(), fmt::format("two algorithms are called '{}'", algorithm.name));
    }
    spec.algorithms.push_back(std::move(algorithm));
  }
}

}  // namespace murosimf::scene_file
