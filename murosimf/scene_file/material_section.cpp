#include "murosimf/scene_file/material_section.h"

#include <fnmatch.h>

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/files/toml_reader.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/section_readers.h"

namespace murosimf::scene_file {
namespace {

double PairSurface::*number_called(std::string_view name) {
  for (const Key<PairSurface>& key : material_section().keys()) {
    const auto* number = std::get_if<double PairSurface::*>(&key.target);
    if (number && key.name == name) return *number;
  }
  throw SetupError(unknown_name("number of a pair of materials", name, pair_keys()));
}

double value_of(const Assignment& change) {
  const toml::table parsed = change.parsed();
  const auto numbers = files::numbers_of(*parsed.get("value"));
  if (!numbers || numbers->size() != 1) throw SetupError("the value must be a number");
  return numbers->front();
}

/// Names of materials that match a pattern.
std::vector<std::string> materials_like(const MaterialTable& materials, const std::string& pattern) {
  std::vector<std::string> found;
  for (const std::string_view name : materials.names()) {
    if (fnmatch(pattern.c_str(), std::string(name).c_str(), 0) == 0) found.emplace_back(name);
  }
  if (found.empty()) throw SetupError(unknown_name("material", pattern, materials.names()));
  return found;
}

void change_pair(MaterialTable& materials, const std::string& a, const std::string& b, double PairSurface::*number,
                 double value) {
  MUROSIMF_ASSERT(number != nullptr);
  PairSurface pair = materials.find({.material = a}, {.material = b});
  pair.*number = value;
  materials.set(a, b, pair);
}

void change_pairs(MaterialTable& materials, const MaterialChange& change) {
  const auto others = materials_like(materials, change.b);
  for (const std::string& a : materials_like(materials, change.a)) {
    for (const std::string& b : others) change_pair(materials, a, b, change.number, change.value);
  }
}

/// Sets the friction between the ground and everything, including surfaces without a material.
void change_ground(const FieldSpec& field, MaterialTable& materials) {
  std::vector<std::string> others{""};
  for (const std::string_view name : materials.names()) others.emplace_back(name);
  for (const std::string& other : others) {
    change_pair(materials, other, field.surface, &PairSurface::friction, *field.friction);
  }
}

/// The order within a pair does not matter: both orders are the same pair.
void check_pair(const GivenPair& pair, const std::vector<GivenPair>& earlier) {
  if (pair.a.empty() || pair.b.empty()) throw SetupError(pair.where + ": 'pair' has an empty name");
  for (const GivenPair& other : earlier) {
    if ((other.a != pair.a || other.b != pair.b) && (other.a != pair.b || other.b != pair.a)) continue;
    throw SetupError(fmt::format("{}: the pair of '{}' and '{}' is set twice, first at {}", pair.where, pair.a, pair.b,
                                 other.where));
  }
}

GivenPair read_pair(const files::TomlTable& table, const toml::node* node) {
  const toml::array* names = node ? node->as_array() : nullptr;
  const bool pair_of_texts = names && names->size() == 2 && (*names)[0].is_string() && (*names)[1].is_string();
  require(pair_of_texts, table, "pair", "must be two material names");
  return {**(*names)[0].as_string(), **(*names)[1].as_string(), table.where("pair")};
}

}  // namespace

const Section<PairSurface>& material_section() {
  static const Section<PairSurface> section(
      "[[materials]]",
      {{"pair", {}, "", "two names of materials", {}, "(needed)"},
       {"friction", &PairSurface::friction, "", "Coulomb coefficient"},
       {"rolling", &PairSurface::rolling, "", "resistance: moment = rolling * radius * normal force"},
       {"torsional", &PairSurface::torsional, "m",
        "resistance of round bodies to spinning: moment = torsional * normal force"},
       {"restitution", &PairSurface::restitution, "", "speed that round bodies keep when they bounce"},
       {"stiffness", &PairSurface::stiffness, "N/m", "of a contact point; 0: by weight and static_deflection"},
       {"static_deflection", &PairSurface::static_deflection, "m",
        "how far a body presses its points in by its weight on Earth"},
       {"friction_anisotropy", &PairSurface::friction_anisotropy, "",
        "g from 0 to below 1: friction (1 - g) along the pile of the ground, (1 + g) against it"},
       {"rolling_anisotropy", &PairSurface::rolling_anisotropy, "", "the same of rolling"},
       {"rebound", &PairSurface::rebound, "", "paper's laws: share of the spring's force while bodies part (s_b)"},
       {"viscous_friction", &PairSurface::viscous_friction, "s/m",
        "paper's laws: force per normal force and velocity (s_mu)"},
       {"spin_friction", &PairSurface::spin_friction, "m s",
        "paper's laws: moment per normal force and turning rate (s_nu)"}});
  return section;
}

std::vector<std::string_view> pair_keys() {
  std::vector<std::string_view> names = material_section().names();
  std::erase(names, "pair");
  return names;
}

void read_materials(const files::TomlTable& scene, SceneSpec& spec) {
  for (const toml::table* node : scene.tables("materials")) {
    const files::TomlTable table(*node, material_section().names());
    const GivenPair given = read_pair(table, node->get("pair"));
    check_pair(given, spec.material_pairs);
    spec.material_pairs.push_back(given);
    PairSurface pair;
    material_section().read(table, pair);
    with_context(table.where(), [&] { spec.materials.set(given.a, given.b, pair); });
  }
}

bool take_material_change(const std::string& override_text, std::vector<MaterialChange>& changes) {
  const std::string where = fmt::format("--set '{}'", override_text);
  const Assignment assignment = split_assignment(override_text, where);
  const auto& path = assignment.path;
  if (path[0] != "materials" || path.size() == 1) return false;
  with_context(where, [&] {
    if (path.size() > 4) throw SetupError("write materials.NUMBER or materials.MATERIAL.MATERIAL.NUMBER");
    MaterialChange change{where, "", "", number_called(path.back()), value_of(assignment)};
    if (path.size() > 2) change.a = path[1];
    if (path.size() > 2) change.b = path.size() == 4 ? path[2] : "*";
    changes.push_back(std::move(change));
  });
  return true;
}

void apply_material_changes(const std::vector<MaterialChange>& changes, SceneSpec& spec) {
  // from the least specific to the most specific change, whatever their order on the command line
  for (const MaterialChange& change : changes) {
    if (change.a.empty()) with_context(change.where, [&] { spec.materials.set_all(change.number, change.value); });
  }
  if (spec.field.friction && spec.materials.knows(spec.field.surface)) change_ground(spec.field, spec.materials);
  for (const MaterialChange& change : changes) {
    if (!change.a.empty()) with_context(change.where, [&] { change_pairs(spec.materials, change); });
  }
}

}  // namespace murosimf::scene_file
