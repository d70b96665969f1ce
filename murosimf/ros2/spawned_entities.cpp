#include "murosimf/ros2/spawned_entities.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "murosimf/dds/ros2/ros_names.h"
#include "murosimf/files/data_path.h"
#include "murosimf/files/file_access.h"
#include "murosimf/files/output_file.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/requested_scene.h"

namespace murosimf::ros2 {
namespace {

constexpr std::size_t most_entities = 100;                            // they stay in the scene
constexpr std::size_t longest_uri = 1000, longest_entity_name = 100;  // [byte]

std::string source_of(const SpawnRequest& wanted) {
  return wanted.uri.empty() ? "text: " + wanted.text : "uri: " + wanted.uri;
}

/// Without slashes around it.
std::string bare(std::string name) {
  while (name.starts_with('/')) name.erase(0, 1);
  while (name.ends_with('/')) name.pop_back();
  return name;
}

/// Also of topics, and of frames.
bool is_taken(const scene::Scene& scene, const std::string& name) {
  const auto& all = scene.simulation().world().entities();
  return name == "world" || std::ranges::any_of(all, [&](const auto& entity) {
           return dds::ros2::ros_name(entity->name()) == dds::ros2::ros_name(name);
         });
}

bool is_good(const std::string& name) {
  return !name.empty() && name.size() <= longest_entity_name &&
         std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
}

/// "kid21" of "models/kid21.xml", "my_robot" of "my robot".
std::string name_by(const SpawnRequest& wanted, const Model& model) {
  std::string name = wanted.uri.empty() ? model.name() : std::filesystem::path(wanted.uri).stem().string();
  name.resize(std::min(name.size(), longest_entity_name / 2));
  for (char& c : name) {
    if (!is_good({c})) c = '_';
  }
  return name.empty() ? "entity" : name;
}

std::string unique(const scene::Scene& scene, const std::string& name) {
  std::string found = name;
  for (int i = 2; is_taken(scene, found); ++i) found = fmt::format("{}_{}", name, i);
  return found;
}

/// Throws RefusedSpawn.
std::string name_for(const scene::Scene& scene, const SpawnRequest& wanted, const Model& model) {
  const std::string space = bare(wanted.entity_namespace);
  const std::string name = wanted.name.empty() ? space : wanted.name;
  if (name.empty()) return unique(scene, name_by(wanted, model));
  if (!is_good(name))
    throw RefusedSpawn(ResultCode::name_invalid,
                       fmt::format("a name has letters, digits, '_' and '-', at most {}", longest_entity_name));
  if (!space.empty() && space != name)
    throw RefusedSpawn(ResultCode::namespace_invalid,
                       "topics of an entity stand below its name: leave the namespace empty, or give that name");
  if (!is_taken(scene, name)) return name;
  if (!wanted.may_rename || !space.empty())
    throw RefusedSpawn(ResultCode::name_not_unique, fmt::format("the name '{}' is taken", name));
  return unique(scene, name);
}

scene_file::BodySpec body_of(const std::string& name, const std::filesystem::path& file, const EntityState& pose) {
  scene_file::BodySpec body;
  body.name = name;
  body.where = "SpawnEntity";
  body.model = file.string();
  body.position = pose.position;
  body.present = false;
  return body;
}

scene_file::RobotSpec robot_of(const std::string& name, const std::filesystem::path& file, const EntityState& pose) {
  scene_file::RobotSpec robot;
  robot.name = name;
  robot.where = "SpawnEntity";
  robot.model = file.string();
  robot.level = "articulated_dynamics";
  robot.controller = "ros2";
  robot.position = pose.position;
  robot.present = false;
  return robot;
}

/// A robot whose motion engine can walk obeys cmd_vel, too.
void add_robot(scene::Scene& scene, scene_file::RobotSpec robot) {
  try {
    scene.add(robot);
  } catch (const SetupError&) {
    robot.options["walk"] = false;
    scene.add(std::move(robot));
  }
}

/// What is wrong with a model whose reading has ended so: readers of all formats name a mesh that is not there, or that they cannot read.
ResultCode code_of(const std::string& error) {
  const auto says = [&](std::string_view words) { return error.find(words) != std::string::npos; };
  if (says("unknown kind of mesh file")) return ResultCode::unsupported_assets;
  const bool is_missing = says(": there is no such file") || says("in none of the folders that may be read here");
  if (says("there is no mesh file '") || (says(": mesh '") && is_missing)) return ResultCode::missing_assets;
  return ResultCode::resource_parse_error;
}

std::string without(std::string message, const std::string& part) {
  for (std::size_t at = message.find(part); at != std::string::npos; at = message.find(part))
    message.erase(at, part.size());
  return message;
}

}  // namespace

SpawnedEntities::SpawnedEntities(std::shared_ptr<const files::AllowedFiles> models_from,
                                 std::function<void(const std::string&)> say)
    : models_from_(std::move(models_from)), say_(std::move(say)) {
  if (!models_from_) models_from_ = std::make_shared<const files::AllowedFiles>(files::program_folders());
}

std::string SpawnedEntities::waiting_for(const scene::Scene& scene, const SpawnRequest& wanted) const {
  const std::string name = wanted.name.empty() ? bare(wanted.entity_namespace) : wanted.name;
  const auto known = all_.find(name);
  if (known == all_.end() || known->second != source_of(wanted)) return {};
  return scene.simulation().world().entity(name).present() ? "" : name;
}

/// What its name says is looked for in the allowed folders alone.
std::filesystem::path SpawnedEntities::file_of(const scene::Scene& scene, const SpawnRequest& wanted) {
  if (wanted.uri.empty()) return written(wanted.text);
  const files::FileScope scope({.only_from = models_from_});
  if (wanted.uri.size() <= longest_uri && files::one_line(wanted.uri) == wanted.uri) {
    if (const auto file = files::look_for_data_file(wanted.uri, "models", ".xml", scene.spec().file.parent_path()))
      return *file;
  }
  throw RefusedSpawn(ResultCode::not_found, "there is no such model, nor an absent entity: see GetSpawnables");
}

/// Readers of robots read files; the name of this one does not matter.
std::filesystem::path SpawnedEntities::written(const std::string& text) {
  if (!texts_) {
    texts_ = std::make_unique<recording::ScratchFolder>();
    std::vector<std::filesystem::path> folders = files::program_folders();
    folders.push_back(texts_->path());
    with_text_ = std::make_shared<const files::AllowedFiles>(folders);
  }
  const std::filesystem::path file = texts_->path() / fmt::format("text{}.xml", ++count_);
  files::write_file(file, text);
  return file;
}

/// Files are not quoted over a network (SECURITY.md); a text is known to the client that sent it, and reads nothing else.
void SpawnedEntities::refuse(const SpawnRequest& wanted, const std::string& whole) const {
  if (wanted.uri.empty()) {
    throw RefusedSpawn(code_of(whole), files::one_line(without(whole, texts_ ? texts_->path().string() + "/" : "/")));
  }
  if (say_) say_(fmt::format("a spawned entity was refused: {}", files::one_line(whole)));
  const std::string places = scene::places_in(whole);
  throw RefusedSpawn(code_of(whole), fmt::format("{}{}the entity cannot be built; the simulator's own messages say why",
                                                 places, places.empty() ? "" : ": "));
}

std::string SpawnedEntities::add(scene::Scene& scene, const SpawnRequest& wanted) {
  if (all_.size() >= most_entities)
    throw RefusedSpawn(ResultCode::operation_failed,
                       fmt::format("at most {} entities are added to a run", most_entities));
  const std::filesystem::path file = file_of(scene, wanted);
  // the model is read here first: a recording needs its files
  const files::FileScope scope(
      {.only_from = wanted.uri.empty() ? with_text_ : models_from_, .noted = scene.parts().files_of_additions});
  try {
    const auto kind = scene.parts().assets->robot(file, {.lenient = scene.parts().lenient});
    const std::string name = name_for(scene, wanted, *kind->model);
    if (kind->model->joints().empty()) {
      scene.add(body_of(name, file, wanted.pose));
    } else {
      add_robot(scene, robot_of(name, file, wanted.pose));
    }
    all_[name] = source_of(wanted);
    return name;
  } catch (const RefusedSpawn&) {
    throw;
  } catch (const SetupError& error) {
    refuse(wanted, error.what());
  }
}

}  // namespace murosimf::ros2
