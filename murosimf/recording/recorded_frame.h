/// recorded_frame.h - what a recording takes of a simulation at one instant: copied between two steps, written by another thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/model/world.h"
#include "murosimf/runtime/pose_frame.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::recording {

/// What is recorded of one entity that moves.
struct RecordedEntity {
  const Entity* entity = nullptr;
  std::string name;
  struct Link {
    int object = 0;     ///< of the model
    int parent = -1;    ///< index of its parent among the links
    std::string frame;  ///< "blue1/left_knee"
  };
  std::vector<Link> links;
  struct Joint {
    int object = 0;
    std::string name;  ///< "blue1/left_knee"
  };
  std::vector<Joint> joints;
};

/// Those that have poses, in the order of the world; to be called when all columns are there.
[[nodiscard]] std::vector<RecordedEntity> recorded_entities(const World& world);

/// A sensor whose samples are recorded.
struct RecordedSensor {
  std::string entity;
  const sensors::Reading* reading = nullptr;
  std::uint64_t samples = 0;  ///< that are recorded
};
[[nodiscard]] std::vector<RecordedSensor> recorded_sensors(const World& world);

struct SensorSample {
  std::size_t sensor = 0;  ///< index of the RecordedSensor
  Duration arrived{}, taken{};
  std::vector<double> values;
};

struct JointNumbers {
  double position = 0, velocity = 0;  ///< [rad | m], [rad/s | m/s]
  double torque = 0, target = 0;      ///< [N m | N], [rad | m]; NaN: its level has none
};

struct RecordedFrame {
  Duration time{};
  bool of_poses = false;  ///< false: nothing but samples and lines
  // by entity
  std::vector<char> present;
  std::vector<Transformd> poses;     ///< [m] of all links of all entities, to the world
  std::vector<JointNumbers> joints;  ///< of all entities
  std::vector<ContactMark> contacts;
  std::vector<SensorSample> samples;
  std::vector<std::pair<Duration, std::string>> events, warnings;  ///< new ones
  std::optional<std::uint64_t> hash;                               ///< of the state
};

/// Adds poses and joints of now.
void take_numbers(const std::vector<RecordedEntity>& entities, RecordedFrame& frame);

}  // namespace murosimf::recording
