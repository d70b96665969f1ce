#include "murosimf/runtime/step_checks.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

namespace murosimf {
namespace {

constexpr std::int64_t first_ticks = 2, every_tick = 128;

[[noreturn]] void fail(const Entity& entity, const ColumnBase& column, std::string_view what) {
  const std::string text = fmt::format("murosimf: '{}' of '{}' {}\n", column.info().name, entity.name(), what);
  std::fputs(text.c_str(), stderr);
  std::abort();
}

std::uint64_t hash_of(const ColumnBase& column) {
  Hasher hasher;
  column.append_to(hasher);
  return hasher.value();
}

bool is_written(const std::vector<const AccessSet*>& access, const Entity* entity, const ColumnBase* column) {
  return std::ranges::any_of(access, [&](const AccessSet* set) { return set->writes(column) || set->claims(entity); });
}

}  // namespace

void StepChecks::restart(const World& world, const std::vector<const AccessSet*>& access) {
  numbers_.clear();
  world.for_all([&](const Entity& entity) {
    for (const auto& [name, column] : entity.columns()) {
      const bool written = is_written(access, &entity, column.get());
      if (!written || !is_state(column->info().scope) || column->numbers() == 0) continue;
      numbers_.push_back({&entity, column.get(), column->not_finite()});
    }
  });
}

void StepChecks::before_wave(const World& world, std::int64_t tick) {
  before_.clear();
  if (tick >= first_ticks && tick % every_tick != 0) return;
  world.for_all([&](const Entity& entity) {
    for (const auto& [name, column] : entity.columns()) before_.push_back({&entity, column.get(), hash_of(*column)});
  });
}

void StepChecks::after_wave(const std::vector<const AccessSet*>& access) const {
  for (const auto& [entity, column, hash] : before_) {
    if (hash_of(*column) != hash && !is_written(access, entity, column)) {
      fail(*entity, *column, "was changed by an algorithm that has not declared it");
    }
  }
}

void StepChecks::after_tick() {
  for (auto& [entity, column, not_finite] : numbers_) {
    const std::size_t now = column->not_finite();
    if (now > not_finite && !entity->frozen()) fail(*entity, *column, "is not finite after a step");
    not_finite = now;
  }
}

}  // namespace murosimf
