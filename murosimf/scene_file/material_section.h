/// material_section.h - friction and other numbers of pairs of materials on the command line.
///
///     --set materials.friction=0.3                 of all pairs
///     --set materials.rubber.friction=0.3          of rubber with everything
///     --set materials.rubber.carpet.friction=0.3   of one pair; * and ? match
///
/// What is more special wins: a pair, then a material, then the friction of the field, then all.
/// Only for .cpp files: it brings toml++ in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/scene_file/assignment.h"

namespace murosimf::scene_file {

/// One number of pairs of materials; empty names: of all.
struct MaterialChange {
  std::string where, a, b;
  double PairSurface::*number = nullptr;
  double value = 0;
};

/// Numbers of a pair, by their names in files.
[[nodiscard]] std::vector<std::string_view> pair_keys();

/// Takes an override (PATH=VALUE) that is about materials; false if it is none. Throws SetupError for paths that mean
/// nothing.
[[nodiscard]] bool take_material_change(const std::string& override_text, std::vector<MaterialChange>& changes);

/// Changes the scene's table, also by its field's friction. Throws SetupError for unknown materials.
void apply_material_changes(const std::vector<MaterialChange>& changes, SceneSpec& spec);

}  // namespace murosimf::scene_file
