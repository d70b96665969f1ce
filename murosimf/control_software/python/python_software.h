/// python_software.h - control software as a class in Python (docs/python.md): an object of it, for one robot.
///
/// The class declares what it reads and writes (python_rows.h), and is called like a library: `start`, then once in each cycle. An algorithm of a scene file (python_algorithm.h) is the same without a robot's port. An exception
/// ends it, and its robot keeps what was written last; its traceback becomes lines of the report. A call that takes too long is ended by an
/// exception where it runs Python's own code; elsewhere, and after a crash, the run ends (guard/guarded_call.h).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/control_software/control_software.h"
#include "murosimf/control_software/guard/guarded_call.h"
#include "murosimf/control_software/python/python_rows.h"
#include "murosimf/world/algorithm.h"

namespace murosimf::control_software {

struct PythonOptions {
  std::string target;            ///< "module:Class", or "path/module.py:Class"
  std::filesystem::path folder;  ///< of the scene
  OptionValues options;          ///< arguments of the class
  std::uint64_t seed = 1;        ///< of the run
  Duration budget{};             ///< wall time that a call may take; 0: any
  std::string algorithm{};       ///< name of an algorithm of a scene file; empty: it is a controller
  bool of_whole_scene = false;   ///< the algorithm is of no entity
};

/// An object of a class before it is part of the simulation. Its traits are known.
class PythonClass {
 public:
  /// Throws SetupError in one line: there is no Python, no such module or class, or it takes no such options. Throws SoftwareCrash.
  PythonClass(const Entity& robot, const PythonOptions& options);

  [[nodiscard]] const PythonTraits& traits() const { return object_->traits(); }
  [[nodiscard]] Phase phase() const;
  /// "wave:Wave of wave.py", for reports.
  [[nodiscard]] std::string name() const;
  /// What a sensor gives; empty: it is none.
  [[nodiscard]] std::vector<sensors::Output> outputs() const;

 private:
  friend class PythonSoftware;
  std::string target_;
  Duration limit_;
  std::shared_ptr<ForeignThreads> threads_;
  GuardedCall guard_;
  std::unique_ptr<PythonObject> object_;
};

/// Objects of all classes are called one after the other, in the order of attaching, which makes results independent of threads. `common` is
/// that of the world.
void python_in_turns(const Setup& setup, Entity& common);

class PythonSoftware final : public ControlSoftware {
 public:
  /// `others`: entities whose properties the class can name. `port`, `reading`: as of PythonRows. Throws SetupError.
  PythonSoftware(Setup& setup, RobotPort* port, SayLine say, PythonClass made, const std::vector<Entity*>& others,
                 sensors::Reading* reading = nullptr);

  [[nodiscard]] CallOutcome start() override;
  [[nodiscard]] CallOutcome step(Duration now) noexcept override;
  void state(StateArchive& archive) override;
  [[nodiscard]] bool keeps_state() const override { return !made_.traits().saves; }
  void reseed(std::uint64_t seed) override { made_.object_->reseed(seed); }
  [[nodiscard]] std::vector<double> written() const override { return rows_.written(); }
  void write(const std::vector<double>& numbers) noexcept override { rows_.write(numbers); }

  /// Why the last call has ended the run; empty: it has not.
  [[nodiscard]] const std::string& end_of_run() const { return end_of_run_; }

 private:
  template <class Call>
  [[nodiscard]] CallOutcome guarded(const char* what, const Call& call);
  [[nodiscard]] CallOutcome taken_over(const CallOutcome& outcome);

  PythonClass made_;
  SayLine say_;
  PythonRows rows_;
  std::string end_of_run_;
  bool fresh_ = true;         // the object is new
  bool begun_ = false;        // it has state, of a run that has begun
  bool interrupted_ = false;  // the last call was ended because the program is to end
};

}  // namespace murosimf::control_software
