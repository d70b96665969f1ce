#include "murosimf/logging/log_plot.h"

#include <fnmatch.h>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/logging/log_catalog.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::logging {
namespace {

constexpr std::size_t most_curves = 32, most_panels = 16;

using Parts = std::vector<std::string>;

/// Columns of one panel.
struct Group {
  std::string key;
  std::vector<const files::CsvColumn*> columns;
};

std::vector<const files::CsvColumn*> chosen(const files::CsvTable& table, const Parts& patterns) {
  std::vector<bool> wanted(table.columns.size(), patterns.empty());
  for (const std::string& pattern : patterns) {
    bool found = false;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (!matches_name(pattern, table.columns[i].name)) continue;
      found = wanted[i] = true;
    }
    if (found) continue;
    std::vector<std::string_view> names;
    for (const files::CsvColumn& column : table.columns) names.emplace_back(column.name);
    throw SetupError(unknown_name("column", pattern, names));
  }
  std::vector<const files::CsvColumn*> columns;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i]) columns.push_back(&table.columns[i]);
  }
  return columns;
}

std::string key_of(const files::CsvColumn& column) {
  const Parts parts = path_parts(column.name);
  if (parts.size() < 3) return column.unit;
  if (parts.size() == 3) return fmt::format("{}.*.{} {}", parts[0], parts[2], column.unit);
  return fmt::format("{}.{} {}", parts[0], parts[1], column.unit);
}

/// Columns of the same quantity share a panel.
std::vector<Group> groups_of(const std::vector<const files::CsvColumn*>& columns) {
  std::vector<Group> groups;
  for (const files::CsvColumn* column : columns) {
    const std::string key = key_of(*column);
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.key == key; });
    if (group == groups.end()) group = groups.insert(groups.end(), Group{key, {}});
    group->columns.push_back(column);
  }
  return groups;
}

/// Number of leading parts common to all names of a panel, but never all parts of one.
std::size_t common_parts(const std::vector<Parts>& names) {
  MUROSIMF_ASSERT(!names.empty() && !names[0].empty());
  std::size_t common = names[0].size() - 1;
  for (const Parts& parts : names) {
    const auto most = static_cast<std::ptrdiff_t>(std::min(common, parts.size() - 1));
    const auto end = std::mismatch(parts.begin(), parts.begin() + most, names[0].begin()).first;
    common = static_cast<std::size_t>(end - parts.begin());
  }
  return common;
}

/// Whether they are the same number of several objects: "blue1.left_knee.joint_position".
bool of_many_objects(const std::vector<Parts>& names) {
  return std::ranges::all_of(names, [&](const Parts& parts) {
    return parts.size() == 3 && parts[0] == names[0][0] && parts[2] == names[0][2];
  });
}

/// Label of the axis, and the rest of the name for each curve.
struct PanelNames {
  std::string label;
  std::vector<std::string> curves;
};

PanelNames names_of(const Group& group) {
  std::vector<Parts> names;
  for (const files::CsvColumn* column : group.columns) names.push_back(path_parts(column->name));
  if (names.size() == 1) return {group.columns[0]->name, {""}};
  PanelNames result;
  if (of_many_objects(names)) {
    result.label = fmt::format("{}.*.{}", names[0][0], names[0][2]);
    for (const Parts& parts : names) result.curves.push_back(parts[1]);
    return result;
  }
  const auto common = static_cast<std::ptrdiff_t>(common_parts(names));
  result.label = fmt::format("{}", fmt::join(names[0].begin(), names[0].begin() + common, "."));
  for (const Parts& parts : names) {
    result.curves.push_back(fmt::format("{}", fmt::join(parts.begin() + common, parts.end(), ".")));
  }
  return result;
}

Panel panel_of(const Group& group) {
  const PanelNames names = names_of(group);
  const std::string& unit = group.columns[0]->unit;
  Panel panel{.y_label = names.label, .curves = {}};
  if (!unit.empty()) panel.y_label += names.label.empty() ? unit : fmt::format(" [{}]", unit);
  MUROSIMF_ASSERT(names.curves.size() == group.columns.size());
  for (std::size_t i = 0; i < group.columns.size(); ++i) {
    panel.curves.push_back({names.curves[i], group.columns[i]->times, group.columns[i]->values});
  }
  return panel;
}

/// A plot of hundreds of curves shows nothing.
void check_sizes(const std::vector<Group>& groups) {
  constexpr const char* advice = "name those to draw, like 'murosimf plot FILE";
  if (groups.size() > most_panels) {
    throw SetupError(fmt::format("{} panels would be too many (at most {}): {} {}'", groups.size(), most_panels, advice,
                                 groups[0].columns[0]->name));
  }
  for (const Group& group : groups) {
    if (group.columns.size() <= most_curves) continue;
    throw SetupError(fmt::format("{} curves in the panel of '{}' would be too many (at most {}): {} {}'",
                                 group.columns.size(), group.columns[0]->name, most_curves, advice,
                                 group.columns[0]->name));
  }
}

}  // namespace

bool matches_name(const std::string& pattern, const std::string& name) {
  if (pattern == name) return true;
  const Parts parts = path_parts(pattern), path = path_parts(name);
  const auto matches = [](const std::string& p, const std::string& n) { return fnmatch(p.c_str(), n.c_str(), 0) == 0; };
  return parts.size() <= path.size() && std::equal(parts.begin(), parts.end(), path.begin(), matches);
}

Plot plot_of(const files::CsvTable& table, const std::string& title, const Parts& patterns) {
  const std::vector<Group> groups = groups_of(chosen(table, patterns));
  check_sizes(groups);
  Plot plot{.title = title, .x_label = table.time, .panels = {}, .panel_height = groups.size() > 6 ? 220 : 320};
  for (const Group& group : groups) plot.panels.push_back(panel_of(group));
  return plot;
}

}  // namespace murosimf::logging
