#include "murosimf/session/timeline.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::session {

void Timeline::begin(Duration now, State state) {
  MUROSIMF_ASSERT(options_.period >= Duration{});
  add_branch({{}, now, now, {}, {}});
  now_ = now;
  looks_back_ = false;
  here().states.push_back({now, std::make_shared<const State>(std::move(state))});
}

bool Timeline::wants_state(Duration now) const {
  if (options_.period == Duration{}) return false;
  const Branch& branch = at(present_);
  const Duration newest = branch.states.empty() ? branch.begin : branch.states.back().time;
  return now - newest >= options_.period;
}

bool Timeline::leads_here(std::size_t branch) const {
  for (std::optional<int> from = present_; from; from = at(*from).parent) {
    if (static_cast<std::size_t>(*from) == branch) return true;
  }
  return false;
}

/// Makes the new branch the present one; forgets the oldest ones that are no ancestors of it.
void Timeline::add_branch(Branch branch) {
  branches_.push_back(std::move(branch));
  present_ = static_cast<int>(branches_.size()) - 1;
  auto alive = static_cast<std::size_t>(std::ranges::count(branches_, false, &Branch::forgotten));
  for (std::size_t i = 0; i < branches_.size() && alive > options_.most_branches; ++i) {
    Branch& old = branches_[i];
    if (old.forgotten || leads_here(i)) continue;
    // the first state of a run without a parent is not counted (timeline.h)
    for (std::size_t state = old.parent ? 0 : 1; state < old.states.size(); ++state)
      bytes_ -= old.states[state].state->size();
    drop_notes(old);
    old = {old.parent, old.begin, old.end, {}, {}, true};
    --alive;
  }
}

/// Continuing within a branch starts another one; at its end, commands and notes of that instant are replaced.
void Timeline::settle() {
  if (!std::exchange(looks_back_, false)) return;
  if (now_ < here().end) return add_branch({present_, now_, now_, {}, {}});
  const auto comes_later = [&](const Command& command) { return command.time >= now_; };
  std::erase_if(here().commands, comes_later);
  std::erase_if(here().diagnostics, comes_later);
  auto& notes = here().notes;
  for (; !notes.empty() && notes.back().note.time >= now_; notes.pop_back()) note_bytes_ -= notes.back().size();
}

void Timeline::advance(Duration now) {
  MUROSIMF_ASSERT(now >= now_);
  settle();
  now_ = now;
  here().end = now;
}

void Timeline::keep(Duration now, State state) {
  MUROSIMF_ASSERT(here().states.empty() || here().states.back().time <= now);
  bytes_ += state.size();
  here().states.push_back({now, std::make_shared<const State>(std::move(state))});
  thin_out();
}

void Timeline::note(std::span<const Command> commands) {
  if (commands.empty()) return;
  settle();
  here().commands.insert(here().commands.end(), commands.begin(), commands.end());
}

/// What came from outside is kept with the branch, so that its steps can be repeated.
void Timeline::note(std::vector<RememberedInput> notes) {
  if (notes.empty()) return;
  settle();
  for (RememberedInput& note : notes) {
    note_bytes_ += note.size();
    here().notes.push_back(std::move(note));
  }
  forget_oldest_notes();
}

void Timeline::diagnostic(std::string text) {
  settle();
  here().diagnostics.push_back({now_, std::move(text)});
}

void Timeline::drop_notes(Branch& branch) {
  for (const RememberedInput& note : branch.notes) note_bytes_ -= note.size();
  branch.notes.clear();
}

/// Drops notes of the oldest branch first, and all of an instant together: half of an instant cannot be repeated.
void Timeline::forget_oldest_notes() {
  for (Branch& branch : branches_) {
    auto& notes = branch.notes;
    while (note_bytes_ > options_.most_note_bytes && !notes.empty()) {
      const Duration time = notes.front().note.time;
      branch.notes_from = time + Duration{1};
      for (; !notes.empty() && notes.front().note.time == time; notes.pop_front()) note_bytes_ -= notes.front().size();
    }
  }
}

/// Drops the states whose loss makes the gap between their neighbors, relative to their age, smallest.
void Timeline::thin_out() {
  while (bytes_ > options_.most_bytes) {
    Branch* of = nullptr;
    std::size_t least = 0;
    double smallest = 0;
    for (Branch& branch : branches_) {
      for (std::size_t i = branch.parent ? 0 : 1; i + 1 < branch.states.size(); ++i) {
        const Duration before = i == 0 ? branch.begin : branch.states[i - 1].time;
        const double gap = seconds(branch.states[i + 1].time - before);
        const double age = seconds(branch.states.back().time - branch.states[i].time);
        if (of && gap / age >= smallest) continue;
        of = &branch, least = i, smallest = gap / age;
      }
    }
    if (!of) return;
    MUROSIMF_ASSERT(bytes_ >= of->states[least].state->size());
    bytes_ -= of->states[least].state->size();
    of->states.erase(of->states.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

auto Timeline::at(int branch) const -> const Branch& {
  if (branch < 0 || static_cast<std::size_t>(branch) >= branches_.size()) {
    throw SetupError(fmt::format("there is no branch {} of the run; the last one is {}", branch, branches_.size() - 1));
  }
  return branches_[static_cast<std::size_t>(branch)];
}

void Timeline::collect(int number, Duration begin, Duration end, Way& way) const {
  // ancestors first, so that everything is ordered by time
  const Branch& branch = at(number);
  if (branch.parent) collect(*branch.parent, begin, std::min(end, branch.begin), way);
  const auto add = [&](const std::vector<Command>& all, std::vector<Command>& found) {
    for (const Command& one : all) {
      if (one.time >= begin && one.time < end) found.push_back(one);
    }
  };
  add(branch.commands, way.then);
  add(branch.diagnostics, way.diagnostics);
  if (begin >= end) return;
  if (branch.notes_from > begin) {
    throw SetupError(
        fmt::format("what came from outside before {:.3f} s is not kept any more, so there is only a way to the states "
                    "that are kept ({:.3f} s)",
                    seconds(branch.notes_from), seconds(way.from)));
  }
  const auto time_of = [](const RememberedInput& note) { return note.note.time; };
  MUROSIMF_ASSERT(std::ranges::is_sorted(branch.notes, {}, time_of));
  auto note = std::ranges::lower_bound(branch.notes, begin, {}, time_of);
  for (; note != branch.notes.end() && note->note.time < end; ++note) way.notes.push_back(*note);
}

/// A branch begins with the commands of its parent, up to where it left it.
std::vector<Command> Timeline::commands_until(int number, Duration end) const {
  const Branch& branch = at(number);
  std::vector<Command> commands;
  if (branch.parent) commands = commands_until(*branch.parent, std::min(end, branch.begin));
  for (const Command& command : branch.commands) {
    if (command.time < end) commands.push_back(command);
  }
  return commands;
}

auto Timeline::way_to(int number, Duration time) const -> Way {
  if (time > at(number).end) {
    throw SetupError(fmt::format("the run has not come to {:.3f} s; branch {} ends at {:.3f} s", seconds(time), number,
                                 seconds(at(number).end)));
  }
  Duration until = time;  // states of a parent after the branch has left it are of another run
  for (std::optional<int> from = number; from; from = at(*from).parent) {
    const Branch& branch = at(*from);
    const auto later = std::ranges::upper_bound(branch.states, until, {}, &Kept::time);
    until = std::min(until, branch.begin);
    if (later == branch.states.begin()) continue;
    const Kept& kept = *std::prev(later);
    Way way{kept.state, kept.time, commands_until(number, kept.time), {}, {}, {}};
    collect(number, kept.time, time, way);
    return way;
  }
  throw SetupError(fmt::format("nothing is kept of branch {} at {:.3f} s", number, seconds(time)));
}

void Timeline::go_back(int branch, Duration time) {
  (void)at(branch);
  present_ = branch;
  now_ = time;
  looks_back_ = true;
}

Duration Timeline::first() const {
  Duration first = at(present_).begin;
  for (std::optional<int> from = at(present_).parent; from; from = at(*from).parent) first = at(*from).begin;
  return first;
}

/// Numbers stay the same when branches are forgotten: views refer to them.
std::vector<BranchView> Timeline::branches() const {
  std::vector<BranchView> views;
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    const Branch& branch = branches_[i];
    if (branch.forgotten) continue;
    views.push_back({static_cast<int>(i), branch.parent, branch.begin, branch.end, branch.commands, {}});
    for (const Kept& kept : branch.states) views.back().states.push_back(kept.time);
  }
  return views;
}

}  // namespace murosimf::session
