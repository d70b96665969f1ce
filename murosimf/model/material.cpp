#include "murosimf/model/material.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf {
namespace {

std::pair<std::string, std::string> key(const std::string& a, const std::string& b) {
  return a < b ? std::pair{a, b} : std::pair{b, a};
}

}  // namespace

MaterialTable MaterialTable::standard() {
  // Orders of magnitude, not measurements. Friction of 0.8 for feet and rolling resistance of 0.02 to 0.05 on carpet
  // are the figures that the project's prototypes walked and rolled with; the others lie between.
  MaterialTable table;
  table.set("rubber", "carpet", {.friction = 0.8, .rolling = 0.03, .restitution = 0.4});
  table.set("rubber", "grass", {.friction = 0.7, .rolling = 0.05, .restitution = 0.3});
  table.set("plastic", "carpet", {.friction = 0.5, .rolling = 0.03, .restitution = 0.4});
  table.set("plastic", "grass", {.friction = 0.45, .rolling = 0.05, .restitution = 0.3});
  table.set("ball", "carpet", {.friction = 0.5, .rolling = 0.03, .restitution = 0.6});
  table.set("ball", "grass", {.friction = 0.5, .rolling = 0.05, .restitution = 0.5});
  table.set("ball", "rubber", {.friction = 0.5, .rolling = 0.0, .restitution = 0.5});
  table.set("ball", "plastic", {.friction = 0.3, .rolling = 0.0, .restitution = 0.5});
  return table;
}

void MaterialTable::set(const std::string& a, const std::string& b, const PairSurface& pair) {
  const bool possible = pair.friction >= 0 && pair.rolling >= 0 && pair.restitution >= 0 && pair.restitution <= 1 &&
                        pair.stiffness >= 0 && std::isfinite(pair.friction + pair.rolling + pair.stiffness);
  if (!possible) {
    throw SetupError(
        fmt::format("materials '{}' and '{}': friction, rolling and stiffness must be at least 0, "
                    "restitution 0 to 1",
                    a, b));
  }
  pairs_[key(a, b)] = pair;
}

bool MaterialTable::knows(const std::string& material) const {
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const auto& entry) {
    return entry.first.first == material || entry.first.second == material;
  });
}

std::vector<std::string_view> MaterialTable::names() const {
  std::vector<std::string_view> names;
  for (const auto& [pair, surface] : pairs_) {
    names.push_back(pair.first);
    names.push_back(pair.second);
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

PairSurface MaterialTable::find(const Surface& a, const Surface& b) const {
  const auto found = pairs_.find(key(a.material, b.material));
  if (found != pairs_.end()) return found->second;
  PairSurface pair;
  pair.friction = std::max(a.friction, b.friction);
  return pair;
}

}  // namespace murosimf
