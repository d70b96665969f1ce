#include "murosimf/io/mjcf_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/io/mjcf_actuator.h"
#include "murosimf/io/mjcf_body.h"
#include "murosimf/io/mjcf_vocabulary.h"

namespace murosimf::io {
namespace {

/// The robot's first body and the class that holds around it.
struct Base {
  XmlElement body;
  std::string child_class;
};

void check_words(const XmlElement& root, bool lenient, MjcfResult& result) {
  const VocabularyFindings found = check_vocabulary(root);
  if (!found.refused.empty() && !lenient) {
    const std::size_t more = found.refused.size() - 1;
    throw SetupError(found.refused.front() + (more > 0 ? fmt::format(" (and {} more like this)", more) : ""));
  }
  result.notes = found.notes;
  result.warnings = found.refused;
}

void note_world(const XmlElement& world, std::vector<std::string>& notes) {
  for (const char* tag : {"geom", "site"}) {
    for (const XmlElement& element : world.children(tag)) {
      const bool plane = element.attribute("type").value_or("") == "plane";
      notes.push_back(one_line(fmt::format("{}: world {} '{}' ignored: {}", element.where(), tag,
                                           element.attribute("name").value_or(""),
                                           plane ? "the scene brings its own ground" : "it is no part of the robot")));
    }
  }
}

std::vector<Base> top_bodies(const XmlElement& root, const MjcfDefaults& defaults) {
  std::vector<Base> bodies;
  for (const XmlElement& world : root.children("worldbody")) {
    for (const XmlElement& body : world.children("body")) bodies.push_back({body, defaults.child_class(world, {})});
  }
  return bodies;
}

Base find_base(const XmlElement& root, const MjcfDefaults& defaults, bool lenient, std::vector<std::string>& warnings) {
  const auto bodies = top_bodies(root, defaults);
  if (bodies.empty()) root.fail("there is no body in worldbody; a robot needs one");
  if (bodies.size() > 1) {
    const auto what = fmt::format("second body in worldbody, '{}'; a robot file has one robot",
                                  bodies[1].body.attribute("name").value_or(""));
    if (!lenient) bodies[1].body.fail(what);
    warnings.push_back(one_line(fmt::format("{}: {}", bodies[1].body.where(), what)));
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

ModelPtr make_model(const std::string& name, const Chain& chain, const XmlElement& base) {
  try {
    return std::make_shared<const Model>(name, chain);
  } catch (const SetupError& error) {
    base.fail(error.what());
  }
}

}  // namespace

MjcfResult read_mjcf(const std::filesystem::path& file, const MjcfOptions& options) {
  const XmlFile xml(file);
  const XmlElement root = xml.root();
  if (root.tag() != "mujoco")
    root.fail(fmt::format("the root is <{}>, not <mujoco>; this is no MJCF file", root.tag()));
  MjcfResult result;
  check_words(root, options.lenient, result);
  for (const XmlElement& world : root.children("worldbody")) note_world(world, result.notes);

  const MjcfDefaults defaults(root);
  const MjcfCompiler compiler = read_compiler(root);
  const auto [base, child_class] = find_base(root, defaults, options.lenient, result.warnings);
  const MjcfNames names(base);
  const RobotTable table = read_table_beside(file);
  MjcfMeshes meshes(file, root, defaults, compiler, table, result.warnings);
  check_names(table, names.joints(), names.bodies(), names.sites(), meshes.names());

  const auto servos = read_actuators(root, defaults, compiler, names, options.lenient, result.warnings);
  const MjcfContext context{defaults, compiler, names, table, servos, options.lenient, meshes, result.warnings};
  const Chain robot = build_robot(base, child_class, context);
  result.model = make_model(root.attribute("model").value_or(file.stem().string()), robot, base);
  return result;
}

}  // namespace murosimf::io
