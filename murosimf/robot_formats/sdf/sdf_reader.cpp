#include "murosimf/robot_formats/sdf/sdf_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/robot_formats/sdf/sdf_assembly.h"
#include "murosimf/robot_formats/sdf/sdf_parts.h"
#include "murosimf/robot_formats/sdf/sdf_poses.h"
#include "murosimf/robot_formats/sdf/sdf_program.h"
#include "murosimf/robot_formats/sdf/sdf_schema.h"
#include "murosimf/robot_formats/sdf/sdf_value.h"

namespace murosimf::robot_formats::sdf {
namespace {

/// Checks the vocabulary of all files. Included files have the same words; other parts of a world are not examined.
void check_words(const SdfFile& file, robot_formats::RobotDescription& description, bool lenient) {
  files::XmlVocabulary words = sdf_schema();
  if (!file.name_in_world().empty()) {
    // In a world, other models and includes are neither used nor wrong.
    auto& [used, unused, unsupported, children, unused_children, unsupported_children, all] = words["world"];
    children = {};
    unused_children.insert(unused_children.end(), {"model", "include"});
  }
  constexpr auto named = files::UnknownWords::named;
  std::vector<files::XmlElement> roots = file.roots();
  if (!file.name_in_world().empty()) roots.push_back(file.robot().element);
  for (const files::XmlElement& root : roots) {
    for (auto& [word, line] : files::validate(root, words, lenient, description.warnings, named)) {
      const bool told = std::ranges::any_of(description.unused, [&](const auto& one) { return one.word == word; });
      // Files of one robot repeat words: each is listed once.
      if (!told && word != "model" && word != "include")
        description.unused.push_back({std::move(word), std::move(line)});
    }
  }
}

/// Reports errors of libsdformat. Inertias are repaired later (robot/repair_solids.h), and missing includes are reported already.
void report(const std::vector<SdfError>& errors, const SdfModel& model, urdf::UrdfLog& log) {
  for (const auto& [kind, where, message] : errors) {
    if (kind == "other") log.ReaderLog::refuse(where.empty() ? model.element.where() : where, message);
  }
}

}  // namespace

robot_formats::RobotDescription read_sdf(const std::filesystem::path& file,
                                         const robot_formats::ReaderOptions& options) {
  robot_formats::RobotDescription description;
  description.file = file;
  urdf::UrdfLog log(description, options.lenient);
  const SdfFile parts(file, options, log);
  if (!has_sdf_program()) (void)sdf_program(file);  // throws the error with advice
  description.name = parts.robot().name;
  check_words(parts, description, options.lenient);
  const SdfPoses poses = resolve_poses(file, parts.name_in_world(), parts.includes());
  report(poses.errors, parts.robot(), log);
  SdfAssembly(parts.robot(), poses, options, description, log).assemble();
  // Without self_collide parts of the robot touch the ground, of kind 1, and no other part, of kind 2.
  if (flag(parts.robot().element, "self_collide", false)) return description;
  for (robot_formats::BodyDescription& body : description.bodies) {
    for (robot_formats::ShapeDescription& shape : body.shapes) {
      if (shape.placed.collides) shape.placed.contact_type = 2;
    }
  }
  return description;
}

}  // namespace murosimf::robot_formats::sdf
