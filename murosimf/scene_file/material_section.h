/// material_section.h - properties of pairs of materials, and their overrides on the command line.
///
///     --set materials.friction=0.3                 of all pairs
///     --set materials.rubber.friction=0.3          of rubber with everything
///     --set materials.rubber.carpet.friction=0.3   of one pair; * and ? match
///
/// The more specific one wins: a pair, then a material, then the friction of the field, then all.
/// For .cpp files only: it includes toml++.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/scene_file/assignment.h"

namespace murosimf::scene_file {

/// One property of pairs of materials; empty names: of all.
struct MaterialChange {
  std::string where, a, b;
  double PairSurface::*number = nullptr;
  double value = 0;
};

/// Properties of a pair, by their names in files.
[[nodiscard]] std::vector<std::string_view> pair_keys();

/// Evaluates an override (PATH=VALUE) of materials; returns false if it is none. Throws SetupError for invalid
/// paths.
[[nodiscard]] bool take_material_change(const std::string& override_text, std::vector<MaterialChange>& changes);

/// Applies the changes to the scene's table, and the friction of its field. Throws SetupError for unknown materials.
void apply_material_changes(const std::vector<MaterialChange>& changes, SceneSpec& spec);

}  // namespace murosimf::scene_file
