#include "murosimf/io/mjcf_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/geometry/hull.h"
#include "murosimf/io/mjcf_mesh_source.h"
#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

constexpr double concave_ratio = 1.1;     // [1] hull over mesh volume, above which contact differs visibly
constexpr double overcount_ratio = 1.01;  // [1] of the volume that inertia "legacy" may add unnoticed
constexpr double most_width = 20;         // [m] no robot is so large; a file in millimeters is

MeshPart make_part(const geometry::TriangleMesh& mesh) {
  auto [hull, middle] = geometry::make_hull(mesh.vertices);
  return {{std::make_shared<const ConvexHull>(std::move(hull))}, middle};
}

geometry::SolidMass solid_of(const MeshPart& part) {
  auto solid = geometry::solid_mass(*part.shape.hull);
  solid.center += part.middle;
  return solid;
}

/// Several parts as one; where they overlap, the overlap counts twice.
geometry::SolidMass solid_of(const std::vector<MeshPart>& parts) {
  geometry::SolidMass sum;
  for (const MeshPart& part : parts) {
    const auto solid = solid_of(part);
    sum.volume += solid.volume;
    sum.center += solid.volume * solid.center;
  }
  sum.center = (1.0 / sum.volume) * sum.center;
  for (const MeshPart& part : parts) {
    const auto solid = solid_of(part);
    sum.inertia += solid.inertia + solid.volume * inertia_of_point(solid.center - sum.center);
  }
  return sum;
}

double width(const std::vector<Vec3d>& vertices) {
  double largest = 0;
  for (const Vec3d& v : vertices) largest = std::max(largest, norm(v - vertices[0]));
  return largest;
}

}  // namespace

struct MjcfMeshes::Mesh {
  explicit Mesh(MjcfAttributes all) : attributes(std::move(all)) {}

  MjcfAttributes attributes;
  std::string what;  ///< "mesh 'torso' (meshes/torso.stl)"
  geometry::TriangleMesh triangles;
  geometry::Seams seams;
  std::vector<MeshPart> parts;
  std::string flat;  ///< why there are no parts
  bool read = false;

  [[noreturn]] void fail(const std::string& message) const { attributes.element().fail(what + ": " + message); }
  /// [m^3] Signed.
  [[nodiscard]] double volume() const { return geometry::solid_mass(triangles).volume; }
  [[nodiscard]] std::string seams_text() const {
    return fmt::format("the mesh is not closed ({} open edges, {} between triangles that look different ways)",
                       seams.open, seams.flipped);
  }
};

MjcfMeshes::MjcfMeshes(const std::filesystem::path& file, const XmlElement& root, const MjcfDefaults& defaults,
                       const MjcfCompiler& compiler, const std::vector<std::string>& part_per_group,
                       std::vector<std::string>& warnings)
    : folder_(file.parent_path() / compiler.mesh_folder),
      strip_path_(compiler.strip_path),
      part_per_group_(part_per_group),
      warnings_(warnings) {
  for (const XmlElement& asset : root.children("asset")) {
    for (const XmlElement& element : asset.children("mesh")) {
      auto mesh = std::make_unique<Mesh>(defaults.resolve(element));
      const std::string name = mesh_name(mesh->attributes);
      if (!meshes_.emplace(name, std::move(mesh)).second) {
        element.fail(fmt::format("mesh '{}' is already there; choose another name", name));
      }
    }
  }
}

MjcfMeshes::~MjcfMeshes() = default;

std::vector<DraftMesh> MjcfMeshes::drafts() const {
  std::vector<DraftMesh> drafts;
  for (const auto& [name, mesh] : meshes_) {
    const MjcfAttributes& attributes = mesh->attributes;
    DraftMesh draft{name, attributes.element().where()};
    if (attributes.has("file")) draft.file = path_of(attributes);
    draft.scale = attributes.vector("scale", {1, 1, 1});
    draft.origin = {attributes.vector("refpos", {}), read_quaternion(attributes, "refquat")};
    drafts.push_back(draft);
  }
  return drafts;
}

const std::vector<MeshPart>& MjcfMeshes::parts(const std::string& name, const XmlElement& user) {
  const Mesh& mesh = loaded(name, user);
  if (!mesh.flat.empty()) mesh.fail(mesh.flat);
  warn_about_parts(mesh);
  return mesh.parts;
}

void MjcfMeshes::check_file(const std::string& name, const XmlElement& user) {
  Mesh& mesh = find(name, user);
  mesh.what = "mesh '" + name + "'";
  if (!mesh.attributes.has("file")) return;
  const auto path = path_of(mesh.attributes);
  if (!std::filesystem::is_regular_file(path)) {
    warn(mesh, fmt::format("there is no file {}; it is for the eye only and left out", path.string()));
  }
}

geometry::SolidMass MjcfMeshes::mass(const std::string& name, const XmlElement& user) {
  const Mesh& mesh = loaded(name, user);
  const auto kind = mesh.attributes.choice("inertia", {"legacy", "exact", "convex", "shell"});
  if (kind == "shell") return geometry::shell_mass(mesh.triangles);
  if (!mesh.flat.empty()) mesh.fail(mesh.flat + "; give the body an inertial, or the mesh inertia=\"shell\"");
  if (kind == "convex") return solid_of(mesh.parts);
  if (kind == "exact") return exact_mass(mesh);
  const auto solid = geometry::summed_mass(mesh.triangles);
  if (!mesh.seams.closed()) {
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
  if (!mesh.seams.closed()) mesh.fail(mesh.seams_text() + "; repair it, or write inertia=\"convex\"");
  const auto solid = geometry::solid_mass(mesh.triangles);
  if (!(solid.volume > 0)) mesh.fail("the mesh is inside out: its triangles look inwards; flip them");
  return solid;
}

MjcfMeshes::Mesh& MjcfMeshes::find(const std::string& name, const XmlElement& user) {
  const auto found = meshes_.find(name);
  if (found != meshes_.end()) return *found->second;
  std::vector<std::string_view> known;
  for (const auto& [other, mesh] : meshes_) known.push_back(other);
  user.fail(unknown_name("mesh", name, known));
}

MjcfMeshes::Mesh& MjcfMeshes::loaded(const std::string& name, const XmlElement& user) {
  Mesh& mesh = find(name, user);
  if (!std::exchange(mesh.read, true)) {
    at(mesh.attributes.element().where() + ": mesh '" + name + "'", [&] { load(name, mesh); });
  }
  return mesh;
}

void MjcfMeshes::load(const std::string& name, Mesh& mesh) {
  const MjcfAttributes& attributes = mesh.attributes;
  mesh.what = "mesh '" + name + "'";
  if (attributes.has("file") == attributes.has("vertex")) throw SetupError("it needs either a file or vertices");
  MeshFile file = attributes.has("file") ? file_of(attributes) : read_inline_mesh(attributes);
  if (attributes.has("file")) mesh.what += " (" + attributes.text("file") + ")";
  place_mesh(file.mesh, attributes);
  mesh.triangles = file.mesh;
  mesh.seams = geometry::find_seams(mesh.triangles);
  const bool split = std::ranges::find(part_per_group_, name) != part_per_group_.end();
  if (!split) file.part_begin = {0};
  try {
    for (const auto& part : split_parts(file)) mesh.parts.push_back(make_part(part));
  } catch (const SetupError& error) {
    mesh.parts.clear();
    mesh.flat = error.what();
  }
  if (const double size = width(mesh.triangles.vertices); size > most_width) {
    warn(mesh, fmt::format("it is {:.4g} m wide; a file in millimeters needs scale=\"0.001 0.001 0.001\"", size));
  }
}

std::filesystem::path MjcfMeshes::path_of(const MjcfAttributes& attributes) const {
  const std::filesystem::path name = attributes.text("file");
  return folder_ / (strip_path_ ? name.filename() : name);
}

const MeshFile& MjcfMeshes::file_of(const MjcfAttributes& attributes) {
  const auto path = path_of(attributes);
  const auto found = files_.find(path);
  return found != files_.end() ? found->second : files_.emplace(path, read_mesh_file(path)).first->second;
}

void MjcfMeshes::warn(const Mesh& mesh, const std::string& message) {
  const auto line = one_line(fmt::format("{}: {}: {}", mesh.attributes.element().where(), mesh.what, message));
  if (std::ranges::find(warnings_, line) == warnings_.end()) warnings_.push_back(line);
}

void MjcfMeshes::warn_about_parts(const Mesh& mesh) {
  if (!mesh.seams.closed()) warn(mesh, mesh.seams_text() + "; contact sees its convex hull");
  const double ratio = solid_of(mesh.parts).volume / std::fabs(mesh.volume());
  if (mesh.seams.closed() && ratio > concave_ratio) {
    warn(mesh,
         fmt::format("the mesh is concave: contact sees its convex hull, {:.3g} times its volume; where that matters, "
                     "split it into convex parts",
                     ratio));
  }
  for (const MeshPart& part : mesh.parts) {
    const std::size_t count = part.shape.hull->vertices.size();
    if (count > geometry::many_vertices) {
      warn(mesh, fmt::format("its hull has {} vertices, which slows contact down; simplify it ({} are plenty)", count,
                             geometry::many_vertices));
    }
  }
}

}  // namespace murosimf::io
