#include "murosimf/dataset/manifest.h"

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/dataset/annotate.h"
#include "murosimf/files/input_file.h"
#include "murosimf/files/json_document.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::dataset {
namespace {

using nlohmann::json;

constexpr std::uintmax_t most_manifest_bytes = 64'000'000;

json classes_of(const Stage& stage) {
  json classes = json::array();
  for (const Category& category : stage.categories()) {
    classes.push_back({{"number", category.number}, {"name", category.name}});
  }
  classes.push_back({{"number", +class_line}, {"name", "line"}});
  return classes;
}

json instances_of(const Stage& stage) {
  json instances = json::array();
  if (!stage.goals().empty()) {
    instances.push_back({{"number", instance_left_goal}, {"name", "goal_left"}, {"class", +class_goal}});
    instances.push_back({{"number", instance_right_goal}, {"name", "goal_right"}, {"class", +class_goal}});
  }
  for (std::size_t i = 0; i < stage.actors().size(); ++i) {
    const Actor& actor = stage.actors()[i];
    instances.push_back(
        {{"number", instance_first_actor + i}, {"name", actor.entity->name()}, {"class", actor.category}});
  }
  return instances;
}

/// They follow from the others: an error names them only if all others agree.
constexpr std::array derived{"classes", "instances", "postures", "start"};

bool is_derived(const std::string& key) { return std::ranges::find(derived, key) != derived.end(); }

std::string hexadecimal(std::uint64_t number) { return fmt::format("{:016x}", number); }

/// What makes the robots of the scene move otherwise.
json changes_of(const Request& request, const Stage& stage) {
  const scene::SceneOptions& options = request.options;
  return {{"scene_text", files::read_input_file(stage.scene().spec().file, files::most_toml_bytes)},
          {"set", options.overrides},
          {"at", options.events},
          {"push", options.pushes},
          {"plugins", request.plugins},
          {"libraries", options.libraries},
          {"lenient", options.lenient},
          {"start", hexadecimal(stage.scene().simulation().state_hash())},
          {"postures", hexadecimal(stage.postures().hash())}};
}

/// "was 1, not 7", for values that fit into a line.
std::string difference(const json& known, const json& value) {
  constexpr std::size_t most = 60;
  const std::string was = known.dump(), is = value.dump();
  return was.size() > most || is.size() > most ? "was another one" : fmt::format("was {}, not {}", was, is);
}

/// The first key of that kind that differs; `pictures` may.
[[nodiscard]] std::optional<std::string> differing(const json& known, const json& manifest, bool of_derived) {
  for (const auto& [key, value] : manifest.items()) {
    if (key == "pictures" || is_derived(key) != of_derived) continue;
    if (!known.contains(key)) return fmt::format("'{}' is not in its {}", key, manifest_name);
    if (known[key] != value) return fmt::format("'{}' {}", key, difference(known[key], value));
  }
  return std::nullopt;
}

/// manifest.json.PID.part (files/output_file.h)
bool is_half_manifest(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with(std::string(manifest_name) + ".") && name.ends_with(".part");
}

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& why) {
  throw SetupError(files::one_line(fmt::format("--dataset '{}': {}", folder.string(), why)));
}

}  // namespace

nlohmann::json manifest_of(const Request& request, const Randomisation& randomisation, const Stage& stage) {
  json manifest{{"schema", files::json_schema("dataset")},
                {"version", request.version},
                {"scene", request.scene.string()},
                {"seed", stage.scene().spec().seed},
                {"pictures", request.pictures},
                {"width", request.width},
                {"height", request.height},
                {"normals", request.normals},
                {"randomise", request.randomisation.string()},
                {"ranges", randomisation.text},
                {"classes", classes_of(stage)},
                {"instances", instances_of(stage)}};
  manifest.update(changes_of(request, stage));
  return json::parse(
      files::json_text(std::move(manifest)));  // as it is read again: bytes that are no UTF-8 are replaced
}

void check_folder(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::exists(folder, error)) return;
  if (!std::filesystem::is_directory(folder, error)) refuse(folder, "there is a file of this name");
  if (std::filesystem::exists(folder / manifest_name, error)) return;
  auto inside = std::filesystem::directory_iterator(folder, error);
  for (; !error && inside != std::filesystem::directory_iterator(); inside.increment(error)) {
    if (!is_half_manifest(inside->path()))
      refuse(folder, "this folder is not empty, and no data set that could be continued");
  }
  if (error) refuse(folder, error.message());
}

void check_continued(const std::filesystem::path& folder, const nlohmann::json& manifest) {
  std::error_code error;
  if (!std::filesystem::exists(folder / manifest_name, error)) return;
  const json known = json::parse(files::read_input_file(folder / manifest_name, most_manifest_bytes), nullptr, false);
  if (!known.is_object()) refuse(folder, fmt::format("its {} is no JSON", manifest_name));
  for (const bool of_derived : {false, true}) {
    const auto what = differing(known, manifest, of_derived);
    if (what) refuse(folder, "is continued only with what it was begun with; " + *what);
  }
  const json& pictures = known.contains("pictures") ? known["pictures"] : json(0);
  if (!pictures.is_number_unsigned() || pictures > manifest["pictures"]) {
    refuse(folder, fmt::format("has {} pictures: --frames must be at least that", pictures.dump()));
  }
}

}  // namespace murosimf::dataset
