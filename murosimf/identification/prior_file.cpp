#include "murosimf/identification/prior_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/files/data_path.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/model/error.h"

namespace murosimf::identification {
namespace {

using identification::Expectation;
using identification::Parameter;

constexpr std::string_view folder = "servos/priors", extension = ".toml";

const Parameter& parameter_of(const toml::key& key) {
  std::vector<std::string_view> known;
  for (const Parameter& parameter : identification::parameters()) {
    if (parameter.name == key.str()) return parameter;
    known.push_back(parameter.name);
  }
  files::fail_at(key.source(), unknown_name("parameter", key.str(), known));
}

Expectation expectation_of(const Parameter& parameter, const toml::node& node) {
  const toml::table* table = node.as_table();
  if (!table) files::fail_at(node.source(), fmt::format("[{}] must be a table with value and width", parameter.name));
  const files::TomlTable reader(*table, {"value", "width", "relative_width"});
  Expectation expectation{.parameter = std::string(parameter.name)};
  expectation.relative = reader.find("relative_width") != nullptr;
  if (!reader.find("value") || expectation.relative == (reader.find("width") != nullptr)) {
    files::fail_at(table->source(),
                   fmt::format("[{}] needs value, and either width or relative_width", parameter.name));
  }
  reader.read("value", expectation.value);
  reader.read(expectation.relative ? "relative_width" : "width", expectation.width);
  if (!(expectation.width > 0)) files::fail_at(table->source(), "a width must be above 0");
  if (!(expectation.value >= parameter.low && expectation.value <= parameter.high)) {
    files::fail_at(table->source(), fmt::format("{} must be from {} to {} {}", parameter.name, parameter.low,
                                                parameter.high, parameter.unit));
  }
  if (expectation.relative && !(expectation.value > 0))
    files::fail_at(table->source(), "relative_width needs a value above 0");
  return expectation;
}

}  // namespace

identification::Prior read_prior(std::string_view name) {
  if (name == "none") return {};
  const auto file = files::look_for_data_file(name, folder, extension);
  if (!file) {
    auto names = files::data_file_names(folder, extension);
    names.emplace_back("none");
    throw SetupError(unknown_name("prior", name, {names.begin(), names.end()}));
  }
  identification::Prior prior;
  const toml::table content = files::parse_toml_file(*file);
  for (const auto& [key, node] : content) prior.push_back(expectation_of(parameter_of(key), node));
  return prior;
}

std::string prior_of_type(std::string_view type) {
  const auto names = files::data_file_names(folder, extension);
  return std::ranges::find(names, type) == names.end() ? "none" : std::string(type);
}

}  // namespace murosimf::identification
