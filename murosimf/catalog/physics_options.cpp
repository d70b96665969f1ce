#include "murosimf/catalog/physics_options.h"

namespace murosimf::catalog {
namespace {

using LevelRow = OptionTable<LevelOptions>::Row;

std::vector<LevelRow> reference_rows() {
  return {
      {"filter_frequency", [](auto& of) -> decltype(auto) { return (of.reference.filter_frequency); }, "rad/s",
       "with which joints follow their targets, if joint_reference is filter", 1, 1000},
      {"control_period", [](auto& of) -> decltype(auto) { return (of.reference.control_period); }, "s",
       "in which joints reach their targets, if joint_reference is linear", 1e-4, 1},
  };
}

std::vector<LevelRow> tree_rows() {
  return {{"momentum_correction", [](auto& of) -> decltype(auto) { return (of.tree.momentum_correction); }, "",
           "in flight, momentum is what gravity leaves of it, to the last digits"}};
}

}  // namespace

const OptionTable<LevelOptions>& reference_options() {
  static const OptionTable<LevelOptions> table(reference_rows());
  return table;
}

const OptionTable<LevelOptions>& tree_options() {
  static const OptionTable<LevelOptions> table(tree_rows());
  return table;
}

/// One table for levels that have both groups, so that a key has one meaning and one unit everywhere.
const OptionTable<LevelOptions>& reference_and_tree_options() {
  static const OptionTable<LevelOptions> table = [] {
    std::vector<LevelRow> rows = reference_rows();
    for (LevelRow& row : tree_rows()) rows.push_back(std::move(row));
    return OptionTable<LevelOptions>(std::move(rows));
  }();
  return table;
}

const OptionTable<collision::PaperLawOptions>& paper_law_options() {
  using Options = collision::PaperLawOptions;
  static const OptionTable<Options> table{
      {"rebound", &Options::rebound, "1",
       "share of the spring's force while bodies part (s_b); not given: by materials", 0, 1},
      {"friction", &Options::friction, "s/m",
       "force per normal force and velocity (s_mu); not given: viscous_friction of materials", 0, 100},
      {"spin_friction", &Options::spin_friction, "m s",
       "moment per normal force and turning rate (s_nu); not given: by materials", 0, 1},
      {"bounded", &Options::bounded, "",
       "friction stops at most what it rubs; false: the paper's letter, docs/scenes.md has the steps"},
  };
  return table;
}

const OptionTable<collision::BodyIslandOptions>& body_island_options() {
  using Options = collision::BodyIslandOptions;
  static const OptionTable<Options> table{
      {"sweeps", &Options::sweeps, "1", "over all contacts of an island in a step, at most", 1, 1000},
  };
  return table;
}

}  // namespace murosimf::catalog
