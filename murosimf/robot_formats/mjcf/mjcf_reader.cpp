#include "murosimf/robot_formats/mjcf/mjcf_reader.h"

#include <string_view>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/joint_inertia.h"
#include "murosimf/robot_formats/mjcf/mjcf_actuator.h"
#include "murosimf/robot_formats/mjcf/mjcf_attach.h"
#include "murosimf/robot_formats/mjcf/mjcf_body.h"
#include "murosimf/robot_formats/mjcf/mjcf_children.h"
#include "murosimf/robot_formats/mjcf/mjcf_idle.h"
#include "murosimf/robot_formats/mjcf/mjcf_joint.h"
#include "murosimf/robot_formats/mjcf/mjcf_joint_tendons.h"
#include "murosimf/robot_formats/mjcf/mjcf_keyframe.h"
#include "murosimf/robot_formats/mjcf/mjcf_loops.h"
#include "murosimf/robot_formats/mjcf/mjcf_material.h"
#include "murosimf/robot_formats/mjcf/mjcf_relations.h"
#include "murosimf/robot_formats/mjcf/mjcf_replicate.h"
#include "murosimf/robot_formats/mjcf/mjcf_schema.h"
#include "murosimf/robot_formats/mjcf/mjcf_tendon_ties.h"
#include "murosimf/robot_formats/mjcf/mjcf_tendons.h"
#include "murosimf/robot_formats/mjcf/mjcf_texture.h"
#include "murosimf/robot_formats/mjcf/mjcf_trees.h"

namespace murosimf::robot_formats::mjcf {
namespace {

/// Whether parts of this kind are reported one by one, with more than their kind, which is all that the schema has.
bool is_named_one_by_one(const std::string& word) { return word == "geom" || word == "site" || is_idle_actuator(word); }

void name_world(const files::XmlElement& world, bool bolted, std::vector<robot_formats::Unused>& unused) {
  for (const char* tag : {"geom", "site"}) {
    for (const files::XmlElement& element : elements_in(world, tag)) {
      if (bolted && tag == std::string_view("site") && element.attribute("name")) continue;
      const bool plane = element.attribute("type").value_or("") == "plane";
      const std::string what =
          files::one_line(fmt::format("world {} '{}'", tag, element.attribute("name").value_or("")));
      unused.push_back({what, fmt::format("{}: {} ignored: {}", element.where(), what,
                                          plane ? "the scene brings its own ground" : "it is no part of the robot")});
    }
  }
}

/// Applies settotalmass: scales masses and inertias in proportion.
void scale_masses(const MjcfCompiler& compiler, robot_formats::RobotDescription& description) {
  double total = 0;
  for (const robot_formats::BodyDescription& body : description.bodies) total += body.solid.mass;
  if (!(compiler.total_mass > 0) || !(total > 0)) return;
  const double factor = compiler.total_mass / total;
  MUROSIMF_ASSERT(factor > 0);
  for (robot_formats::BodyDescription& body : description.bodies) {
    body.solid.mass *= factor;
    body.solid.inertia = factor * body.solid.inertia;
  }
}

}  // namespace

robot_formats::RobotDescription read_mjcf(const std::filesystem::path& file,
                                          const robot_formats::ReaderOptions& options) {
  files::XmlFile xml(file);
  const files::XmlElement root = xml.root();
  if (root.tag() != "mujoco") {
    root.fail(fmt::format("the root is <{}>, not <mujoco>; this is no MJCF file", root.tag()));
  }
  xml.follow_includes();
  robot_formats::RobotDescription description;
  description.file = file;
  description.name = root.attribute("model").value_or(file.stem().string());
  for (auto& [word, line] : files::validate(root, mjcf_schema(), options.lenient, description.warnings)) {
    if (!is_named_one_by_one(word)) description.unused.push_back({std::move(word), std::move(line)});
  }
  // Attached models first, then replicates: copies may contain both, and the settings below need all elements.
  MjcfCompiler compiler = read_compiler(root);
  attach_models(xml, root, compiler, options.lenient, description);
  expand_replicates(xml, root, compiler);

  const MjcfDefaults defaults(root);
  const MjcfTrees trees = find_trees(root, defaults, compiler, options.body, description);
  for (const files::XmlElement& world : root.children("worldbody")) {
    name_world(world, trees.bolted, description.unused);
  }
  const MjcfNames names(root, trees);
  MjcfMeshes meshes(file, root, defaults, compiler, options.part_per_group, description.warnings);
  const MjcfMaterials materials(file, root, defaults, compiler);
  name_undrawn_textures(root, description.unused);
  description.meshes = meshes.descriptions();
  auto tendons = find_tendons(root, defaults, compiler, names);
  MjcfActuators actuators = read_actuators(root, defaults, compiler, names, tendons, description);
  std::vector<MjcfSpringDamper> springs;
  const MjcfContext context{.defaults = defaults,
                            .compiler = compiler,
                            .names = names,
                            .actuators = actuators.by_joint,
                            .materials = materials,
                            .lenient = options.lenient,
                            .meshes = meshes,
                            .warnings = description.warnings,
                            .notes = description.notes,
                            .springs = springs};
  read_bodies(root, trees, context, description);
  // The order matters: stiffness and damping follow from the scaled masses, and tendons add to both.
  scale_masses(compiler, description);
  resolve_spring_dampers(springs, description);
  add_joint_tendons(tendons, defaults, compiler, actuators, description);
  apply_tendons(tendons, defaults, compiler, description);
  read_ties(root, tendons, description);
  robot_formats::resolve_damping_ratios(description);
  drop_idle_controls(actuators, description);
  name_idle_relations(root, context, tendons, description);
  read_relations(root, names, defaults, description);
  read_loops(root, names, description);
  read_keyframes(root, trees, context, actuators, description);
  return description;
}

}  // namespace murosimf::robot_formats::mjcf
