#include "murosimf/world/access.h"

#include <algorithm>
#include <unordered_set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"

namespace murosimf {

namespace {

std::uint8_t bit_of(AccessMode mode) { return static_cast<std::uint8_t>(1U << static_cast<unsigned>(mode)); }

}  // namespace

void AccessSet::add(const Access& access) {
  MUROSIMF_ASSERT(access.entity && access.column);
  std::uint8_t& modes = modes_[access.column];
  const std::uint8_t bit = bit_of(access.mode);
  // repeated declarations of the same access count once
  if ((modes & bit) == 0) all_.push_back(access);
  modes |= bit;
}

void AccessSet::claim(const Entity& entity) {
  if (!claims(&entity)) claimed_.push_back(&entity);
}

void AccessSet::forget(const Entity& entity) {
  for (const Access& access : all_) {
    if (access.entity == &entity) modes_.erase(access.column);
  }
  std::erase_if(all_, [&](const Access& access) { return access.entity == &entity; });
  std::erase(claimed_, &entity);
}

bool AccessSet::claims(const Entity* entity) const {
  return std::find(claimed_.begin(), claimed_.end(), entity) != claimed_.end();
}

bool AccessSet::writes(const ColumnBase* column) const {
  const auto found = modes_.find(column);
  return found != modes_.end() && (found->second & bit_of(AccessMode::write)) != 0;
}

bool AccessSet::touches(const ColumnBase* column) const { return modes_.contains(column); }

bool conflict(const AccessSet& a, const AccessSet& b) {
  const auto writes_what_touches = [](const AccessSet& writer, const AccessSet& other) {
    return std::any_of(writer.all().begin(), writer.all().end(), [&](const Access& access) {
      return access.mode == AccessMode::write && other.touches(access.column);
    });
  };
  const auto claims_what_touches = [](const AccessSet& claimant, const AccessSet& other) {
    return std::any_of(other.all().begin(), other.all().end(),
                       [&](const Access& access) { return claimant.claims(access.entity); });
  };
  // reading the same column is no conflict: readers may run at the same time
  return writes_what_touches(a, b) || writes_what_touches(b, a) || claims_what_touches(a, b) ||
         claims_what_touches(b, a);
}

namespace {

/// Columns that some algorithm writes, or that have a start value.
std::unordered_set<const ColumnBase*> supplied_columns(const std::vector<NamedAccess>& algorithms) {
  std::unordered_set<const ColumnBase*> supplied;
  for (const NamedAccess& algorithm : algorithms) {
    for (const Access& access : algorithm.access->all()) {
      // inputs have start values, so they need no writer
      if (access.mode != AccessMode::read) supplied.insert(access.column);
    }
  }
  return supplied;
}

/// For the message: the algorithms that write to that entity at all.
std::string writers_of(const std::vector<NamedAccess>& algorithms, const Entity* entity) {
  std::vector<std::string> names;
  for (const NamedAccess& algorithm : algorithms) {
    MUROSIMF_ASSERT(algorithm.access);
    const auto& all = algorithm.access->all();
    const bool writes = std::any_of(all.begin(), all.end(), [&](const Access& access) {
      return access.entity == entity && access.mode == AccessMode::write;
    });
    if (writes) names.push_back("'" + algorithm.algorithm + "'");
  }
  return names.empty()
             ? "no algorithm writes anything of it"
             : fmt::format("{} write{} other properties of it", fmt::join(names, ", "), names.size() == 1 ? "s" : "");
}

}  // namespace

void check_every_read_is_written(const std::vector<NamedAccess>& algorithms) {
  const auto supplied = supplied_columns(algorithms);
  for (const NamedAccess& reader : algorithms) {
    for (const Access& access : reader.access->all()) {
      if (access.mode != AccessMode::read || supplied.contains(access.column)) continue;
      throw SetupError(
          fmt::format("'{}' reads '{}' of '{}', but no algorithm writes it: {}; attach an algorithm that does",
                      reader.algorithm, access.column->info().name, access.entity->name(),
                      writers_of(algorithms, access.entity)));
    }
  }
}

}  // namespace murosimf
