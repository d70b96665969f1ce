/// python_backend.h - what the module murosimf-python.so does for control software in Python (python_software.h).
///
/// The module is loaded when the first class is: the program neither links Python nor starts it otherwise. No exceptions cross the border.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "murosimf/model/option.h"
#include "murosimf/world/time.h"

namespace murosimf::control_software {

/// A class and the robot that an object of it is for.
struct PythonRequest {
  std::string module;  ///< "wave", "team.walk"
  std::string name;    ///< of the class
  std::string file;    ///< of the module; empty: it is looked for in `folder`, then where Python looks
  std::string folder;  ///< of the scene
  OptionValues options;
  std::string robot, team, model;
  std::uint64_t seed = 1;
  std::vector<std::string> joints, objects;
  bool of_scene_file = false;  ///< an algorithm of [[algorithms]], no controller
};

/// How a call has ended.
struct PythonOutcome {
  enum Kind {
    good,
    raised,       ///< an exception
    refused,      ///< the class or its module is not as it must be
    late,         ///< it took longer than the limit
    interrupted,  ///< the program has been asked to end
    ends,         ///< the class ends the run; `text` is its reason
  } kind = good;
  std::string text{};                    ///< one line with file and line
  std::vector<std::string> traceback{};  ///< lines; of `raised` and `late`

  [[nodiscard]] explicit operator bool() const { return kind == good; }
};

/// A quantity of a sensor that is a class.
struct PythonOutput {
  std::string name, unit;
  std::vector<std::string> labels;  ///< empty: a single number
};

/// What a class declares.
struct PythonTraits {
  std::string file;   ///< in which it is
  std::string where;  ///< file and line
  std::string phase;  ///< "control"
  double rate = 0;    ///< [Hz] 0: none
  std::vector<std::string> reads, writes;
  std::vector<PythonOutput> gives;  ///< of a sensor
  bool starts = false;              ///< it has a method `start`
  bool saves = false;               ///< it has methods `save` and `load`
};

/// A row of numbers that an object of a class reads or writes: an array of NumPy.
struct PythonRow {
  enum Kind { property, signal, command, output } kind = property;
  std::string name;
  std::vector<std::size_t> shape;
  std::vector<std::string> labels;  ///< of its first axis; empty: none
  bool writable = false;
};

/// An object of a class. Calls in several threads wait for each other.
class PythonObject {
 public:
  virtual ~PythonObject() = default;
  [[nodiscard]] virtual const PythonTraits& traits() const noexcept = 0;
  /// Memory of a new row, which stays as long as the object; null: see `outcome`.
  [[nodiscard]] virtual double* add(const PythonRow& row, PythonOutcome& outcome) noexcept = 0;
  /// Where lines that it prints go, from now on; those it has printed before come first.
  virtual void print_to(std::function<void(const std::string& line)> say) noexcept = 0;
  /// Seed of the run, which the class sees.
  virtual void reseed(std::uint64_t seed) noexcept = 0;
  /// Replaces it by a new object of its class.
  [[nodiscard]] virtual PythonOutcome renew(Duration limit) noexcept = 0;
  /// `time` [s]
  [[nodiscard]] virtual PythonOutcome start(double time, Duration limit) noexcept = 0;
  [[nodiscard]] virtual PythonOutcome step(double time, Duration limit) noexcept = 0;
  [[nodiscard]] virtual PythonOutcome save(std::string& bytes, Duration limit) noexcept = 0;
  [[nodiscard]] virtual PythonOutcome load(const std::string& bytes, Duration limit) noexcept = 0;
};

class PythonBackend {
 public:
  virtual ~PythonBackend() = default;
  /// Null: see `outcome`.
  [[nodiscard]] virtual PythonObject* load(const PythonRequest& request, Duration limit,
                                           PythonOutcome& outcome) noexcept = 0;
  /// The call of this thread was left by a jump: gives the interpreter's lock to others.
  virtual void abandon() noexcept = 0;
};

/// How the module begins.
struct PythonStart {
  std::string program;              ///< file of the Python program whose packages are used; empty: Python's own rule
  bool (*interrupted)() = nullptr;  ///< whether the program has been asked to end; null: never
};

/// What the module has. Null: `why` says what is missing. The same one for every call; stays until the process ends.
using StartPython = PythonBackend*(const PythonStart& start, std::string& why);
inline constexpr const char* start_python_name = "murosimf_start_python";

}  // namespace murosimf::control_software
