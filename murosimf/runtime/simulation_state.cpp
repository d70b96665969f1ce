// What of a simulation is its state, by name: entities with their columns, algorithms, and the simulation itself.
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/runtime/state_sections.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {
namespace {

/// What a part of the state is called.
struct PartName {
  std::string_view kind, name, entity;
};

std::string to_text(const PartName& part) {
  if (part.entity.empty()) return std::string(part.kind);
  if (part.name.empty()) return fmt::format("{} '{}'", part.kind, part.entity);
  return fmt::format("{} '{}' of '{}'", part.kind, part.name, part.entity);
}

}  // namespace

/// What belongs to no entity.
void Simulation::state(StateArchive& archive) {
  Duration time = now();
  timed_calls_.state(archive);
  archive(time);
  log_.state(archive);
  registry_.state(archive);
  if (!archive.loads()) return;
  if (!log_.events().empty() && log_.events().back().time > time) throw SetupError("its last event is yet to come");
  scheduler_.jump_to(time);
  tasks_.take_over_idle();
}

/// Calls visit(name, optional, part) for every part of the state, always in the same order; entities come before what hangs on
/// them.
template <class Visit>
void Simulation::visit_parts(const Visit& visit) {
  world_.for_all([&](Entity& entity) {
    visit(PartName{"entity", {}, entity.name()}, false, entity);
    for (const auto& [name, column] : entity.columns()) {
      if (column->info().scope == Scope::wiring) continue;
      visit(PartName{"property", name, entity.name()}, false, *column);
    }
  });
  for (const auto& task : tasks_) {
    const bool only_observes = task->algorithm->phase() == Phase::observe;
    visit(PartName{"algorithm", task->name, task->entity->name()}, only_observes, *task->algorithm);
  }
  visit(PartName{"the simulation", {}, {}}, false, *this);
}

std::vector<std::byte> Simulation::save() {
  initialize();
  StateWriter writer;
  std::vector<std::byte> content;  // of one part; its memory is used again
  visit_parts([&](const PartName& name, bool optional, auto& part) {
    content.clear();
    StateArchive archive(content);
    part.state(archive);
    writer.add({to_text(name), optional}, content);
  });
  return writer.finish();
}

void Simulation::load(std::span<const std::byte> bytes) {
  const std::vector<std::byte> before = save();
  try {
    load_sections(bytes);
  } catch (const SetupError&) {
    load_sections(before);
    throw;
  }
}

void Simulation::load_sections(std::span<const std::byte> bytes) {
  StateReader reader(bytes);
  std::vector<SectionName> own;
  visit_parts([&](const PartName& name, bool optional, auto&) { own.push_back({to_text(name), optional}); });
  reader.check_names(own);
  visit_parts([&](const PartName& part_name, bool optional, auto& part) {
    const std::string name = to_text(part_name);
    const auto content = reader.next(name);
    if (!content) {
      if (optional) return;
      throw SetupError(fmt::format("the state has {} elsewhere: this simulation was built otherwise", name));
    }
    with_context("state of " + name, [&] {
      StateArchive archive(*content);
      part.state(archive);
      if (archive.left() > 0) throw SetupError(fmt::format("{} bytes are left over", archive.left()));
    });
  });
  scheduler_.restart_checks();
}

}  // namespace murosimf
