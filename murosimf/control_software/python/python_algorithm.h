/// python_algorithm.h - an algorithm of a scene file as a class in Python: a sensor, a referee, or anything that reads and writes properties
/// (docs/python.md).
///
/// It belongs to an entity or to the whole scene. A sensor gives a reading, which control software reads as that of any other. When the class
/// fails, its entity is frozen; without one, the run ends as after a crash.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "murosimf/control_software/crash_note.h"
#include "murosimf/control_software/python/python_reading.h"
#include "murosimf/control_software/python/python_software.h"
#include "murosimf/control_software/software_report.h"

namespace murosimf::control_software {

struct PythonAlgorithmOptions {
  PythonReadingOptions sensor;       ///< name and rate of all algorithms, the rest of sensors alone
  Duration budget{};                 ///< wall time that a call may take; 0: any
  std::shared_ptr<CrashNote> notes;  ///< ends the run
};

class PythonAlgorithm final : public Algorithm {
 public:
  /// A sensor is attached at execution_rate(). `common`: of the world; the setup's entity, if the algorithm is of the whole scene.
  /// `others`: entities that the class can name. Throws SetupError.
  PythonAlgorithm(Setup& setup, PythonClass made, Entity& common, const std::vector<Entity*>& others,
                  PythonAlgorithmOptions options);

  [[nodiscard]] Phase phase() const noexcept override { return phase_; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;
  void state(StateArchive& archive) override;
  void reseed(std::uint64_t seed) override;

  [[nodiscard]] const std::string& name() const { return options_.sensor.name; }
  [[nodiscard]] const SoftwareReport& report() const { return report_; }
  /// Why it ends the run; empty: it does not.
  [[nodiscard]] const std::string& end_of_run() const { return end_of_run_; }

 private:
  /// False: it has failed.
  [[nodiscard]] bool call(Duration now) noexcept;
  void fail(const CallOutcome& outcome);
  void take_end();
  void begin_anew();

  PythonAlgorithmOptions options_;
  Phase phase_;
  Entity* entity_;                          // null: of the whole scene
  std::unique_ptr<PythonReading> reading_;  // null: it is no sensor
  SoftwareReport report_;
  Duration now_{};
  bool over_ = false;
  std::string note_;  // that it has written, of an exception
  std::string end_of_run_;
  std::unique_ptr<PythonSoftware> software_;
};

}  // namespace murosimf::control_software
