/// python_rows.h - what an object of a class reads and writes, between the simulation and the arrays that the object sees.
///
/// A name without a dot is a property of its robot: "joint_position"; one with a dot a signal or command of the robot's port (robot_port.h):
/// "imu.gyroscope", "walk.velocity"; or else a property of another entity: "ball.position", or a quantity of
/// a sensor of it: "blue1.imu.gyroscope". Properties of joints have a number for each joint,
/// those of objects a row for each object.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/control_software/python/named_columns.h"
#include "murosimf/control_software/python/python_backend.h"
#include "murosimf/control_software/robot_port.h"

namespace murosimf::control_software {

class PythonRows {
 public:
  /// `port`: null for an algorithm that is no controller; what it writes keeps the first values that others give. `reading`: of a sensor;
  /// null: it is none. Throws SetupError: a name that there is not, with the nearest.
  PythonRows(Setup& setup, RobotPort* port, const std::vector<Entity*>& others, PythonObject& object,
             sensors::Reading* reading = nullptr);

  /// First values of what is written: joints at rest, all else 0.
  void restart() noexcept;
  /// What is read and written, as it is now.
  void show() noexcept;
  /// What was written. A number that is not finite: nothing is taken over, and the text says which; otherwise it is empty.
  [[nodiscard]] std::string take();

  /// All numbers that are written to properties.
  [[nodiscard]] std::vector<double> written() const;
  void write(const std::vector<double>& numbers) noexcept;

 private:
  struct OfColumn {
    std::string name;
    std::vector<std::string> labels;  // of its first axis
    std::vector<double*> places;      // in the simulation, in the order of the array
    std::vector<double> at_start;
    double* array;
    bool written;
  };
  struct OfPort {
    const murosimf_signal* signal;  // null: a command
    murosimf_command* command;
    double* array;
  };
  struct OfReading {
    std::span<const double> values;  // in the simulation
    double* array;
  };
  void add(Setup& setup, RobotPort* port, const std::vector<Entity*>& others, const std::string& name, bool written);
  void add_column(const std::string& name, const NamedColumn& column, const Entity& entity, bool of_robot,
                  bool written);
  void add_outputs(sensors::Reading& reading);
  void add_of_sensor(Setup& of_entity, const std::string& name, const std::string& path);
  [[nodiscard]] bool add_of_robot(Setup& setup, const std::string& name, bool written);
  [[nodiscard]] bool add_of_port(RobotPort& port, const std::string& name, bool written);
  [[nodiscard]] bool add_of_other(Setup& setup, const std::vector<Entity*>& others, const std::string& name,
                                  bool written);
  [[nodiscard]] double* new_array(const PythonRow& row);

  PythonObject* object_;
  bool controls_;
  std::vector<OfColumn> columns_;
  std::vector<OfPort> ports_;
  std::vector<OfReading> readings_;                             // that are read
  std::vector<std::pair<std::span<double>, double*>> outputs_;  // that are given, and their arrays
};

}  // namespace murosimf::control_software
