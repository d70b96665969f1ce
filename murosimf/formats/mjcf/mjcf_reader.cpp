#include "murosimf/formats/mjcf/mjcf_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/description/joint_inertia.h"
#include "murosimf/formats/mjcf/mjcf_actuator.h"
#include "murosimf/formats/mjcf/mjcf_body.h"
#include "murosimf/formats/mjcf/mjcf_relations.h"
#include "murosimf/formats/mjcf/mjcf_schema.h"
#include "murosimf/model/error.h"

namespace murosimf::formats::mjcf {
namespace {

/// The robot's first body and the class that holds around it.
struct Base {
  files::XmlElement body;
  std::string child_class;
};

void note_world(const files::XmlElement& world, std::vector<std::string>& notes) {
  for (const char* tag : {"geom", "site"}) {
    for (const files::XmlElement& element : world.children(tag)) {
      const bool plane = element.attribute("type").value_or("") == "plane";
      notes.push_back(files::one_line(
          fmt::format("{}: world {} '{}' ignored: {}", element.where(), tag, element.attribute("name").value_or(""),
                      plane ? "the scene brings its own ground" : "it is no part of the robot")));
    }
  }
}

std::vector<Base> top_bodies(const files::XmlElement& root, const MjcfDefaults& defaults) {
  std::vector<Base> bodies;
  for (const files::XmlElement& world : root.children("worldbody")) {
    for (const files::XmlElement& body : world.children("body"))
      bodies.push_back({body, defaults.child_class(world, {})});
  }
  return bodies;
}

Base find_base(const files::XmlElement& root, const MjcfDefaults& defaults, bool lenient,
               std::vector<std::string>& warnings) {
  const auto bodies = top_bodies(root, defaults);
  if (bodies.empty()) root.fail("there is no body in worldbody; a robot needs one");
  if (bodies.size() > 1) {
    const auto what = fmt::format("second body in worldbody, '{}'; a robot file has one robot",
                                  bodies[1].body.attribute("name").value_or(""));
    if (!lenient) bodies[1].body.fail(what);
    warnings.push_back(files::one_line(fmt::format("{}: {}", bodies[1].body.where(), what)));
  }
  for (const Base& base : bodies) {
    const std::string child_class = defaults.child_class(base.body, base.child_class);
    const auto joints = base.body.children();
    if (std::ranges::any_of(joints, [&](const auto& j) { return is_free_joint(j, child_class, defaults); }))
      return base;
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
  files::validate(root, mjcf_schema(), options.lenient, description.warnings, description.notes);
  for (const files::XmlElement& world : root.children("worldbody")) note_world(world, description.notes);

  const MjcfDefaults defaults(root);
  const MjcfCompiler compiler = read_compiler(root);
  const auto [base, child_class] = find_base(root, defaults, options.lenient, description.warnings);
  const MjcfNames names(base);
  MjcfMeshes meshes(file, root, defaults, compiler, options.part_per_group, description.warnings);
  description.meshes = meshes.descriptions();
  const auto actuators = read_actuators(root, defaults, compiler, names, options.lenient, description.warnings);
  const MjcfContext context{defaults, compiler, names, actuators, options.lenient, meshes, description.warnings};
  read_bodies(base, child_class, context, description);
  scale_masses(compiler, description);
  description::resolve_damping_ratios(description);
  read_relations(root, names, defaults, description);
  return description;
}

}  // namespace murosimf::formats::mjcf
