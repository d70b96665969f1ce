#include "murosimf/model/material.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf {
namespace {

std::pair<std::string, std::string> key(const std::string& a, const std::string& b) {
  return a < b ? std::pair{a, b} : std::pair{b, a};
}

[[noreturn]] void refuse(const std::string& a, const std::string& b, std::string_view reason) {
  throw SetupError(fmt::format("materials '{}' and '{}': {}", a, b, reason));
}

}  // namespace

MaterialTable MaterialTable::standard() {
  // Origin. Friction of 0.8 for rubber feet on carpet and rolling resistance of 0.02 to 0.05 are figures that the
  // project's prototype walked and rolled with. Everything else is an assumption, of the right order of magnitude:
  // grass is slipperier and softer than carpet, plastic is slipperier than rubber, bodies of robots hardly resist
  // rolling. Grass leans, so friction differs by +-15 % along and against it; carpet of needle felt has no pile.
  MaterialTable table;
  table.set("rubber", "carpet", {.friction = 0.8, .rolling = 0.03, .restitution = 0.4});
  table.set("plastic", "carpet", {.friction = 0.5, .rolling = 0.03, .restitution = 0.4});
  table.set("ball", "carpet", {.friction = 0.5, .rolling = 0.03, .restitution = 0.6});
  table.set("rubber", "grass", {.friction = 0.7, .rolling = 0.05, .restitution = 0.3, .friction_anisotropy = 0.15});
  table.set("plastic", "grass", {.friction = 0.45, .rolling = 0.05, .restitution = 0.3, .friction_anisotropy = 0.15});
  table.set("ball", "grass", {.friction = 0.5, .rolling = 0.05, .restitution = 0.5, .friction_anisotropy = 0.15});
  table.set("rubber", "rubber", {.friction = 1.0, .rolling = 0.0, .restitution = 0.5});
  table.set("rubber", "plastic", {.friction = 0.6, .rolling = 0.0, .restitution = 0.5});
  table.set("plastic", "plastic", {.friction = 0.3, .rolling = 0.0, .restitution = 0.5});
  table.set("ball", "rubber", {.friction = 0.5, .rolling = 0.0, .restitution = 0.5});
  table.set("ball", "plastic", {.friction = 0.3, .rolling = 0.0, .restitution = 0.5});
  table.set("ball", "ball", {.friction = 0.3, .rolling = 0.0, .restitution = 0.6});
  return table;
}

void MaterialTable::set(const std::string& a, const std::string& b, const PairSurface& pair) {
  const bool finite = std::isfinite(pair.friction + pair.rolling + pair.stiffness);
  if (!finite || pair.friction < 0 || pair.rolling < 0 || pair.stiffness < 0) {
    refuse(a, b, "friction, rolling and stiffness must be finite and at least 0");
  }
  if (!(pair.restitution >= 0 && pair.restitution <= 1)) refuse(a, b, "restitution must be from 0 to 1");
  if (!(pair.rebound >= 0 && pair.rebound <= 1)) refuse(a, b, "rebound must be from 0 to 1");
  const bool viscous = std::isfinite(pair.viscous_friction + pair.spin_friction);
  if (!viscous || pair.viscous_friction < 0 || pair.spin_friction < 0)
    refuse(a, b, "viscous_friction and spin_friction must be finite and at least 0");
  if (!(pair.friction_anisotropy >= 0 && pair.friction_anisotropy < 1))
    refuse(a, b, "friction_anisotropy must be at least 0 and below 1");
  pairs_[key(a, b)] = pair;
}

void MaterialTable::set_all(double PairSurface::*number, double value) {
  const auto pairs = pairs_;
  for (auto [names, pair] : pairs) {
    pair.*number = value;
    set(names.first, names.second, pair);
  }
  others_.*number = value;
  if (number == &PairSurface::friction) other_friction_ = value;
}

bool MaterialTable::knows(const std::string& material) const {
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const auto& entry) {
    return entry.first.first == material || entry.first.second == material;
  });
}

std::vector<std::string_view> MaterialTable::names() const {
  std::vector<std::string_view> names;
  for (const auto& [pair, surface] : pairs_) {
    for (const std::string& name : {std::cref(pair.first), std::cref(pair.second)}) {
      if (!name.empty()) names.emplace_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

PairSurface MaterialTable::find(const Surface& a, const Surface& b) const {
  const auto found = pairs_.find(key(a.material, b.material));
  if (found != pairs_.end()) return found->second;
  PairSurface pair = others_;
  pair.friction = other_friction_.value_or(std::max(a.friction, b.friction));
  return pair;
}

}  // namespace murosimf
