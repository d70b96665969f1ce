/// port_commands.h - commands of control software: rows of numbers, each with a range, that are written to columns of the robot.
///
/// robot_port.h lists them.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control_software/delayed_rows.h"
#include "murosimf/control_software/guard/guarded_row.h"
#include "murosimf/control_software/murosimf_controller.h"
#include "murosimf/world/setup.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::control_software {

/// Allowed numbers of a command, one after the other.
struct CommandRange {
  std::span<const double> lowest, highest;
};

class PortCommands {
 public:
  /// `setup` must live until close(), and the rows, to which it adds, as long as this.
  PortCommands(Setup& setup, GuardedRows& rows) : setup_(&setup), model_(&setup.model()), rows_(&rows) {}

  /// As RobotPort::command, labels, close, walks, restart, accept and refusal.
  [[nodiscard]] murosimf_command* find(std::string_view name);
  [[nodiscard]] const std::vector<std::string>* labels(std::string_view name) const;
  [[nodiscard]] CommandRange range(std::string_view name) const;
  void close() { setup_ = nullptr; }
  [[nodiscard]] bool walks() const;
  [[nodiscard]] bool uses_motions() const;
  /// Called when a signal of the motion engine is requested: that engine then moves the robot. Throws SetupError as find.
  void watch_motions(std::string_view signal);
  void restart() noexcept;
  std::size_t accept(Duration now) noexcept;
  /// Sends accepted commands over a link from now on; they apply on arrival (deliver()). Before close().
  void use_link(const LinkOptions& options, std::uint64_t seed);
  /// Applies commands that have arrived.
  void deliver(Duration now) noexcept;
  /// All numbers as set by the software, command by command; empty: equal to those accepted last.
  [[nodiscard]] std::vector<double> numbers_set() const;
  /// Sets these numbers as the software would.
  void set_numbers(std::span<const double> numbers) noexcept;
  /// Applies all accepted commands and clears the link.
  void settle() noexcept;
  /// Declares the columns that this object writes, for another algorithm.
  void declare(Setup& setup) const;
  void reseed(std::uint64_t seed);
  [[nodiscard]] const DelayedRows* link() const { return link_ ? &*link_ : nullptr; }
  [[nodiscard]] std::string refusal() const;
  void state(StateArchive& archive);

 private:
  struct Command {
    std::string name;
    std::vector<std::string> labels;
    std::vector<double> first;            // values that hold at the start
    std::span<double> staged{};           // the software's
    std::vector<double> accepted;         // the robot's
    std::vector<double> lowest, highest;  // allowed
    std::vector<double*> places;          // in columns
    std::vector<const double*> others;    // not 0: another algorithm has this number now; empty: none ever has
    std::function<void(Setup&)> declare;  // that it is written
    const GuardedRow* row = nullptr;      // where they stand
    void write(std::size_t i, double value) const noexcept {
      if (others.empty() || *others[i] == 0) *places[i] = value;
    }
  };
  struct Refused {
    const Command* command = nullptr;  // null: nothing was
    std::size_t number = 0;
    double value = 0;
  };

  Command& make(std::string_view name);
  void check_mover(std::string_view name) const;
  void connect_joints(Command& command, const Property<double>& property, double limit, bool beside_legs);
  void connect(Command& command);
  void connect_servos(Command& command, const Property<double>& property);
  void connect_switch(Command& command);
  void leave_to_motions(Command& command);
  void connect_led(Command& command);
  void connect_walk(Command& command);
  void connect_motions(Command& command);
  void connect_kick(Command& command);
  void connect_answer(Command& command);
  [[nodiscard]] bool has(std::string_view command) const;
  void send(Duration now);

  Setup* setup_;
  const Model* model_;
  GuardedRows* rows_;
  std::deque<Command> commands_;  // stay where they are
  std::string watched_;           // a requested signal of the motion engine; empty: none
  Refused refused_;
  std::optional<DelayedRows> link_;
  std::vector<double> sent_;  // memory of the link
};

}  // namespace murosimf::control_software
