#include "murosimf/io/log_plot.h"

#include <fnmatch.h>

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/io/log_catalog.h"
#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

constexpr std::size_t most_curves = 32, most_panels = 16;

using Parts = std::vector<std::string>;

/// Columns that share a panel.
struct Group {
  std::string key;
  std::vector<const CsvColumn*> columns;
};

bool means(const std::string& pattern, const std::string& name) {
  if (pattern == name) return true;
  const Parts parts = path_parts(pattern), path = path_parts(name);
  const auto matches = [](const std::string& p, const std::string& n) { return fnmatch(p.c_str(), n.c_str(), 0) == 0; };
  return parts.size() <= path.size() && std::equal(parts.begin(), parts.end(), path.begin(), matches);
}

std::vector<const CsvColumn*> chosen(const CsvTable& table, const Parts& patterns) {
  std::vector<bool> wanted(table.columns.size(), patterns.empty());
  for (const std::string& pattern : patterns) {
    bool found = false;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (!means(pattern, table.columns[i].name)) continue;
      found = wanted[i] = true;
    }
    if (found) continue;
    std::vector<std::string_view> names;
    for (const CsvColumn& column : table.columns) names.emplace_back(column.name);
    throw SetupError(unknown_name("column", pattern, names));
  }
  std::vector<const CsvColumn*> columns;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i]) columns.push_back(&table.columns[i]);
  }
  return columns;
}

std::string key_of(const CsvColumn& column) {
  const Parts parts = path_parts(column.name);
  return parts.size() < 3 ? column.unit : fmt::format("{}.{} {}", parts[0], parts[1], column.unit);
}

std::vector<Group> groups_of(const std::vector<const CsvColumn*>& columns) {
  std::vector<Group> groups;
  for (const CsvColumn* column : columns) {
    const std::string key = key_of(*column);
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.key == key; });
    if (group == groups.end()) group = groups.insert(groups.end(), Group{key, {}});
    group->columns.push_back(column);
  }
  return groups;
}

/// What all names of a panel begin with, in whole parts; all but the last part if there is only one.
Parts common_parts(const Group& group) {
  Parts common = path_parts(group.columns[0]->name);
  common.pop_back();
  for (const CsvColumn* column : group.columns) {
    Parts parts = path_parts(column->name);
    parts.pop_back();
    const auto [end, unused] = std::mismatch(common.begin(), common.end(), parts.begin(), parts.end());
    common.erase(end, common.end());
  }
  return common;
}

Panel panel_of(const Group& group) {
  const Parts common = common_parts(group);
  const bool alone = group.columns.size() == 1;
  const std::string& unit = group.columns[0]->unit;
  std::string label = alone ? group.columns[0]->name : fmt::format("{}", fmt::join(common, "."));
  if (!unit.empty()) label += label.empty() ? unit : fmt::format(" [{}]", unit);
  Panel panel{.y_label = label, .curves = {}};
  for (const CsvColumn* column : group.columns) {
    const Parts parts = path_parts(column->name);
    const Parts rest(parts.begin() + static_cast<std::ptrdiff_t>(common.size()), parts.end());
    panel.curves.push_back({alone ? "" : fmt::format("{}", fmt::join(rest, ".")), column->times, column->values});
  }
  return panel;
}

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

Plot plot_of(const CsvTable& table, const std::string& title, const Parts& patterns) {
  const std::vector<Group> groups = groups_of(chosen(table, patterns));
  check_sizes(groups);
  Plot plot{.title = title, .x_label = table.time, .panels = {}, .panel_height = groups.size() > 6 ? 220 : 320};
  for (const Group& group : groups) plot.panels.push_back(panel_of(group));
  return plot;
}

}  // namespace murosimf::io
