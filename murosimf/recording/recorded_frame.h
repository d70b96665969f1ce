/// recorded_frame.h - data that a recording takes from a simulation at one instant: copied between two steps, written by another thread.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/imaging/image.h"
#include "murosimf/runtime/external_input_log.h"
#include "murosimf/runtime/pose_frame.h"
#include "murosimf/sensors/reading.h"
#include "murosimf/world/drawing.h"
#include "murosimf/world/world.h"

namespace murosimf::recording {

/// The recorded columns of an entity, looked up only after a change of its level: nothing else adds or removes columns.
/// They are kept alive, so that a column that is dropped and created again is the same (world/column_store.h).
class RecordedColumns {
 public:
  void follow(const Entity& entity);

  // Null: no such column.
  const Column<Vec3d>* position = nullptr;
  const Column<Mat3d>* orientation = nullptr;
  const Column<double>*joint_position = nullptr, *joint_velocity = nullptr, *joint_torque = nullptr,
        *joint_target = nullptr;
  const Column<Drawings>* drawings = nullptr;

 private:
  template <class T>
  [[nodiscard]] const Column<T>* keep(const Entity& entity, const Property<T>& property);

  std::optional<std::string> level_;
  std::vector<std::shared_ptr<ColumnBase>> kept_;
};

/// Recorded data of one moving entity.
struct RecordedEntity {
  const Entity* entity = nullptr;
  std::string name;
  struct Link {
    int object = 0;     ///< index in the model
    int parent = -1;    ///< index of its parent among the links
    std::string frame;  ///< "blue1/left_knee"
  };
  std::vector<Link> links;
  struct Joint {
    int object = 0;
    std::string name;  ///< "blue1/left_knee"
  };
  std::vector<Joint> joints;
  RecordedColumns columns;
};

[[nodiscard]] bool has_poses(const Entity& entity);
/// Of an entity with poses.
[[nodiscard]] RecordedEntity recorded_entity(const Entity& entity);
/// Entities with poses, in the order of the world; call when all columns exist.
[[nodiscard]] std::vector<RecordedEntity> recorded_entities(const World& world);

/// A sensor with recorded samples.
struct RecordedSensor {
  std::string entity;
  const sensors::Reading* reading = nullptr;
  std::uint64_t samples = 0;  ///< recorded so far
};
[[nodiscard]] std::vector<RecordedSensor> recorded_sensors(const World& world);
void add_sensors_of(const Entity& entity, std::vector<RecordedSensor>& sensors);

struct SensorSample {
  std::size_t sensor = 0;  ///< index of the RecordedSensor
  Duration arrived{}, taken{};
  std::vector<double> values;
};

/// A picture of a camera: colors or a mosaic.
struct CameraPicture {
  std::size_t camera = 0;  ///< index of the RecordedCamera
  Duration taken{};
  imaging::ColorImage color;
  imaging::GrayImage mosaic;
  imaging::NumberImage depth;  ///< [mm] (imaging/depth_numbers.h)
  imaging::LabelImage labels;
};

/// The author of drawings: a robot's software, or another program (drawing/debug_draw_source.h), at that robot or in the world.
struct DrawingTopic {
  bool by_others = false;
  std::string robot;  ///< its name; empty: in the world
  friend auto operator<=>(const DrawingTopic&, const DrawingTopic&) = default;
};

/// The drawings of a topic from this frame on: all of them.
struct FrameDrawings {
  DrawingTopic topic;
  std::string base;  ///< frame of the robot's base, "blue1/trunk"; empty: none
  std::vector<DrawnGroup> groups;
};

struct JointNumbers {
  double position = 0, velocity = 0;  ///< [rad | m], [rad/s | m/s]
  double torque = 0, target = 0;      ///< [N m | N], [rad | m]; NaN: not provided by its level
};

struct RecordedFrame {
  Duration time{};
  bool of_poses = false;  ///< false: only samples and lines
  // by entity
  std::vector<char> present{};
  std::vector<Transformd> poses{};     ///< [m] of all links of all entities, to the world
  std::vector<JointNumbers> joints{};  ///< of all entities
  std::vector<ContactMark> contacts{};
  std::vector<SensorSample> samples{};
  std::vector<CameraPicture> pictures{};
  std::vector<FrameDrawings> drawings{};
  std::vector<std::pair<Duration, std::string>> events{}, warnings{}, commands{};  ///< new ones
  std::vector<std::pair<std::string, ExternalInput>> outside{};                    ///< by channel, new ones
  std::optional<std::uint64_t> hash{};                                             ///< of the state
  std::vector<std::byte> state{};  ///< the whole state (Scene::save); empty: not recorded

  /// Resets it to a new frame of that instant, but keeps allocated memory.
  void begin_anew(Duration at);
};

/// Adds the present poses and joints.
void take_numbers(std::vector<RecordedEntity>& entities, RecordedFrame& frame);

}  // namespace murosimf::recording
