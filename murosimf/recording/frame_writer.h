/// frame_writer.h - frames of a simulation as messages, each on its topic, of an MCAP file or for viewers.
///
/// | topic | message |
/// |---|---|
/// | `/tf` | foxglove.FrameTransforms: all links of all who are there, each in the frame of its parent; bases in `world` |
/// | `/scene` | foxglove.SceneUpdate: what all of it looks like |
/// | `/joints`, `/targets` | foxglove.JointStates of all robots, by names like `blue1/left_knee`: as they are, and as they should be |
/// | `/contacts`, `/contact_forces` | murosimf.Contacts: points and forces; foxglove.SceneUpdate: the same as arrows, every 50 ms |
/// | `/sensors/ROBOT/SENSOR` | its outputs, a type of its own |
/// | `/events`, `/warnings` | foxglove.Log |
/// | `/commands` | foxglove.Log: what was asked of the scene while it ran, as Scene::post takes it |
/// | `/outside` | murosimf.Outside, if somebody else takes part |
/// | `/state_hash` | murosimf.StateHash |
/// | `/state` | murosimf.State: all of it, as Scene::save has it |
///
/// Beside them stand pictures (recorded_picture.h) and drawings (recorded_drawings.h).
///
/// Every message stands alone: nothing of an earlier one is needed to understand it. Metadata of channels have the names that logs use.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "murosimf/recording/mcap/message_schema.h"
#include "murosimf/recording/mcap/message_sink.h"
#include "murosimf/recording/recorded_frame.h"
#include "murosimf/recording/scene_message.h"

namespace murosimf::recording {

/// What can be recorded, in the words of --record-what: "poses", "scene", "joints", "contacts", "sensors", "events", "hashes",
/// "states", "drawings", "pictures".
[[nodiscard]] const std::vector<std::string>& recordable();
/// What is recorded unless somebody says otherwise: all but sensors, which are as many bytes again, and pictures, which are far more.
[[nodiscard]] std::set<std::string> usually_recorded();

class FrameWriter {
 public:
  /// `what`: of recordable(). All of it outlives the writer.
  FrameWriter(MessageSink& file, const std::vector<RecordedEntity>& entities,
              const std::vector<RecordedSensor>& sensors, const SceneLooks* looks, const std::set<std::string>& what);

  void write(const RecordedFrame& frame);
  /// For others, who write into it themselves.
  [[nodiscard]] std::uint16_t add_channel(const std::string& topic, const std::string& schema,
                                          const TextMap& metadata = {});

 private:
  [[nodiscard]] std::uint16_t channel(const std::string& topic, const MessageSchema& schema,
                                      const TextMap& metadata = {});
  /// One that is there as soon as it is needed.
  [[nodiscard]] std::uint16_t late_channel(std::optional<std::uint16_t>& known, const std::string& topic,
                                           const std::string& schema);
  [[nodiscard]] std::optional<std::uint16_t> channel_if(const std::string& what, const std::string& topic,
                                                        const std::string& schema, const TextMap& metadata = {});
  void write_transforms(const RecordedFrame& frame);
  void write_joints(const RecordedFrame& frame, bool targets);
  void write_contacts(const RecordedFrame& frame);
  void write_sample(const SensorSample& sample);
  void write_state(const RecordedFrame& frame);
  void write_line(std::uint16_t channel, Duration time, int level, const std::string& text);

  MessageSink& file_;
  const std::vector<RecordedEntity>& entities_;
  const std::vector<RecordedSensor>& sensors_;
  const SceneLooks* looks_;
  std::set<std::string> what_;
  std::map<std::string, std::uint16_t> schemas_;
  std::optional<std::uint16_t> transforms_, scene_, joints_, targets_, contacts_, forces_, events_, warnings_, hashes_,
      commands_, states_, outside_;
  std::vector<std::uint16_t> samples_;  // by sensor
  std::optional<Duration> scene_written_, arrows_written_;
  std::vector<char> scene_present_;
  std::string bytes_;
};

/// The message murosimf.State, without a state murosimf.StateHash.
void put_state(std::string& bytes, Duration time, std::uint64_t hash, std::span<const std::byte> state);

/// The type of a sensor's messages: `timestamp`, and a number for each of its outputs and labels ("gyroscope_x"); outputs of more than 16
/// are lists.
[[nodiscard]] MessageSchema sensor_schema(const RecordedSensor& sensor);

}  // namespace murosimf::recording
