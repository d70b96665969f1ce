// [[algorithms]] of a scene file: classes in Python that are no controllers.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/robot_options.h"
#include "murosimf/scene_file/section_readers.h"
#include "murosimf/world/rate.h"

namespace murosimf::scene_file {
namespace {

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
