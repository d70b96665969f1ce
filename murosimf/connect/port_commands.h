/// port_commands.h - what control software may set: rows of numbers, each with a range, that go to columns of the robot.
///
/// robot_port.h lists them.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/connect/murosimf_controller.h"
#include "murosimf/model/setup.h"
#include "murosimf/model/state_archive.h"

namespace murosimf::connect {

class PortCommands {
 public:
  /// `setup` must live until close().
  explicit PortCommands(Setup& setup) : setup_(&setup), model_(&setup.model()) {}

  /// As RobotPort::command, labels, close, walks, restart, accept and refusal.
  [[nodiscard]] murosimf_command* find(std::string_view name);
  [[nodiscard]] const std::vector<std::string>* labels(std::string_view name) const;
  void close() { setup_ = nullptr; }
  [[nodiscard]] bool walks() const;
  void restart() noexcept;
  std::size_t accept() noexcept;
  [[nodiscard]] std::string refusal() const;
  void state(StateArchive& archive);

 private:
  struct Command {
    std::string name;
    std::vector<std::string> labels;
    double first = 0;                     // value that holds at the start
    std::vector<double> staged;           // the software's
    std::vector<double> accepted;         // the robot's
    std::vector<double> lowest, highest;  // allowed
    std::vector<double*> places;          // in columns
    murosimf_command shown{};
  };
  struct Refused {
    const Command* command = nullptr;  // null: nothing was
    std::size_t number = 0;
    double value = 0;
  };

  Command& make(std::string_view name);
  void connect_joints(Command& command, const Property<double>& property, double limit, bool beside_legs);
  void connect_walk(Command& command);
  void connect_answer(Command& command);
  [[nodiscard]] bool has(std::string_view command) const;

  Setup* setup_;
  const Model* model_;
  std::deque<Command> commands_;  // stay where they are
  Refused refused_;
};

}  // namespace murosimf::connect
