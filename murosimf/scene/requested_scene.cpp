#include "murosimf/scene/requested_scene.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/appearance/visual_meshes.h"
#include "murosimf/files/data_path.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/scene_file/remote_override.h"

namespace murosimf::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 1000;  // [byte]
constexpr std::string_view word_of_override = "--set '";

fs::path folder_of(const fs::path& file) {
  std::error_code error;
  return fs::absolute(file, error).parent_path();
}

void add_model(const std::string& model, const fs::path& beside, std::vector<fs::path>& folders) {
  if (model.empty()) return;
  if (const auto file = files::look_for_data_file(model, "models", ".xml", beside)) folders.push_back(folder_of(*file));
}

/// Messages about overrides quote names of the scene, which is harmless only if the file is a scene.
bool is_scene(const fs::path& file) {
  try {
    (void)scene_file::read_scene(file);
    return true;
  } catch (const SetupError&) {
    return false;
  }
}

/// Requests come over a network: errors must not tell the contents of files.
[[noreturn]] void refuse(const std::string& whole, bool quotes_override) {
  if (quotes_override) throw SetupError(files::one_line(whole));
  const std::string places = places_in(whole);
  throw RequestError(fmt::format("{}the scene cannot be built; the simulator's own messages say why",
                                 places.empty() ? "" : places + ": "),
                     files::one_line(whole));
}

std::size_t end_of_number(std::string_view text, std::size_t begin) {
  return std::min(text.find_first_not_of("0123456789", begin), text.size());
}

/// "FILE:LINE: " or "FILE:LINE:COLUMN: ".
struct Place {
  std::string_view file, line;
  std::size_t length = 0;  ///< 0: none
};

Place place_at_begin(std::string_view text) {
  // a place is only what has the full form: everything else could be a quotation from the file
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::size_t end = end_of_number(text, colon + 1);
  if (colon == 0 || end <= colon + 1) return {};
  const bool column = text.substr(end).starts_with(":") && end_of_number(text, end + 1) > end + 1;
  const std::size_t last = column ? end_of_number(text, end + 1) : end;
  if (!text.substr(last).starts_with(": ")) return {};
  return {text.substr(0, colon), text.substr(colon + 1, end - colon - 1), last + 2};
}

}  // namespace

std::string places_in(std::string_view message) {
  std::string places;
  for (Place place = place_at_begin(message); place.length > 0; place = place_at_begin(message)) {
    const std::string name = fs::path(place.file).filename().string();
    MUROSIMF_ASSERT(place.length <= message.size());
    places += fmt::format("{}{}:{}", places.empty() ? "" : ": ", name, place.line);
    message.remove_prefix(place.length);
  }
  return files::one_line(places);
}

std::shared_ptr<const files::AllowedFiles> files_of_run(const Scene& scene, std::vector<fs::path> folders,
                                                        std::vector<fs::path> files) {
  const scene_file::SceneSpec& spec = scene.spec();
  const fs::path beside = spec.file.parent_path();
  folders.push_back(folder_of(spec.file));
  for (const fs::path& folder : files::program_folders()) folders.push_back(folder);
  for (const scene_file::RobotSpec& robot : spec.robots) add_model(robot.model, beside, folders);
  for (const scene_file::BodySpec& body : spec.bodies) add_model(body.model, beside, folders);
  for (const auto& entity : scene.simulation().world().entities()) {
    for (const std::string& file : appearance::visual_files(entity->model())) files.emplace_back(file);
  }
  return std::make_shared<const files::AllowedFiles>(folders, files);
}

void for_outside(const std::string& name, const SceneOptions& options, const std::function<void()>& build) {
  // before the file system is touched: errors must not reveal which files exist
  if (name.size() > longest_name || files::one_line(name) != name) throw SetupError("this is no name of a scene");
  const files::FileScope scope(options.files);
  const fs::path file = files::find_data_file(name, "scenes", ".toml");
  for (const std::string& text : options.overrides) scene_file::check_remote_override(text, file.parent_path());
  const bool quotable = is_scene(file);
  try {
    build();
  } catch (const RequestError&) {
    throw;
  } catch (const SetupError& error) {
    refuse(error.what(), quotable && std::string_view(error.what()).starts_with(word_of_override));
  } catch (const fs::filesystem_error& error) {
    refuse(error.what(), false);
  }
}

}  // namespace murosimf::scene
