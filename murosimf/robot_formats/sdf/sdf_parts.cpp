#include "murosimf/robot_formats/sdf/sdf_parts.h"

#include <utility>

#include <fmt/format.h>

#include "murosimf/files/file_spelling.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/sdf/sdf_include.h"
#include "murosimf/robot_formats/sdf/sdf_value.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::sdf {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 30;                // models in models
constexpr std::size_t most_parts = 20000;  // links and joints, with all that is included

/// The only model in an included file, or in the file itself.
files::XmlElement model_of(const files::XmlElement& root, urdf::UrdfLog& log) {
  const auto models = root.children("model");
  if (models.empty()) root.fail("there is no model in this file");
  if (models.size() > 1) {
    log.unused(models[1], "more models", "models after the first at the top of a file are not read");
  }
  return models[0];
}

std::string name_of(const files::XmlElement& element) { return urdf::needed_text(element, "name"); }

}  // namespace

SdfFile::SdfFile(fs::path file, const robot_formats::ReaderOptions& options, urdf::UrdfLog& log)
    : file_(std::move(file)), options_(options), log_(log) {
  const files::XmlElement root = files_.emplace(file_, std::make_unique<files::XmlFile>(file_)).first->second->root();
  if (root.tag() != "sdf") root.fail(fmt::format("the root is <{}>, not <sdf>; this is no SDF file", root.tag()));
  const auto worlds = root.children("world");
  if (worlds.empty()) {
    const files::XmlElement model = model_of(root, log_);
    add_model(model, file_, name_of(model));
    return;
  }
  in_world_ = true;
  if (worlds.size() > 1) log_.unused(worlds[1], "more worlds", "worlds after the first are not read");
  read_world(worlds[0]);
  MUROSIMF_ASSERT(!models_.empty());
  choose();
}

std::vector<files::XmlElement> SdfFile::roots() const {
  std::vector<files::XmlElement> roots{files_.at(file_)->root()};
  for (const auto& [file, xml] : files_) {
    if (file != file_) roots.push_back(xml->root());
  }
  return roots;
}

void SdfFile::read_world(const files::XmlElement& world) {
  for (const files::XmlElement& model : world.children("model")) add_model(model, file_, name_of(model));
  for (const files::XmlElement& include : world.children("include")) {
    try {
      const Source source = open(include, file_);
      const files::XmlElement model = model_of(source.root, log_);
      const std::size_t before = models_.size();
      add_model(model, source.file, child_text(include, "name", name_of(model)));
      if (flag(include, "static", false)) models_[before].is_static = true;
    } catch (const SetupError& error) {
      // Grounds and houses are often missing, and are not part of the robot.
      log_.unused(include, "include", fmt::format("an include of the world is not read: {}", error.what()));
    }
  }
  if (models_.empty()) world.fail("there is no model in this world that can be read");
}

void SdfFile::add_model(const files::XmlElement& element, const fs::path& file, const std::string& name) {
  SdfModel model{name, element, flag(element, "static", false), {}, {}};
  walk(element, file, "", model, 0);
  models_.push_back(std::move(model));
}

void SdfFile::choose() {
  // The model with the most joints is the robot; of equal ones a movable one, then the first.
  for (std::size_t i = 1; i < models_.size(); ++i) {
    const SdfModel &one = models_[i], &best = models_[robot_];
    const bool more = one.joints.size() > best.joints.size();
    if (more || (one.joints.size() == best.joints.size() && best.is_static && !one.is_static)) robot_ = i;
  }
  for (std::size_t i = 0; i < models_.size(); ++i) {
    if (i == robot_) continue;
    const std::string& name = models_[i].name;
    log_.unused(models_[i].element, fmt::format("model '{}'", name),
                fmt::format("model '{}' of the world is not read", name));
  }
  MUROSIMF_ASSERT(robot_ < models_.size());
}

void SdfFile::walk(const files::XmlElement& element, const fs::path& file, const std::string& scope, SdfModel& model,
                   int depth) {
  MUROSIMF_ASSERT(depth >= 0);
  if (depth > deepest) element.fail("models stand in models more than 30 deep; does one include itself?");
  for (const files::XmlElement& child : element.children()) {
    const std::string tag = child.tag();
    if (tag == "link" || tag == "joint") {
      (tag == "link" ? model.links : model.joints).push_back({scope + name_of(child), child, file});
      if (++parts_ > most_parts) child.fail(fmt::format("the model has more than {} links and joints", most_parts));
      // Counted over all models: a few includes of each other can have billions of parts.
    } else if (tag == "model") {
      walk(child, file, scope + name_of(child) + "::", model, depth + 1);
    } else if (tag == "include") {
      walk_include(child, file, scope, model, depth);
    }
  }
}

void SdfFile::walk_include(const files::XmlElement& include, const fs::path& file, const std::string& scope,
                           SdfModel& model, int depth) {
  const Source source = open(include, file);
  const files::XmlElement inner = model_of(source.root, log_);
  const bool merged = include.attribute("merge").value_or("false") == "true" || include.attribute("merge") == "1";
  const std::string name = child_text(include, "name", name_of(inner));
  walk(inner, source.file, merged ? scope : scope + name + "::", model, depth + 1);
}

SdfFile::Source SdfFile::open(const files::XmlElement& include, const fs::path& from) {
  const std::string uri = child_text(include, "uri", "");
  if (uri.empty()) include.fail("include without uri; add it");
  const fs::path file = find(include, uri, from);
  const auto [known, is_new] = includes_.emplace(uri, fs::absolute(file).lexically_normal());
  // libsdformat gets one file for each URI, whatever file includes it.
  if (!is_new && known->second != fs::absolute(file).lexically_normal()) {
    include.fail(fmt::format("'{}' means two files, {} and {}; call one of them otherwise", uri, known->second.string(),
                             file.string()));
  }
  auto& xml = files_[file];
  if (!xml) xml = std::make_unique<files::XmlFile>(file);
  return {file, xml->root()};
}

fs::path SdfFile::find(const files::XmlElement& include, const std::string& uri, const fs::path& from) const {
  const auto places = include_places(uri, from, options_);
  for (const fs::path& place : places) {
    if (auto file = model_file(place)) return *std::move(file);
  }
  const std::string looked = places.empty() ? "" : fmt::format(" (not there: {})", places.front().string());
  include.fail(
      fmt::format("there is no model '{}'; put its folder beside the file, or the folder that it is in into "
                  "MUROSIMF_PACKAGE_PATH{}",
                  uri, looked));
}

}  // namespace murosimf::robot_formats::sdf
