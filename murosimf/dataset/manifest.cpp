#include "murosimf/dataset/manifest.h"

#include <system_error>

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

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& why) {
  throw SetupError(files::one_line(fmt::format("--dataset '{}': {}", folder.string(), why)));
}

}  // namespace

nlohmann::json manifest_of(const Request& request, const Randomisation& randomisation, const Stage& stage,
                           const std::string& drawn_by) {
  const scene::SceneOptions& options = request.options;
  return {{"schema", files::json_schema("dataset")},
          {"version", request.version},
          {"scene", request.scene.string()},
          {"set", options.overrides},
          {"start", fmt::format("{:016x}", stage.scene().simulation().state_hash())},
          {"seed", stage.scene().spec().seed},
          {"pictures", request.pictures},
          {"width", request.width},
          {"height", request.height},
          {"normals", request.normals},
          {"drawn_by", drawn_by},
          {"randomise", request.randomisation.string()},
          {"ranges", randomisation.text},
          {"classes", classes_of(stage)},
          {"instances", instances_of(stage)}};
}

void check_folder(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::exists(folder, error)) return;
  if (!std::filesystem::is_directory(folder, error)) refuse(folder, "there is a file of this name");
  const auto inside = std::filesystem::directory_iterator(folder, error);
  if (error) refuse(folder, error.message());
  if (inside == std::filesystem::directory_iterator() || std::filesystem::exists(folder / manifest_name, error)) return;
  refuse(folder, "this folder is not empty, and no data set that could be continued");
}

void check_continued(const std::filesystem::path& folder, const nlohmann::json& manifest) {
  std::error_code error;
  if (!std::filesystem::exists(folder / manifest_name, error)) return;
  const json known = json::parse(files::read_input_file(folder / manifest_name, most_manifest_bytes), nullptr, false);
  if (!known.is_object()) refuse(folder, fmt::format("its {} is no JSON", manifest_name));
  for (const auto& [key, value] : manifest.items()) {
    if (key == "pictures" || (known.contains(key) && known[key] == value)) continue;
    const auto text = [](const json& one) {
      const std::string whole = one.dump();
      return whole.size() > 60 ? std::string("other text") : whole;
    };
    const std::string was = known.contains(key) ? text(known[key]) : "nothing";
    refuse(folder,
           fmt::format("is continued only with what it was begun with; '{}' was {}, not {}", key, was, text(value)));
  }
  const json& pictures = known.contains("pictures") ? known["pictures"] : json(0);
  if (!pictures.is_number_unsigned() || pictures > manifest["pictures"]) {
    refuse(folder, fmt::format("has {} pictures: --frames must be at least that", pictures.dump()));
  }
}

}  // namespace murosimf::dataset
