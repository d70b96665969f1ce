#include "murosimf/scene_file/body_section.h"

#include <fnmatch.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/description/mass_properties.h"
#include "murosimf/files/toml_color.h"
#include "murosimf/model/error.h"

namespace murosimf::scene_file {
namespace {

constexpr double farthest_body = 1e4;  // [m]
constexpr double largest_body = 1e3;   // [m]

void body_must(bool condition, const files::TomlTable& table, std::string_view key, std::string_view message) {
  if (!condition) throw SetupError(fmt::format("{}: '{}' {}", table.where(key), key, message));
}

double read_length(const files::TomlTable& table, std::string_view key, std::string_view meaning) {
  double length = 0;
  body_must(table.find(key) != nullptr, table, key, fmt::format("is missing: {}", meaning));
  table.read(key, length);
  body_must(length > 0 && length <= largest_body, table, key, "must be above 0, and no more than 1000 m");
  return length;
}

Box read_box(const files::TomlTable& table) {
  Vec3d size;
  body_must(table.find("size") != nullptr, table, "size", "is missing: lengths of the box's edges, [x, y, z] in m");
  table.read("size", size);
  body_must(size.x > 0 && size.y > 0 && size.z > 0, table, "size", "must be three numbers above 0: [x, y, z] in m");
  body_must(norm(size) <= largest_body, table, "size", "is more than 1000 m");
  return {0.5 * size};
}

/// Keys that belong to other shapes are mistakes.
void refuse_keys(const files::TomlTable& table, std::string_view shape, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) {
    body_must(table.find(key) == nullptr, table, key, fmt::format("is nothing that a {} has", shape));
  }
}

Shape read_round_shape(const files::TomlTable& table, const std::string& name) {
  refuse_keys(table, name, {"size"});
  const double radius = read_length(table, "radius", "in m");
  if (name == "sphere") {
    refuse_keys(table, name, {"length"});
    return Sphere{radius};
  }
  const double length = read_length(table, "length", "along its axis, from end to end, in m");
  if (name == "cylinder") return Cylinder{radius, 0.5 * length};
  body_must(length > 2 * radius, table, "length", "of a capsule must be more than twice its radius");
  return Capsule{radius, 0.5 * length - radius};
}

Shape read_shape(const files::TomlTable& table) {
  std::string name;
  table.read("shape", name);
  const std::vector<std::string_view> known{"box", "sphere", "cylinder", "capsule"};
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw SetupError(fmt::format("{}: {}", table.where("shape"), unknown_name("shape", name, known)));
  }
  if (name != "box") return read_round_shape(table, name);
  refuse_keys(table, name, {"radius", "length"});
  return read_box(table);
}

void read_mass(const files::TomlTable& table, BodySpec& body) {
  double density = 0;
  table.read("mass", body.mass);
  table.read("density", density);
  const bool has_mass = table.find("mass") != nullptr, has_density = table.find("density") != nullptr;
  body_must(has_mass != has_density, table, has_density ? "density" : "mass",
            has_mass ? "and 'mass' say the same; keep one" : "is missing: in kg, or 'density' in kg/m^3");
  if (has_density) body.mass = density * description::volume(*body.shape);
  body_must(body.mass > 0, table, has_density ? "density" : "mass", "must be positive");
}

double read_degrees(const files::TomlTable& table, std::string_view key) {
  double degrees = 0;
  table.read(key, degrees);
  body_must(std::abs(degrees) <= 3600, table, key, "must be between -3600 and 3600");
  return degrees * pi / 180;
}

void read_place(const files::TomlTable& table, BodySpec& body) {
  table.read("position", body.position);
  body_must(norm(body.position) <= farthest_body, table, "position", "is further than 10 km away");
  body.heading = read_degrees(table, "heading_deg");
  body.roll = read_degrees(table, "roll_deg");
  body.pitch = read_degrees(table, "pitch_deg");
}

/// What only bodies have that move.
void read_motion_of(const files::TomlTable& table, BodySpec& body) {
  table.read("velocity", body.velocity);
  table.read("angular_velocity", body.angular_velocity);
  table.read("contact", body.contact);
  with_context(table.where("contact"), [&] { return &find_entry(catalog::contacts(), "contact law", body.contact); });
}

void read_kind(const files::TomlTable& table, BodySpec& body) {
  table.read("model", body.model);
  body_must(body.model.empty() != (table.find("shape") == nullptr), table, "shape",
            body.model.empty() ? "is missing: box, sphere, cylinder or capsule; or 'model'"
                               : "and 'model' say the same; keep one");
  if (body.model.empty()) {
    body.shape = read_shape(table);
    table.read("material", body.material);
    body_must(!body.material.empty(), table, "material", "is empty");
    return;
  }
  refuse_keys(table, "body with a model", {"size", "radius", "length", "mass", "density", "material"});
  body_must(!body.is_static, table, "model", "cannot be static; use a shape");
}

BodySpec read_body(const toml::table& node) {
  const files::TomlTable table(node, body_keys());
  BodySpec body;
  body.where = table.where();
  table.read("name", body.name);
  body_must(!body.name.empty(), table, "name", "of the body is missing");
  table.read("static", body.is_static);
  read_kind(table, body);
  body.color = files::read_color(table, body.color);
  read_place(table, body);
  if (body.is_static) {
    refuse_keys(table, "static body", {"mass", "density", "velocity", "angular_velocity", "contact"});
    return body;
  }
  if (body.shape) read_mass(table, body);
  read_motion_of(table, body);
  return body;
}

bool is_taken(const SceneSpec& spec, const std::string& name) {
  const auto same = [&](const auto& other) { return other.name == name; };
  return name == "ball" || name == "field" || std::any_of(spec.robots.begin(), spec.robots.end(), same) ||
         std::any_of(spec.bodies.begin(), spec.bodies.end(), same);
}

}  // namespace

const std::vector<std::string_view>& body_keys() {
  static const std::vector<std::string_view> keys{
      "name",        "shape",    "size",      "radius",   "length",           "mass",  "density",  "position",
      "heading_deg", "roll_deg", "pitch_deg", "velocity", "angular_velocity", "color", "material", "static",
      "contact",     "model"};
  return keys;
}

void read_bodies(const files::TomlTable& scene, SceneSpec& spec) {
  for (const toml::table* node : scene.tables("bodies")) {
    BodySpec body = read_body(*node);
    if (is_taken(spec, body.name)) {
      files::fail_at(node->get("name")->source(), fmt::format("two entities are called '{}'", body.name));
    }
    spec.bodies.push_back(std::move(body));
  }
}

std::vector<toml::table*> bodies_called(toml::table& scene, const std::string& pattern) {
  std::vector<toml::table*> found;
  toml::array* all = scene["bodies"].as_array();
  for (std::size_t i = 0; all && i < all->size(); ++i) {
    toml::table* body = (*all)[i].as_table();
    const std::string name = body ? (*body)["name"].value_or(std::string{}) : std::string{};
    if (!name.empty() && fnmatch(pattern.c_str(), name.c_str(), 0) == 0) found.push_back(body);
  }
  return found;
}

}  // namespace murosimf::scene_file
