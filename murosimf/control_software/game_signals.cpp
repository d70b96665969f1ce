#include "murosimf/control_software/game_signals.h"

#include <algorithm>
#include <functional>
#include <span>

#include "murosimf/control_software/signal_row.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

using Numbers = std::span<const double>;

struct Entry {
  std::string_view name;
  std::vector<std::string> labels;
  std::function<Numbers(const GameView&)> numbers;
};

Entry number(std::string_view name, double GameView::*member) {
  const auto end = name.substr(name.find('.') + 1);
  return {name, {std::string(end)}, [member](const GameView& view) { return Numbers(&(view.*member), 1); }};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      number("game.state", &GameView::state),
      number("game.secondary_state", &GameView::secondary_state),
      number("game.secondary_team", &GameView::secondary_team),
      number("game.secondary_phase", &GameView::secondary_phase),
      number("game.half", &GameView::half),
      number("game.kick_off", &GameView::kick_off),
      number("game.remaining", &GameView::remaining),
      number("game.secondary_remaining", &GameView::secondary_remaining),
      number("game.stopped", &GameView::stopped),
      number("game.phase", &GameView::phase),
      number("game.message_budget", &GameView::message_budget),
      number("game.version", &GameView::version),
      number("game.penalty", &GameView::penalty),
      number("game.penalty_remaining", &GameView::penalty_remaining),
      number("game.team", &GameView::team),
      number("game.number", &GameView::number),
      {"game.score", {"own", "other"}, [](const GameView& view) { return Numbers(view.score); }},
      {"game.cards", {"warnings", "yellow", "red"}, [](const GameView& view) { return Numbers(view.cards); }}};
  return all;
}

const Entry* entry(std::string_view name) {
  const auto found = std::ranges::find(entries(), name, &Entry::name);
  return found == entries().end() ? nullptr : &*found;
}

}  // namespace

void append_hash(Hasher& hasher, const GameView& view) {
  hasher.add(static_cast<std::uint64_t>(view.time));
  hasher.add(view.samples);
  for (const Entry& each : entries()) {
    for (const double value : each.numbers(view)) hasher.add(value);
  }
}

std::vector<std::string_view> GameSignals::names() {
  std::vector<std::string_view> all;
  for (const Entry& each : entries()) all.push_back(each.name);
  return all;
}

const std::vector<std::string>* GameSignals::labels(std::string_view name) {
  const Entry* found = entry(name);
  return found ? &found->labels : nullptr;
}

const murosimf_signal* GameSignals::find(std::string_view name) {
  const Entry* found = entry(name);
  if (!found) return nullptr;
  const auto known = std::ranges::find(shown_, name, &Shown::name);
  if (known != shown_.end()) return &known->row->shown_head<const murosimf_signal>();
  if (!view_) {
    if (!setup_) throw SetupError("the game was not asked for when the robot was set up, so it cannot be now");
    view_ = &setup_->input(game_view, {})[0];
  }
  const Numbers numbers = found->numbers(*view_);
  shown_.push_back({found->name, numbers, &show_numbers(*rows_, std::string(name), numbers, {})});
  return &shown_.back().row->shown_head<const murosimf_signal>();
}

void GameSignals::refresh() noexcept {
  MUROSIMF_ASSERT(shown_.empty() || view_);  // the first row is made after the column
  for (Shown& each : shown_) {
    murosimf_signal now{};
    now.time = view_->time;
    now.samples = view_->samples;
    show_numbers(*each.row, each.numbers, now);
  }
}

}  // namespace murosimf::control_software
