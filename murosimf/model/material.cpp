#include "murosimf/model/material.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf {
namespace {

std::pair<std::string, std::string> key(const std::string& a, const std::string& b) {
  // pairs have no order
  return a < b ? std::pair{a, b} : std::pair{b, a};
}

[[noreturn]] void refuse(const std::string& a, const std::string& b, std::string_view reason) {
  throw SetupError(fmt::format("materials '{}' and '{}': {}", a, b, reason));
}

}  // namespace

MaterialTable MaterialTable::standard() {
  // Origin. Friction of 0.8 for rubber feet on carpet and rolling resistance of 0.03 there are figures that the project's
  // prototype walked and rolled with. Artificial grass: FIFA Quality Programme for Football Turf, Test Manual I. A ball dropped from 2 m
  // rebounds by 0.6 to 0.85 m, e = sqrt(h / 2 m) = 0.55 to 0.65. One that comes down a ramp of 1 m rolls for 4 to 10 m: its energy
  // m g h is spent on c m g d, c = 0.1 to 0.25, of which the shortest pile, as on fields of robots, has the least. A test foot of 70 mm
  // presses 2.7 kN into 4 to 10 mm, 100 N / cm^3: 0.05 mm under a sole of 100 cm^2 that carries 5 kg, 0.2 mm under one that carries 20 kg.
  // Spinning: Coulomb friction over a round patch of radius a resists by 2/3 mu a; a = 6 mm on carpet, 15 mm in grass. Wood is
  // the floor of a sports hall: EN 14904 allows 5 mm under 1500 N, 0.16 mm under a robot of 5 kg. All else is an
  // assumption, of the right order of magnitude: grass is slipperier than carpet, plastic is slipperier than rubber, bodies of
  // robots hardly resist rolling. Grass leans, so friction differs by +-15 % along and against it; carpet of needle felt has no pile.
  // docs/materials.md has what was measured elsewhere, number by number.
  constexpr double turf = 0.2e-3;  // [m] deflection
  MaterialTable table;
  table.set("rubber", "carpet", {.friction = 0.8, .rolling = 0.03, .restitution = 0.4});
  table.set("plastic", "carpet", {.friction = 0.5, .rolling = 0.03, .restitution = 0.4});
  table.set("ball", "carpet", {.friction = 0.5, .rolling = 0.03, .torsional = 0.002, .restitution = 0.6});
  const auto set_on_grass = [&](const char* body, PairSurface pair) {
    pair.static_deflection = turf;
    pair.friction_anisotropy = 0.15;
    table.set(body, "grass", pair);
  };
  set_on_grass("rubber", {.friction = 0.7, .rolling = 0.1, .restitution = 0.3});
  set_on_grass("plastic", {.friction = 0.45, .rolling = 0.1, .restitution = 0.3});
  set_on_grass("ball", {.friction = 0.5, .rolling = 0.1, .torsional = 0.005, .restitution = 0.6});
  table.set("rubber", "wood", {.friction = 0.8, .rolling = 0.01, .restitution = 0.5});
  table.set("plastic", "wood", {.friction = 0.35, .rolling = 0.01, .restitution = 0.5});
  table.set("ball", "wood", {.friction = 0.5, .rolling = 0.01, .torsional = 0.001, .restitution = 0.75});
  // Nets of goals hang loosely: what flies into them falls down. They give way to a ball that slides along them, and friction does not
  // make it spin: one that spins would come out again along the side net.
  table.set("ball", "net", {.friction = 0.02, .torsional = 0.005, .restitution = 0, .static_deflection = turf});
  table.set("rubber", "net", {.friction = 0.5, .restitution = 0, .static_deflection = turf});
  table.set("plastic", "net", {.friction = 0.3, .restitution = 0, .static_deflection = turf});
  table.set("rubber", "rubber", {.friction = 1.0, .rolling = 0.0, .restitution = 0.5});
  table.set("rubber", "plastic", {.friction = 0.6, .rolling = 0.0, .restitution = 0.5});
  table.set("plastic", "plastic", {.friction = 0.3, .rolling = 0.0, .restitution = 0.5});
  table.set("ball", "rubber", {.friction = 0.5, .rolling = 0.0, .restitution = 0.5});
  table.set("ball", "plastic", {.friction = 0.3, .rolling = 0.0, .restitution = 0.5});
  table.set("ball", "ball", {.friction = 0.3, .rolling = 0.0, .restitution = 0.6});
  return table;
}

void MaterialTable::set(const std::string& a, const std::string& b, const PairSurface& pair) {
  const bool finite = std::isfinite(pair.friction + pair.rolling + pair.torsional + pair.stiffness);
  if (!finite || pair.friction < 0 || pair.rolling < 0 || pair.torsional < 0 || pair.stiffness < 0) {
    refuse(a, b, "friction, rolling, torsional and stiffness must be finite and at least 0");
  }
  if (!(pair.static_deflection >= 1e-6 && pair.static_deflection <= 0.1))
    refuse(a, b, "static_deflection must be from 1e-6 to 0.1 m");
  if (!(pair.restitution >= 0 && pair.restitution <= 1)) refuse(a, b, "restitution must be from 0 to 1");
  if (!(pair.rebound >= 0 && pair.rebound <= 1)) refuse(a, b, "rebound must be from 0 to 1");
  const bool viscous = std::isfinite(pair.viscous_friction + pair.spin_friction);
  if (!viscous || pair.viscous_friction < 0 || pair.spin_friction < 0)
    refuse(a, b, "viscous_friction and spin_friction must be finite and at least 0");
  for (const auto& [g, name] : {std::pair{pair.friction_anisotropy, "friction_anisotropy"},
                                std::pair{pair.rolling_anisotropy, "rolling_anisotropy"}}) {
    if (!(g >= 0 && g < 1)) refuse(a, b, fmt::format("{} must be at least 0 and below 1", name));
  }
  pairs_[key(a, b)] = pair;
}

void MaterialTable::set_all(double PairSurface::*number, double value) {
  // a copy: set() replaces entries while this loop runs
  const auto pairs = pairs_;
  MUROSIMF_ASSERT(number);
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
