#include "murosimf/appearance/visual_meshes.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "murosimf/collision/relief/relief.h"
#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/geometry/mesh_reduction.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"
#include "murosimf/robot_formats/mesh/mesh_library.h"
#include "murosimf/robot_formats/mesh/mtl_file.h"

namespace murosimf::appearance {
namespace {

using robot_formats::mesh::MeshFile;

constexpr std::size_t most_colors = 100;  // of a mesh; others are drawn as if they had none
constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

/// A file's mesh in the frame of the object.
MeshFile read_placed(const VisualMesh& mesh) {
  const Vec3d& s = mesh.scale;
  if (s.x == 0 || s.y == 0 || s.z == 0) {
    throw SetupError(fmt::format("{}: a scale of 0 makes the mesh flat; correct it", mesh.file));
  }
  MeshFile file = robot_formats::mesh::read_mesh_file(mesh.file);
  geometry::TriangleMesh& triangles = file.mesh;
  triangles.places = std::move(file.picture_places);
  if (!triangles.places.empty()) triangles.places.resize(triangles.triangles.size());
  for (Vec3d& v : triangles.vertices) v = transposed_times(mesh.file_orientation, v - mesh.file_position);
  robot_formats::mesh::scale_mesh(triangles, s);
  for (Vec3d& v : triangles.vertices) v = mesh.position + mesh.orientation * v;
  file.picture_places = triangles.places;
  return file;
}

/// The triangles of one part, with its own vertices. `number`: of each vertex of the file, all none; is left so.
geometry::TriangleMesh own_mesh(const geometry::TriangleMesh& file, const std::vector<std::size_t>& triangles,
                                std::vector<std::uint32_t>& number) {
  geometry::TriangleMesh mesh;
  std::vector<std::uint32_t> used;
  for (const std::size_t triangle : triangles) {
    auto corners = file.triangles[triangle];
    for (std::uint32_t& corner : corners) {
      MUROSIMF_ASSERT(corner < number.size());
      if (number[corner] == no_vertex) {
        number[corner] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(file.vertices[corner]);
        used.push_back(corner);
      }
      corner = number[corner];
    }
    mesh.triangles.push_back(corners);
    if (!file.places.empty()) mesh.places.push_back(file.places[triangle]);
  }
  for (const std::uint32_t corner : used) number[corner] = no_vertex;
  return mesh;
}

struct Paint {
  Color color;
  bool as_it_is = false;  // VisualPart
  PicturePtr picture{};   // VisualPart
  friend bool operator==(const Paint&, const Paint&) = default;
};

/// Those of the materials, the first of which is that of triangles without one. `pictures`: by material; may be empty.
std::vector<Paint> paints_of(const MeshFile& file, const std::vector<PicturePtr>& pictures, const Color& otherwise) {
  std::vector<Paint> paints{{otherwise}};
  for (std::size_t i = 0; i < file.materials.size(); ++i) {
    const auto& color = file.materials[i].color;
    const PicturePtr picture = i < pictures.size() ? pictures[i] : nullptr;
    paints.push_back({color.value_or(picture ? Color{1, 1, 1} : otherwise), color || picture, picture});
  }
  return paints;
}

/// `of_pictures`: by triangle, where it has a picture; may be empty.
std::vector<VisualPart> parts_by_paint(const MeshFile& file, const std::vector<Paint>& paints,
                                       const std::vector<std::optional<Color>>& of_pictures) {
  std::vector<Paint> different;
  const auto part_of = [&](const Paint& paint) {
    auto known = std::ranges::find(different, paint);
    if (known == different.end() && different.size() == most_colors) known = different.begin();
    const auto part = static_cast<std::size_t>(known - different.begin());
    if (known == different.end()) different.push_back(paint);
    return part;
  };
  std::vector<std::size_t> part_of_material;
  for (const Paint& paint : paints) part_of_material.push_back(part_of(paint));
  std::vector<std::vector<std::size_t>> triangles(most_colors);
  for (std::size_t i = 0; i < file.mesh.triangles.size(); ++i) {
    const std::uint32_t material = i < file.material_of.size() ? file.material_of[i] : 0;
    MUROSIMF_ASSERT(material < part_of_material.size());
    const bool pictured = i < of_pictures.size() && of_pictures[i];
    triangles[pictured ? part_of({*of_pictures[i], true}) : part_of_material[material]].push_back(i);
  }
  std::vector<std::uint32_t> number(file.mesh.vertices.size(), no_vertex);
  std::vector<VisualPart> parts;
  for (std::size_t i = 0; i < different.size(); ++i) {
    if (triangles[i].empty()) continue;
    const auto& [color, as_it_is, picture] = different[i];
    parts.push_back({own_mesh(file.mesh, triangles[i], number), color, as_it_is, picture});
    if (!picture) parts.back().mesh.places.clear();
  }
  return parts;
}

VisualPart plain_part(MeshFile file, const Color& color) {
  file.mesh.places.clear();
  return {std::move(file.mesh), color};
}

/// Repeats a picture from its upper left corner on.
void repeat(const std::array<double, 2>& times, std::vector<geometry::PicturePlaces>& places) {
  for (geometry::PicturePlaces& corners : places) {
    for (auto& [right, up] : corners) {
      right = static_cast<float>(times[0] * double{right});
      up = static_cast<float>(1 - times[1] * (1 - double{up}));
    }
  }
}

/// Colored by the picture that the robot's file gives the mesh; in the mesh's color where that cannot be.
std::vector<VisualPart> parts_by_picture(const VisualMesh& mesh, MeshFile file, MeshPictures& pictures, PictureUse use,
                                         std::vector<std::string>& notes) {
  const PicturePtr picture = pictures.read(mesh.picture, notes);
  if (picture && file.picture_places.empty()) {
    notes.push_back(
        fmt::format("{}: the texture {} is not drawn: no corner has a place in it", mesh.file, mesh.picture));
  }
  if (!picture || file.picture_places.empty()) return {plain_part(std::move(file), mesh.color)};
  repeat(mesh.picture_repeat, file.mesh.places);
  file.picture_places = file.mesh.places;
  if (use == PictureUse::by_pixel) return {{std::move(file.mesh), mesh.color, true, picture}};
  file.materials.clear();
  file.material_of.clear();
  return parts_by_paint(file, {{mesh.color}}, picture_colors(picture->whole(), file, mesh.color));
}

/// Adds visual meshes. True if one of them is visible.
bool add_visuals(const Model& model, int object, MeshPictures& pictures, PictureUse use, Appearance& appearance) {
  const Visuals* visuals = model.find(properties::visuals, object);
  bool any = false;
  for (const VisualMesh& visual : visuals ? *visuals : Visuals{}) {
    try {
      for (VisualPart& part : visual_parts(visual, pictures, use, appearance.warnings)) {
        appearance.meshes.push_back({object, std::move(part.mesh), part.color, part.as_it_is, part.picture});
      }
      any = true;
    } catch (const SetupError& error) {
      appearance.warnings.push_back(
          fmt::format("{}; '{}' is drawn without it", error.what(), model.objects()[object].name));
    }
  }
  return any;
}

void add_shape(const PlacedShape& placed, int object, Appearance& appearance) {
  const Convex* convex = std::get_if<Convex>(&placed.shape);
  if (!convex) {
    appearance.shapes.push_back({object, placed});
    return;
  }
  geometry::TriangleMesh mesh = geometry::triangles_of(*convex->hull);
  for (Vec3d& v : mesh.vertices) v = placed.position + placed.orientation * v;
  appearance.meshes.push_back({object, std::move(mesh), placed.color});
}

void reduce(Appearance& appearance, std::size_t most) {
  std::vector<geometry::TriangleMesh> meshes;
  for (SeenMesh& seen : appearance.meshes) meshes.push_back(std::move(seen.mesh));
  auto [reduced, error] = geometry::reduce_meshes(std::move(meshes), most);
  MUROSIMF_ASSERT(reduced.size() == appearance.meshes.size());
  for (std::size_t i = 0; i < reduced.size(); ++i) appearance.meshes[i].mesh = std::move(reduced[i]);
  std::erase_if(appearance.meshes, [](const SeenMesh& seen) { return seen.mesh.triangles.empty(); });
  appearance.error = error;
}

}  // namespace

geometry::TriangleMesh visual_triangles(const VisualMesh& mesh) { return read_placed(mesh).mesh; }

std::vector<VisualPart> visual_parts(const VisualMesh& mesh, MeshPictures& pictures, PictureUse use,
                                     std::vector<std::string>& notes) {
  MeshFile file = read_placed(mesh);
  if (!mesh.picture.empty()) return parts_by_picture(mesh, std::move(file), pictures, use, notes);
  if (!mesh.mesh_colors || file.materials.empty()) return {plain_part(std::move(file), mesh.color)};
  std::ranges::move(robot_formats::mesh::add_mtl_colors(mesh.file, file), std::back_inserter(notes));
  const bool pictured =
      std::ranges::any_of(file.materials, [](const auto& material) { return !material.picture.empty(); });
  if (!pictured) return parts_by_paint(file, paints_of(file, {}, mesh.color), {});
  if (use == PictureUse::by_triangle)
    return parts_by_paint(file, paints_of(file, {}, mesh.color), picture_colors(mesh.file, file, pictures, notes));
  file.mesh.places.resize(file.mesh.triangles.size());
  return parts_by_paint(file, paints_of(file, pictures.of_materials(mesh.file, file, notes), mesh.color), {});
}

std::vector<std::string> visual_files(const Model& model) {
  std::vector<std::string> files;
  for (int object = 0; object < model.size(); ++object) {
    const Visuals* visuals = model.find(properties::visuals, object);
    for (const VisualMesh& visual : visuals ? *visuals : Visuals{}) {
      files.push_back(visual.file);
      if (!visual.picture.empty()) files.push_back(visual.picture);
    }
  }
  return files;
}

Appearance appearance_of(const Model& model, std::size_t most) {
  MeshPictures pictures;
  return appearance_of(model, most, pictures, PictureUse::by_pixel);
}

Appearance appearance_of(const Model& model, std::size_t most, MeshPictures& pictures, PictureUse use) {
  Appearance appearance;
  std::vector<SeenMesh> grounds;  // with all of their triangles: bodies stand on these
  for (int object = 0; object < model.size(); ++object) {
    if (const auto* relief = model.find(properties::relief, object)) {
      grounds.push_back({object, (*relief)->mesh(), model.find(properties::shapes, object)->front().color});
      continue;
    }
    const bool dressed = add_visuals(model, object, pictures, use, appearance);
    const Shapes* shapes = model.find(properties::shapes, object);
    for (const PlacedShape& placed : shapes ? *shapes : Shapes{}) {
      if (!dressed || !placed.collides) add_shape(placed, object, appearance);
    }
  }
  reduce(appearance, most);
  std::ranges::move(grounds, std::back_inserter(appearance.meshes));
  return appearance;
}

}  // namespace murosimf::appearance
