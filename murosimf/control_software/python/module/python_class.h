/// python_class.h - an object of a class in Python, as the simulator calls it.
#pragma once

#include "murosimf/control_software/python/module/python_watch.h"

#include <string>
#include <vector>

#include "murosimf/control_software/python/python_backend.h"

namespace murosimf::control_software::python {

/// What classes.py has.
struct Classes {
  Object load, explain;
  bool own_interpreter = false;  ///< not that of a Python program
};

class Class final : public PythonObject {
 public:
  /// With the interpreter's lock. Throws Raised.
  Class(const Classes& classes, Watch& watch, const PythonRequest& request, Duration limit);
  ~Class() override;
  Class(const Class&) = delete;
  Class& operator=(const Class&) = delete;

  [[nodiscard]] const PythonTraits& traits() const noexcept override { return traits_; }
  [[nodiscard]] double* add(const PythonRow& row, PythonOutcome& outcome) noexcept override;
  void print_to(std::function<void(const std::string& line)> say) noexcept override;
  void reseed(std::uint64_t seed) noexcept override;
  [[nodiscard]] PythonOutcome renew(Duration limit) noexcept override;
  [[nodiscard]] PythonOutcome start(double time, Duration limit) noexcept override;
  [[nodiscard]] PythonOutcome step(double time, Duration limit) noexcept override;
  [[nodiscard]] PythonOutcome save(std::string& bytes, Duration limit) noexcept override;
  [[nodiscard]] PythonOutcome load(const std::string& bytes, Duration limit) noexcept override;

  /// A line that it prints.
  void say(const std::string& line) const;

 private:
  template <class Function>
  [[nodiscard]] PythonOutcome call(Duration limit, const Function& function) noexcept;
  void find_object();

  const Classes& classes_;
  Watch& watch_;
  Object loaded_, object_, robot_;
  PythonTraits traits_;
  std::function<void(const std::string&)> say_;
  mutable std::vector<std::string> early_;  // printed before there was a place for it
};

/// With the interpreter's lock: the exception that is set, which is none afterwards.
[[nodiscard]] PythonOutcome outcome_of_exception(const Object& explain, const std::string& file) noexcept;

}  // namespace murosimf::control_software::python
