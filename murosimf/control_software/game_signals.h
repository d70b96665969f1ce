/// game_signals.h - the state of the game as signals for control software, by name: game.state, game.penalty, ... (game_view.h).
#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control_software/game_view.h"
#include "murosimf/control_software/guard/guarded_row.h"
#include "murosimf/control_software/murosimf_controller.h"
#include "murosimf/world/setup.h"

namespace murosimf::control_software {

class GameSignals {
 public:
  /// `setup` must live until close(), and the rows, to which it adds, as long as this.
  GameSignals(Setup& setup, GuardedRows& rows) : setup_(&setup), rows_(&rows) {}

  [[nodiscard]] static std::vector<std::string_view> names();

  /// Null if it is none of names(). Throws SetupError for the first one after close().
  [[nodiscard]] const murosimf_signal* find(std::string_view name);
  /// Null if `name` is none of names().
  [[nodiscard]] static const std::vector<std::string>* labels(std::string_view name);
  void close() { setup_ = nullptr; }
  void refresh() noexcept;

 private:
  struct Shown {
    std::string_view name;
    std::span<const double> numbers;
    const GuardedRow* row;
  };

  Setup* setup_;
  GuardedRows* rows_;
  const GameView* view_ = nullptr;  // null: no signal requested yet
  std::deque<Shown> shown_;         // stay where they are
};

}  // namespace murosimf::control_software
