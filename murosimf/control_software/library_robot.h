/// library_robot.h - the robot as a library sees it (murosimf_robot): lookup of signals and commands by name, options, output lines.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "murosimf/control_software/control_software.h"
#include "murosimf/control_software/murosimf_controller.h"
#include "murosimf/control_software/robot_port.h"
#include "murosimf/model/option.h"

namespace murosimf::control_software {

class LibraryRobot {
 public:
  LibraryRobot(const Setup& setup, RobotPort& port, SayLine say, OptionValues options, std::uint64_t seed);
  LibraryRobot(const LibraryRobot&) = delete;  // the library has pointers into it
  LibraryRobot& operator=(const LibraryRobot&) = delete;

  [[nodiscard]] const murosimf_robot& description() const { return robot_; }

  /// Reason why the last name that was requested does not exist; empty: no failed request since forget_names().
  [[nodiscard]] const std::string& not_found() const { return not_found_; }
  void forget_names() { not_found_.clear(); }
  /// Throws SetupError if an option was given that the library has not requested, or with another type. `owner` is for the message.
  void check_options(const std::string& owner) const;

 private:
  // Functions that the library calls; the first argument leads back to this object.
  static LibraryRobot& of(const murosimf_robot* robot) { return *static_cast<LibraryRobot*>(robot->simulator); }
  static const murosimf_signal* signal(const murosimf_robot* robot, const char* name) noexcept;
  static murosimf_command* command(const murosimf_robot* robot, const char* name) noexcept;
  static const char* label(const murosimf_robot* robot, const char* name, std::size_t i) noexcept;
  static int number_option(const murosimf_robot* robot, const char* name, double* value) noexcept;
  static int truth_option(const murosimf_robot* robot, const char* name, int* value) noexcept;
  static int vector_option(const murosimf_robot* robot, const char* name, double value[3]) noexcept;
  static const char* text_option(const murosimf_robot* robot, const char* name) noexcept;
  static void say(const murosimf_robot* robot, const char* text) noexcept;
  static int use_messages(const murosimf_robot* robot) noexcept;
  static int send(const murosimf_robot* robot, const void* bytes, std::size_t size) noexcept;
  static int receive(const murosimf_robot* robot, murosimf_message* message) noexcept;
  static int draw(const murosimf_robot* robot, const char* group, int of_robot, const murosimf_shape* shapes,
                  std::size_t count) noexcept;
  static const murosimf_picture* picture(const murosimf_robot* robot, const char* name) noexcept;
  template <class Look>
  [[nodiscard]] auto* found(const Look& look) noexcept;
  template <class T>
  [[nodiscard]] const T* option(const char* name);

  [[nodiscard]] const std::byte* shown(const std::string& bytes);

  RobotPort* port_;
  const GuardedRow* message_ = nullptr;  // the last one; null: there was none
  std::size_t room_ = 0;                 // [byte] for it
  SayLine say_;
  OptionValues options_;
  std::string name_, team_, model_;
  murosimf_robot robot_{};
  std::set<std::string, std::less<>> asked_;  // names of options
  std::string wrong_option_;                  // one that was given with another type
  std::string not_found_;
};

}  // namespace murosimf::control_software
