// [[bodies]] of a scene file: boxes, spheres, ramps and steps, one line each.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/files/toml_color.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mass_properties.h"
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/body_surface.h"
#include "murosimf/scene_file/section_readers.h"

namespace murosimf::scene_file {
namespace {

constexpr double largest_body = 1e3;  // [m]

double read_length(const files::TomlTable& table, std::string_view key, std::string_view meaning) {
  double length = 0;
  require(table.find(key) != nullptr, table, key, fmt::format("is missing: {}", meaning));
  table.read(key, length);
  require(length > 0 && length <= largest_body, table, key, "must be above 0, and no more than 1000 m");
  return length;
}

Box read_box(const files::TomlTable& table) {
  Vec3d size;
  require(table.find("size") != nullptr, table, "size", "is missing: lengths of the box's edges, [x, y, z] in m");
  table.read("size", size);
  require(size.x > 0 && size.y > 0 && size.z > 0, table, "size", "must be three numbers above 0: [x, y, z] in m");
  require(norm(size) <= largest_body, table, "size", "is more than 1000 m");
  return {0.5 * size};
}

/// Keys that belong to other shapes are errors.
void refuse_keys(const files::TomlTable& table, std::string_view shape, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) {
    require(table.find(key) == nullptr, table, key, fmt::format("is nothing that a {} has", shape));
  }
}

/// Keys of other shapes are refused: they would be without effect.
Shape read_round_shape(const files::TomlTable& table, const std::string& name) {
  refuse_keys(table, name, {"size"});
  const double radius = read_length(table, "radius", "in m");
  if (name == "sphere") {
    refuse_keys(table, name, {"length"});
    return Sphere{radius};
  }
  const double length = read_length(table, "length", "along its axis, from end to end, in m");
  if (name == "cylinder") return Cylinder{radius, 0.5 * length};
  require(length > 2 * radius, table, "length", "of a capsule must be more than twice its radius");
  return Capsule{radius, 0.5 * length - radius};
}

constexpr auto surface_keys = {"file", "heights", "height_scale", "scale", "thickness"};

void read_surface(const files::TomlTable& table, const std::string& name, const std::filesystem::path& folder,
                  BodySpec& body) {
  refuse_keys(table, name, {"radius", "length", "drag", "lift"});
  if (name == "heightfield") {
    refuse_keys(table, name, {"scale"});
    return read_height_field(table, folder, body);
  }
  refuse_keys(table, name, {"size", "heights", "height_scale"});
  read_mesh(table, folder, body);
}

Shape read_solid(const files::TomlTable& table, const std::string& name) {
  for (const char* key : surface_keys) refuse_keys(table, name, {key});
  if (name != "sphere") refuse_keys(table, name, {"drag", "lift"});
  if (name != "box") return read_round_shape(table, name);
  refuse_keys(table, name, {"radius", "length"});
  return read_box(table);
}

void read_shape(const files::TomlTable& table, const std::filesystem::path& folder, BodySpec& body) {
  std::string name;
  table.read("shape", name);
  const std::vector<std::string_view> known{"box", "sphere", "cylinder", "capsule", "heightfield", "mesh"};
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw SetupError(fmt::format("{}: {}", table.where("shape"), unknown_name("shape", name, known)));
  }
  if (name == "heightfield" || name == "mesh") return read_surface(table, name, folder, body);
  body.shape = read_solid(table, name);
}

/// Exactly one of mass and density: two would contradict each other.
void read_mass(const files::TomlTable& table, BodySpec& body) {
  double density = 0;
  table.read("density", density);
  const bool has_mass = table.find("mass") != nullptr, has_density = table.find("density") != nullptr;
  require(has_mass != has_density, table, has_density ? "density" : "mass",
          has_mass ? "and 'mass' say the same; keep one" : "is missing: in kg, or 'density' in kg/m^3");
  if (has_density) body.mass = density * robot_formats::volume(*body.shape);
  require(body.mass > 0, table, has_density ? "density" : "mass", "must be positive");
}

/// Shape and model exclude each other for the same reason.
void read_kind(const files::TomlTable& table, const std::filesystem::path& folder, BodySpec& body) {
  require(body.model.empty() != (table.find("shape") == nullptr), table, "shape",
          body.model.empty() ? "is missing: box, sphere, cylinder, capsule, heightfield or mesh; or 'model'"
                             : "and 'model' say the same; keep one");
  if (body.model.empty()) {
    read_shape(table, folder, body);
    return;
  }
  for (const char* key : surface_keys) refuse_keys(table, "body with a model", {key});
  refuse_keys(table, "body with a model", {"size", "radius", "length", "mass", "density", "material", "drag", "lift"});
  require(!body.is_static, table, "model", "cannot be static; use a shape");
}

BodySpec read_body(const toml::table& node, const std::filesystem::path& folder) {
  const files::TomlTable table(node, body_section().names());
  BodySpec body;
  body.where = table.where();
  body_section().read(table, body);
  require(!body.name.empty(), table, "name", "of the body is missing");
  read_kind(table, folder, body);
  if (body.is_static) {
    refuse_keys(table, "static body",
                {"mass", "density", "drag", "lift", "jitter", "velocity", "angular_velocity", "contact", "present"});
    return body;
  }
  if (body.shape) read_mass(table, body);
  return body;
}

bool is_taken(const SceneSpec& spec, const std::string& name) {
  const auto same = [&](const auto& other) { return other.name == name; };
  return name == "ball" || name == "field" || std::any_of(spec.robots.begin(), spec.robots.end(), same) ||
         std::any_of(spec.bodies.begin(), spec.bodies.end(), same);
}

}  // namespace

const Section<BodySpec>& body_section() {
  using Turn = Angle<BodySpec>;
  const Bounds turns = between(-3600, 3600);
  static const Section<BodySpec> section(
      "[[bodies]]",
      {{"name", &BodySpec::name, "", "of the entity", {}, "(needed)"},
       {"shape", {}, "", "box, sphere, cylinder, capsule, mesh; heightfield, if it is static", {}, "(or model)"},
       {"size", {}, "m", "of a box: lengths of its edges, [x, y, z]; of a heightfield: [x, y]"},
       {"radius", {}, "m", "of a sphere, cylinder, capsule"},
       {"length", {}, "m", "of a cylinder, capsule: from end to end, along z"},
       {"file", {}, "", "of a heightfield: PNG, NPY, CSV; of a mesh: STL, OBJ, DAE"},
       {"heights", {}, "m", "of a heightfield instead of a file: rows of numbers, the first at the largest y"},
       {"height_scale", {}, "", "of a heightfield: m of white in a picture, else a factor of the numbers", {}, "1"},
       {"scale", {}, "", "of a mesh: factor of its numbers", {}, "1"},
       {"thickness",
        {},
        "m",
        "of a heightfield below its lowest height; of a static mesh below its triangles",
        {},
        "0.1"},
       {"mass", &BodySpec::mass, "kg", "the inertia is that of the homogeneous shape", {}, "(or density)"},
       {"density", {}, "kg/m^3", "instead of the mass"},
       {"model", &BodySpec::model, "", "a robot file, instead of shape, mass and material"},
       {"material", &BodySpec::material, "", "of its surface"},
       {"drag", &BodySpec::drag, "", "of a sphere: C_d in air", between(0, 10)},
       {"lift", &BodySpec::lift, "", "of a sphere: what C_l comes to at high spin", between(0, 10)},
       {"color",
        [](const files::TomlTable& table, std::string_view, BodySpec& body) {
          body.color = files::read_color(table, body.color);
        },
        "",
        "red, green, blue from 0 to 1",
        {},
        "gray"},
       {"static", &BodySpec::is_static, "", "it stands there for good, without mass, velocity and contact law"},
       {"position", &BodySpec::position, "m",
        "x and y of its middle, z of its lowest point; of uneven ground: of its frame", up_to(farthest_place)},
       {"heading_deg", Turn{&BodySpec::heading}, "deg", "about the vertical", turns},
       {"roll_deg", Turn{&BodySpec::roll}, "deg", "about x, before the heading", turns},
       {"pitch_deg", Turn{&BodySpec::pitch}, "deg", "about y, before roll and heading; below 0 raises the +x end",
        turns},
       {"jitter", &BodySpec::jitters, "", "its place and heading vary as [start] says of robots"},
       {"velocity", &BodySpec::velocity, "m/s", "world, at the start"},
       {"angular_velocity", &BodySpec::angular_velocity, "rad/s", "world, at the start"},
       {"contact", Choice<BodySpec>{&BodySpec::contact, "contact law", [] { return entry_names(catalog::contacts()); }},
        "", "with the ground: murosimf list contacts"},
       {"present", &BodySpec::present, "", "at the start; an event 'NAME.present = true' brings it"}});
  return section;
}

/// Names are unique in the scene, since events and overrides refer to them.
void read_bodies(const files::TomlTable& scene, SceneSpec& spec) {
  for (const toml::table* node : scene.tables("bodies")) {
    BodySpec body = read_body(*node, spec.file.parent_path());
    if (is_taken(spec, body.name)) {
      files::fail_at(node->get("name")->source(), fmt::format("two entities are called '{}'", body.name));
    }
    spec.bodies.push_back(std::move(body));
  }
}

}  // namespace murosimf::scene_file
