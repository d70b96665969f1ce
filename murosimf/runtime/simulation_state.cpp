// Bytes of a state: a line that says so, the hash of all that follows, then sections, each with its name and the number of its
// bytes. Sections have names so that one can say what does not fit.
#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/math/hash.h"
#include "murosimf/model/error.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf {
namespace {

constexpr std::string_view first_line = "MuRoSimF state 1\n";  // the number is that of the format
constexpr std::size_t begin_of_sections = first_line.size() + sizeof(std::uint64_t);

std::uint64_t hash_of(std::span<const std::byte> bytes) {
  Hasher hasher;
  for (; bytes.size() >= sizeof(std::uint64_t); bytes = bytes.subspan(sizeof(std::uint64_t))) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), sizeof(word));
    hasher.add(word);
  }
  for (const std::byte byte : bytes) hasher.add(static_cast<std::uint64_t>(byte));
  return hasher.value();
}

struct Section {
  std::string name;
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
    archive(sections.back().name, size);
    rest = rest.last(archive.left());
    if (size > rest.size()) throw SetupError("the state ends too early");
    sections.back().bytes = rest.first(size);
    rest = rest.subspan(size);
  }
  return sections;
}

/// The first one of a list that another one lacks; null if it has all.
const std::string* missing(const std::vector<std::string>& names, const std::vector<std::string>& others) {
  const auto found =
      std::ranges::find_if(names, [&](const std::string& name) { return std::ranges::count(others, name) == 0; });
  return found == names.end() ? nullptr : &*found;
}

/// Throws SetupError if the state and the simulation have not the same sections in the same order.
void check_names(const std::vector<std::string>& saved, const std::vector<std::string>& own) {
  if (saved == own) return;
  if (const std::string* name = missing(saved, own)) {
    throw SetupError(fmt::format("the state has {}, this simulation has not: it was built otherwise", *name));
  }
  if (const std::string* name = missing(own, saved)) {
    throw SetupError(fmt::format("this simulation has {}, the state has not: it was built otherwise", *name));
  }
  throw SetupError("the state has its parts in another order: this simulation was built otherwise");
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
  archive(scheduled_done_, now_, ticks_, events_, warnings_, frozen_reported_);
  if (archive.loads()) {
    for (const auto& task : tasks_) task->frozen = task->entity->frozen();
  }
}

/// Calls visit(name, part) for every part of the state, always in the same order; entities come before what hangs on them.
template <class Visit>
void Simulation::visit_sections(const Visit& visit) {
  for (const auto& entity : world_->entities()) {
    visit(fmt::format("entity '{}'", entity->name()), *entity);
    for (const auto& [name, column] : entity->columns()) {
      if (column->info().scope == Scope::wiring) continue;
      visit(fmt::format("property '{}' of '{}'", name, entity->name()), *column);
    }
  }
  for (const auto& task : tasks_) {
    visit(fmt::format("algorithm '{}' of '{}'", task->name, task->entity->name()), *task->algorithm);
  }
  visit(std::string("the simulation"), *this);
}

std::vector<std::byte> Simulation::save() {
  initialize();
  std::vector<std::byte> bytes(begin_of_sections), part;
  visit_sections([&](std::string name, auto& what) {
    part.clear();
    StateArchive content(part);
    what.state(content);
    auto size = static_cast<std::uint64_t>(part.size());
    StateArchive archive(bytes);
    archive(name, size);
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

void Simulation::load_sections(std::span<const std::byte> bytes) {
  const std::vector<Section> sections = sections_of(bytes);
  std::vector<std::string> saved, own;
  for (const Section& section : sections) saved.push_back(section.name);
  visit_sections([&](std::string name, auto&) { own.push_back(std::move(name)); });
  check_names(saved, own);
  auto section = sections.begin();
  visit_sections([&](const std::string& name, auto& what) {
    with_context("state of " + name, [&] {
      StateArchive archive(section->bytes);
      what.state(archive);
      if (archive.left() > 0) throw SetupError(fmt::format("{} bytes are left over", archive.left()));
    });
    ++section;
  });
  restart_checks();
}

}  // namespace murosimf
