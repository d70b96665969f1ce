/// physics_options.h - options of the library's levels and contact laws that a scene may set: [robots.level_options],
/// [robots.contact_options], [body_contact_options].
///
/// Options that several levels share and that have a key of their own (integrator, fixed_base) are not among these.
#pragma once

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/collision/contact_laws/body_island_law.h"
#include "murosimf/collision/contact_laws/paper_law.h"
#include "murosimf/model/option.h"

namespace murosimf::catalog {

/// Of levels with prescribed joint motion; of those whose links have masses; of both.
[[nodiscard]] const OptionTable<LevelOptions>& reference_options();
[[nodiscard]] const OptionTable<LevelOptions>& tree_options();
[[nodiscard]] const OptionTable<LevelOptions>& reference_and_tree_options();

[[nodiscard]] const OptionTable<collision::PaperLawOptions>& paper_law_options();
[[nodiscard]] const OptionTable<collision::BodyIslandOptions>& body_island_options();

}  // namespace murosimf::catalog
