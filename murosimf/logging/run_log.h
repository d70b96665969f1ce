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
};

/// Must outlive the run. Logging changes no result.
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
  void attach_sensor_logs(const std::vector<LoggedNumber>& logged, double rate);
  void add_property(const LoggedNumber& number);
  void note_properties();
  [[nodiscard]] std::vector<const LogSeries*> noted() const;

  Simulation& simulation_;
  double property_rate_;                       // [Hz]
  std::int64_t notes_ = 0;                     // number of recorded rows of properties
  std::vector<const SensorLog*> sensor_logs_;  // one per entity
  std::deque<PropertyLog> properties_;
};

}  // namespace murosimf::logging
