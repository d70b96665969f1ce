#include "murosimf/robot_formats/mjcf/mjcf_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/file_spelling.h"
#include "murosimf/geometry/hull.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_mesh_source.h"

namespace murosimf::robot_formats::mjcf {
namespace {

constexpr double overcount_ratio = 1.01;  // [1] of the volume, up to which inertia "legacy" counts as exact

Transformd origin_of(const MjcfAttributes& attributes) {
  return {attributes.vector("refpos", {}), read_quaternion(attributes, "refquat")};
}

}  // namespace

struct MjcfMeshes::Mesh {
  explicit Mesh(MjcfAttributes all) : attributes(std::move(all)) {}

  MjcfAttributes attributes;
  std::string what;  ///< "mesh 'torso' (meshes/torso.stl)"
  robot_formats::mesh::SolidMesh solid;
  bool read = false;

  [[noreturn]] void fail(const std::string& message) const { attributes.element().fail(what + ": " + message); }
  /// [m^3] Signed volume: negative for a mesh that is inside out.
  [[nodiscard]] double volume() const { return geometry::solid_mass(solid.triangles).volume; }
  [[nodiscard]] std::string seams_text() const {
    return fmt::format("the mesh is not closed ({} open edges, {} between triangles that look different ways)",
                       solid.seams.open, solid.seams.flipped);
  }
};

MjcfMeshes::MjcfMeshes(const std::filesystem::path& file, const files::XmlElement& root, const MjcfDefaults& defaults,
                       const MjcfCompiler& compiler, const std::vector<std::string>& part_per_group,
                       std::vector<std::string>& warnings)
    : folder_(file.parent_path() / compiler.mesh_folder),
      strip_path_(compiler.strip_path),
      part_per_group_(part_per_group),
      warnings_(warnings) {
  for (const files::XmlElement& asset : root.children("asset")) {
    for (const files::XmlElement& element : asset.children("mesh")) {
      auto mesh = std::make_unique<Mesh>(defaults.resolve(element));
      const std::string name = mesh_name(mesh->attributes);
      if (!meshes_.emplace(name, std::move(mesh)).second) {
        element.fail(fmt::format("mesh '{}' is already there; choose another name", name));
      }
    }
  }
}

MjcfMeshes::~MjcfMeshes() = default;

std::vector<robot_formats::MeshDescription> MjcfMeshes::descriptions() const {
  std::vector<robot_formats::MeshDescription> descriptions;
  for (const auto& [name, mesh] : meshes_) {
    const MjcfAttributes& attributes = mesh->attributes;
    descriptions.push_back({name, attributes.element().where(), path_of(attributes),
                            attributes.vector("scale", {1, 1, 1}), origin_of(attributes)});
  }
  return descriptions;
}

const std::vector<robot_formats::mesh::ConvexPart>& MjcfMeshes::parts(const std::string& name,
                                                                      const files::XmlElement& user) {
  const Mesh& mesh = loaded(name, user);
  if (!mesh.solid.flat.empty()) mesh.fail(mesh.solid.flat);
  for (const std::string& doubt : robot_formats::mesh::mesh_doubts(mesh.solid)) warn(mesh, doubt);
  return mesh.solid.parts;
}

void MjcfMeshes::check_file(const std::string& name, const files::XmlElement& user) {
  Mesh& mesh = find(name, user);
  mesh.what = "mesh '" + name + "'";
  const auto file = path_of(mesh.attributes);
  std::error_code none;
  if (!file.empty() && !std::filesystem::is_regular_file(file, none)) {
    warn(mesh, fmt::format("there is no file {}; it is visual only and left out", file.string()));
  }
}

std::string MjcfMeshes::material(const std::string& name, const files::XmlElement& user) {
  return find(name, user).attributes.text("material");
}

geometry::SolidMass MjcfMeshes::mass(const std::string& name, const files::XmlElement& user) {
  const Mesh& mesh = loaded(name, user);
  const auto kind = mesh.attributes.choice("inertia", {"legacy", "exact", "convex", "shell"});
  if (kind == "shell") return geometry::shell_mass(mesh.solid.triangles);
  if (!mesh.solid.flat.empty())
    mesh.fail(mesh.solid.flat + "; give the body an inertial, or the mesh inertia=\"shell\"");
  if (kind == "convex") return robot_formats::mesh::hull_mass(mesh.solid.parts);
  if (kind == "exact") return exact_mass(mesh);
  // The sum of the absolute volumes of all tetrahedra from the center: it counts cavities, too.
  const auto solid = geometry::summed_mass(mesh.solid.triangles);
  if (!mesh.solid.seams.closed()) {
    warn(mesh, mesh.seams_text() + ", so its mass is an estimate; repair it, or write inertia=\"convex\"");
  } else if (solid.volume > overcount_ratio * std::fabs(mesh.volume())) {
    warn(mesh,
         fmt::format("inertia \"legacy\", the default of MJCF, counts {:.4g} times the volume of this concave mesh; "
                     "write inertia=\"exact\"",
                     solid.volume / std::fabs(mesh.volume())));
  }
  return solid;
}

geometry::SolidMass MjcfMeshes::exact_mass(const Mesh& mesh) {
  if (!mesh.solid.seams.closed()) mesh.fail(mesh.seams_text() + "; repair it, or write inertia=\"convex\"");
  const auto solid = geometry::solid_mass(mesh.solid.triangles);
  if (!(solid.volume > 0)) mesh.fail("the mesh is inside out: its triangles look inwards; flip them");
  return solid;
}

MjcfMeshes::Mesh& MjcfMeshes::find(const std::string& name, const files::XmlElement& user) {
  const auto found = meshes_.find(name);
  if (found != meshes_.end()) return *found->second;
  std::vector<std::string_view> known;
  for (const auto& [other, mesh] : meshes_) known.push_back(other);
  user.fail(unknown_name("mesh", name, known));
}

MjcfMeshes::Mesh& MjcfMeshes::loaded(const std::string& name, const files::XmlElement& user) {
  Mesh& mesh = find(name, user);
  if (!mesh.read) {
    with_context(mesh.attributes.element().where() + ": mesh '" + name + "'", [&] { load(name, mesh); });
    mesh.read = true;  // not in load(): a mesh that failed is reported again by its next user
  }
  return mesh;
}

void MjcfMeshes::load(const std::string& name, Mesh& mesh) {
  const MjcfAttributes& attributes = mesh.attributes;
  mesh.what = "mesh '" + name + "'";
  if (attributes.has("file") == attributes.has("vertex")) throw SetupError("it needs either a file or vertices");
  robot_formats::mesh::MeshFile file = attributes.has("file") ? file_of(attributes) : read_inline_mesh(attributes);
  if (attributes.has("file")) mesh.what += " (" + attributes.text("file") + ")";
  place_mesh(file.mesh, attributes);
  const bool split = std::ranges::find(part_per_group_, name) != part_per_group_.end();
  mesh.solid = robot_formats::mesh::make_solid_mesh(std::move(file), split);
  MUROSIMF_ASSERT(!mesh.solid.parts.empty() || !mesh.solid.flat.empty());
}

std::filesystem::path MjcfMeshes::path_of(const MjcfAttributes& attributes) const {
  const std::filesystem::path name = attributes.text("file");
  if (name.empty()) return {};
  const std::filesystem::path wanted = strip_path_ ? name.filename() : name;
  return files::find_spelled(folder_, wanted.string()).value_or(folder_ / wanted);
}

const robot_formats::mesh::MeshFile& MjcfMeshes::file_of(const MjcfAttributes& attributes) {
  const auto path = path_of(attributes);
  const auto found = files_.find(path);
  return found != files_.end() ? found->second
                               : files_.emplace(path, robot_formats::mesh::read_mesh_file(path)).first->second;
}

void MjcfMeshes::warn(const Mesh& mesh, const std::string& message) {
  const auto line = files::one_line(fmt::format("{}: {}: {}", mesh.attributes.element().where(), mesh.what, message));
  // A mesh of many geoms is reported once.
  if (std::ranges::find(warnings_, line) == warnings_.end()) warnings_.push_back(line);
}

}  // namespace murosimf::robot_formats::mjcf
