/// sensor_spec.h - what a robot carries, as files say it: plain data.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "murosimf/sensors/signal_spec.h"
#include "murosimf/world/entity.h"

namespace murosimf::sensors {

class ViewSource;    // view_source.h
class WorldQueries;  // world_queries.h

struct SensorSpec {
  std::string name{};                       ///< unique on the robot
  std::string type{};                       ///< name in component_files/sensor_types.h: "imu"
  std::string where{};                      ///< place in the file, for messages
  std::string frame{};                      ///< object of the model that it is mounted on; empty: the base
  Vec3d position{};                         ///< [m] of the sensor in that frame
  Mat3d orientation{};                      ///< its axes to those of the frame
  Vec3d mounting_error{};                   ///< [rad] roll, pitch, yaw by which its true axes are turned from these
  double rate = 0;                          ///< [Hz] of samples; 0: one in every step of the simulation
  double phase = 0;                         ///< [1] of the time between two samples, from 0 to below 1: the first one
  double delay = 0;                         ///< [s] from the sample until control software can read it
  std::vector<std::string> objects{};       ///< joints, feet or other entities that it looks at; empty: all
  std::map<std::string, double> numbers{};  ///< what only some types have, by key; missing: the type's default
  std::map<std::string, std::string> texts{};  ///< the same of words
  /// What becomes of the true values, by output; "": of all outputs; "accelerometer.x": of one number of an output.
  std::map<std::string, SignalSpec> signals{};
  std::string part{};                    ///< name of the ready-made part that it is; empty: none
  std::set<std::string> part_outputs{};  ///< outputs in `signals` that only the part speaks of: it need not have them

  [[nodiscard]] double number(const std::string& key, double otherwise) const {
    const auto found = numbers.find(key);
    return found == numbers.end() ? otherwise : found->second;
  }
  /// Of an output, or of one of its numbers. Perfect if nothing is said.
  [[nodiscard]] SignalSpec signal(const std::string& output) const {
    if (const auto found = signals.find(output); found != signals.end()) return found->second;
    if (const auto dot = output.find('.'); dot != std::string::npos) return signal(output.substr(0, dot));
    const auto all = signals.find("");
    return all == signals.end() ? SignalSpec{} : all->second;
  }
};

/// What sensors need to know of the simulation that they are in.
struct SensorSurroundings {
  std::uint64_t seed = 1;                  ///< of all noise
  std::vector<Entity*> moving_entities{};  ///< robots and ball: all whose pose changes
  /// Source of pictures; requested when a sensor that needs pictures starts. Null, or none: there are no pictures; the caller has
  /// reported that already.
  std::function<ViewSource*()> view_source{};
  /// Shared queries of all sensors with rays; requested when one is made. Null: each sensor has its own.
  std::function<WorldQueries&()> queries{};
};

}  // namespace murosimf::sensors
