#include "murosimf/formats/mjcf/mjcf_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/description/joint_inertia.h"
#include "murosimf/formats/mjcf/mjcf_actuator.h"
#include "murosimf/formats/mjcf/mjcf_attach.h"
#include "murosimf/formats/mjcf/mjcf_body.h"
#include "murosimf/formats/mjcf/mjcf_children.h"
#include "murosimf/formats/mjcf/mjcf_keyframe.h"
#include "murosimf/formats/mjcf/mjcf_loops.h"
#include "murosimf/formats/mjcf/mjcf_material.h"
#include "murosimf/formats/mjcf/mjcf_relations.h"
#include "murosimf/formats/mjcf/mjcf_replicate.h"
#include "murosimf/formats/mjcf/mjcf_schema.h"
#include "murosimf/model/error.h"

namespace murosimf::formats::mjcf {
namespace {

/// The robot's first body and the class that holds around it.
struct Base {
  files::XmlElement body;
  std::string child_class;
};

/// One by one: the schema names kinds only.
void name_world(const files::XmlElement& world, std::vector<description::Unused>& unused) {
  for (const char* tag : {"geom", "site"}) {
    for (const files::XmlElement& element : elements_in(world, tag)) {
      const bool plane = element.attribute("type").value_or("") == "plane";
      const std::string what =
          files::one_line(fmt::format("world {} '{}'", tag, element.attribute("name").value_or("")));
      unused.push_back({what, fmt::format("{}: {} ignored: {}", element.where(), what,
                                          plane ? "the scene brings its own ground" : "it is no part of the robot")});
    }
  }
}

std::vector<Base> top_bodies(const files::XmlElement& root, const MjcfDefaults& defaults,
                             const MjcfCompiler& compiler) {
  std::vector<Base> bodies;
  for (const files::XmlElement& world : root.children("worldbody")) {
    for (const MjcfChild& child : children_in(world, defaults.child_class(world, {}), defaults, compiler)) {
      if (child.element.tag() == "body") bodies.push_back({child.element, child.child_class});
    }
  }
  return bodies;
}

Base find_base(const files::XmlElement& root, const std::vector<Base>& bodies, const MjcfDefaults& defaults,
               bool lenient, std::vector<std::string>& warnings) {
  if (bodies.empty()) root.fail("there is no body in worldbody; a robot needs one");
  if (bodies.size() > 1) {
    const auto what = fmt::format("second body in worldbody, '{}'; a robot file has one robot",
                                  bodies[1].body.attribute("name").value_or(""));
    if (!lenient) bodies[1].body.fail(what);
    warnings.push_back(files::one_line(fmt::format("{}: {}", bodies[1].body.where(), what)));
  }
  for (const Base& base : bodies) {
    if (has_free_joint(base.body, base.child_class, defaults)) return base;
  }
  bodies[0].body.fail(fmt::format("body '{}' has no free joint; add <freejoint/> to it",
                                  bodies[0].body.attribute("name").value_or("")));
}

/// settotalmass: masses and inertias in proportion.
void scale_masses(const MjcfCompiler& compiler, description::RobotDescription& description) {
  double total = 0;
  for (const description::BodyDescription& body : description.bodies) total += body.solid.mass;
  if (!(compiler.total_mass > 0) || !(total > 0)) return;
  const double factor = compiler.total_mass / total;
  for (description::BodyDescription& body : description.bodies) {
    body.solid.mass *= factor;
    body.solid.inertia = factor * body.solid.inertia;
  }
}

}  // namespace

description::RobotDescription read_mjcf(const std::filesystem::path& file, const description::ReaderOptions& options) {
  files::XmlFile xml(file);
  const files::XmlElement root = xml.root();
  if (root.tag() != "mujoco") {
    root.fail(fmt::format("the root is <{}>, not <mujoco>; this is no MJCF file", root.tag()));
  }
  xml.follow_includes();
  description::RobotDescription description;
  description.file = file;
  description.name = root.attribute("model").value_or(file.stem().string());
  for (auto& [word, line] : files::validate(root, mjcf_schema(), options.lenient, description.warnings)) {
    if (word != "geom" && word != "site") description.unused.push_back({std::move(word), std::move(line)});
  }
  MjcfCompiler compiler = read_compiler(root);
  attach_models(xml, root, compiler, options.lenient, description);
  expand_replicates(xml, root, compiler);
  for (const files::XmlElement& world : root.children("worldbody")) name_world(world, description.unused);

  const MjcfDefaults defaults(root);
  const auto tops = top_bodies(root, defaults, compiler);
  const auto [base, child_class] = find_base(root, tops, defaults, options.lenient, description.warnings);
  const MjcfNames names(base);
  MjcfMeshes meshes(file, root, defaults, compiler, options.part_per_group, description.warnings);
  const MjcfMaterials materials(root, defaults);
  description.meshes = meshes.descriptions();
  const MjcfActuators actuators = read_actuators(root, defaults, compiler, names, options.lenient, description);
  const MjcfContext context{.defaults = defaults,
                            .compiler = compiler,
                            .names = names,
                            .actuators = actuators.by_joint,
                            .materials = materials,
                            .lenient = options.lenient,
                            .meshes = meshes,
                            .warnings = description.warnings};
  read_bodies(base, child_class, context, description);
  scale_masses(compiler, description);
  description::resolve_damping_ratios(description);
  read_relations(root, names, defaults, description);
  read_loops(root, description);
  read_keyframes(root, actuators, tops.size() == 1, description);
  return description;
}

}  // namespace murosimf::formats::mjcf
