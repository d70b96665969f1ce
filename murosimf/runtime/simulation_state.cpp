// Bytes of a state: a line that says so, the hash of all that follows, then sections, each with its name, whether it may be
// missing, and the number of its bytes. Sections have names so that one can say what does not fit.
#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/runtime/bytes_hash.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf {
namespace {

constexpr std::string_view first_line = "MuRoSimF state 3\n";  // the number is that of the format
constexpr std::size_t begin_of_sections = first_line.size() + sizeof(std::uint64_t);

struct Section {
  std::string name;
  bool optional = false;  // of somebody who only looks on: a run may go on with others
  std::span<const std::byte> bytes;
};

/// Throws SetupError if that is no state.
std::vector<Section> sections_of(std::span<const std::byte> bytes) {
  const auto line = std::as_bytes(std::span(first_line));
  if (bytes.size() < begin_of_sections || !std::equal(line.begin(), line.end(), bytes.begin())) {
    throw SetupError("these bytes are no state that this version of the library has saved");
  }
  std::uint64_t hash = 0;
  std::memcpy(&hash, bytes.data() + line.size(), sizeof(hash));
  std::span<const std::byte> rest = bytes.subspan(begin_of_sections);
  if (hash_of(rest) != hash) throw SetupError("these bytes of a state are damaged, or not all there");
  std::vector<Section> sections;
  while (!rest.empty()) {
    StateArchive archive(rest);
    std::uint64_t size = 0;
    sections.emplace_back();
    archive(sections.back().name, sections.back().optional, size);
    rest = rest.last(archive.left());
    if (size > rest.size()) throw SetupError("the state ends too early");
    sections.back().bytes = rest.first(size);
    rest = rest.subspan(size);
  }
  return sections;
}

/// What a part of the state is called.
struct PartName {
  std::string_view kind, name, entity;
};

std::string to_text(const PartName& part) {
  if (part.entity.empty()) return std::string(part.kind);
  if (part.name.empty()) return fmt::format("{} '{}'", part.kind, part.entity);
  return fmt::format("{} '{}' of '{}'", part.kind, part.name, part.entity);
}

bool has(const std::vector<Section>& sections, const std::string& name) {
  return std::ranges::find(sections, name, &Section::name) != sections.end();
}

/// Throws SetupError if the simulation or the state has what the other one needs and has not.
void check_names(const std::vector<Section>& saved, const std::vector<Section>& own) {
  for (const Section& section : saved) {
    if (section.optional || has(own, section.name)) continue;
    throw SetupError(fmt::format("the state has {}, this simulation has not: it was built otherwise", section.name));
  }
  for (const Section& section : own) {
    if (section.optional || has(saved, section.name)) continue;
    throw SetupError(fmt::format("this simulation has {}, the state has not: it was built otherwise", section.name));
  }
}

}  // namespace

void state(StateArchive& archive, Event& event) { archive(event.time, event.text); }

/// What belongs to no entity.
void Simulation::state(StateArchive& archive) {
  std::size_t scheduled = schedule_.size();
  archive(scheduled);
  if (scheduled != schedule_.size()) {
    throw SetupError(fmt::format("it has {} calls at given times, not {}", scheduled, schedule_.size()));
  }
  archive(scheduled_done_, now_, events_, warnings_, frozen_reported_);
  if (archive.loads()) {
    align_plan();
    take_over_idle();
  }
}

/// Calls visit(name, optional, part) for every part of the state, always in the same order; entities come before what hangs on
/// them.
template <class Visit>
void Simulation::visit_parts(const Visit& visit) {
  world_->for_all([&](Entity& entity) {
    visit(PartName{"entity", {}, entity.name()}, false, entity);
    for (const auto& [name, column] : entity.columns()) {
      if (column->info().scope == Scope::wiring) continue;
      visit(PartName{"property", name, entity.name()}, false, *column);
    }
  });
  for (const auto& task : tasks_) {
    const bool looks_on = task->algorithm->phase() == Phase::observe;
    visit(PartName{"algorithm", task->name, task->entity->name()}, looks_on, *task->algorithm);
  }
  visit(PartName{"the simulation", {}, {}}, false, *this);
}

std::vector<std::byte> Simulation::save() {
  initialize();
  std::vector<std::byte> bytes(begin_of_sections), part;
  visit_parts([&](const PartName& part_name, bool optional, auto& what) {
    std::string name = to_text(part_name);
    part.clear();
    StateArchive content(part);
    what.state(content);
    auto size = static_cast<std::uint64_t>(part.size());
    StateArchive archive(bytes);
    archive(name, optional, size);
    bytes.insert(bytes.end(), part.begin(), part.end());
  });
  const std::uint64_t hash = hash_of(std::span(bytes).subspan(begin_of_sections));
  std::memcpy(bytes.data(), first_line.data(), first_line.size());
  std::memcpy(bytes.data() + first_line.size(), &hash, sizeof(hash));
  return bytes;
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

auto Simulation::agenda() const -> Agenda {
  Agenda agenda;
  agenda.commands_ = queue_.history().size();
  agenda.calls_ = timed_calls_;
  return agenda;
}

void Simulation::agenda_was(Agenda agenda) {
  queue_.forget_from(agenda.commands_);
  timed_calls_ = std::move(agenda.calls_);
}

void Simulation::load_sections(std::span<const std::byte> bytes) {
  const std::vector<Section> sections = sections_of(bytes);
  std::vector<Section> own;
  visit_parts([&](const PartName& name, bool optional, auto&) { own.push_back({to_text(name), optional, {}}); });
  check_names(sections, own);
  auto next = sections.begin();  // of one name there may be several, in the same order
  visit_parts([&](const PartName& part, bool optional, auto& what) {
    const std::string name = to_text(part);
    const auto section = std::find_if(next, sections.end(), [&](const Section& one) { return one.name == name; });
    if (section == sections.end()) {
      if (optional) return;
      throw SetupError(fmt::format("the state has {} elsewhere: this simulation was built otherwise", name));
    }
    with_context("state of " + name, [&] {
      StateArchive archive(section->bytes);
      what.state(archive);
      if (archive.left() > 0) throw SetupError(fmt::format("{} bytes are left over", archive.left()));
    });
    next = section + 1;
  });
  restart_checks();
}

}  // namespace murosimf
