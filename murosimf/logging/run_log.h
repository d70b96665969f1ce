/// run_log.h - records chosen numbers of a run: samples of sensors as they arrive, properties at a separate rate.
///
///     logging::RunLog log(scene.simulation(), {"blue1.imu.*"}, {.step_rate = scene.spec().rate});
///     scene.simulation().run(10s);
///     log.write("run.csv");
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/logging/log_csv.h"
#include "murosimf/logging/log_paths.h"
#include "murosimf/logging/sensor_log.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf::logging {

struct RunLogOptions {
  double step_rate = 1000;     ///< [Hz] of the simulation
  double property_rate = 100;  ///< [Hz] at which properties are recorded: by the first step at or after each instant
  bool others_come = false;    ///< patterns may denote an entity that is yet to come: a warning of the run, no error
};

/// Must outlive the run. Logging changes no result. An entity that comes to the run has columns, too, if a pattern denotes it: behind those of the
/// others, empty until then.
class RunLog {
 public:
  /// Construct when everything else is attached, before the first step. Throws SetupError as find_logged does, and for
  /// an impossible rate.
  RunLog(Simulation& simulation, const std::vector<std::string>& patterns, const RunLogOptions& options = {});
  RunLog(const RunLog&) = delete;  // the simulation calls back
  RunLog& operator=(const RunLog&) = delete;

  /// The numbers recorded so far (log_csv.h).
  [[nodiscard]] std::string csv() const { return to_csv(noted()); }
  /// Writes them to a file, which is complete or absent; as an array for NumPy (log_npy.h) if its name ends with .npy.
  /// Throws SetupError.
  void write(const std::filesystem::path& file) const;

 private:
  struct PropertyLog {
    Entity* entity = nullptr;
    int object = 0;
    std::string property;
    std::vector<std::size_t> numbers;
    LogSeries series;
  };
  [[nodiscard]] std::vector<LoggedNumber> logged_at_start(const RunLogOptions& options) const;
  void add(const std::vector<LoggedNumber>& logged);
  void add_newcomer(Entity& entity);
  void attach_sensor_log(Entity& entity, const std::vector<LoggedNumber>& logged);
  void add_property(const LoggedNumber& number);
  void note_properties();
  void note_again(Duration earliest);
  [[nodiscard]] std::vector<const LogSeries*> noted() const;

  Simulation& simulation_;
  std::vector<std::string> patterns_;
  double step_rate_, property_rate_;           // [Hz]
  bool notes_begun_ = false;                   // of properties
  std::int64_t notes_ = 0;                     // number of recorded rows of properties
  std::vector<const SensorLog*> sensor_logs_;  // one per entity
  std::deque<PropertyLog> properties_;
};

}  // namespace murosimf::logging
