/// frame_writer.h - frames of a simulation as messages, each on its topic, for an MCAP file or for viewers.
///
/// | topic | message |
/// |---|---|
/// | `/tf` | foxglove.FrameTransforms: all links of all present entities, each in the frame of its parent; bases in `world` |
/// | `/scene` | foxglove.SceneUpdate: appearance of all entities |
/// | `/joints`, `/targets` | foxglove.JointStates of all robots, by names like `blue1/left_knee`: actual and commanded |
/// | `/contacts`, `/contact_forces` | murosimf.Contacts: points and forces; foxglove.SceneUpdate: the same as arrows, every 50 ms |
/// | `/sensors/ROBOT/SENSOR` | its outputs, a type of its own |
/// | `/events`, `/warnings` | foxglove.Log |
/// | `/commands` | foxglove.Log: changes of the scene while it ran, in the form of Scene::post |
/// | `/outside` | murosimf.Outside, if there are external participants |
/// | `/state_hash` | murosimf.StateHash |
/// | `/state` | murosimf.State: the whole state, as of Scene::save |
///
/// In addition there are pictures (recorded_picture.h) and drawings (recorded_drawings.h).
///
/// Every message is self-contained: it can be interpreted without earlier ones. Metadata of channels contain the names used in logs.
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

/// Recordable data, in the words of --record-what: "poses", "scene", "joints", "contacts", "sensors", "events", "hashes",
/// "states", "drawings", "pictures".
[[nodiscard]] const std::vector<std::string>& recordable();
/// Default selection: all but sensors, which double the size, and pictures, which are far larger.
[[nodiscard]] std::set<std::string> usually_recorded();

class FrameWriter {
 public:
  /// `what`: of recordable(). All arguments outlive the writer.
  FrameWriter(MessageSink& file, const std::vector<RecordedEntity>& entities,
              const std::vector<RecordedSensor>& sensors, const SceneLooks* looks, const std::set<std::string>& what);

  /// A frame has the first ones of the entities that are known.
  void write(const RecordedFrame& frame);
  /// When entities and sensors have become more: channels of those that have come. `looks` are those of all.
  void meet_newcomers(const SceneLooks* looks);
  /// Channels for other writers to the same sink.
  [[nodiscard]] std::uint16_t add_channel(const std::string& topic, const std::string& schema,
                                          const TextMap& metadata = {});

 private:
  [[nodiscard]] std::uint16_t channel(const std::string& topic, const MessageSchema& schema,
                                      const TextMap& metadata = {});
  /// A channel that is created at its first use.
  [[nodiscard]] std::uint16_t late_channel(std::optional<std::uint16_t>& known, const std::string& topic,
                                           const std::string& schema);
  [[nodiscard]] std::optional<std::uint16_t> channel_if(const std::string& what, const std::string& topic,
                                                        const std::string& schema, const TextMap& metadata = {});
  void open_joints();
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
  TextMap prismatic_;                   // units of such joints
  std::vector<std::uint16_t> samples_;  // by sensor
  std::optional<Duration> scene_written_, arrows_written_;
  std::vector<char> scene_present_;
  std::string bytes_;
};

/// The message murosimf.State, without a state murosimf.StateHash.
void put_state(std::string& bytes, Duration time, std::uint64_t hash, std::span<const std::byte> state);

/// The type of a sensor's messages: `timestamp`, and a number for each of its outputs and labels ("gyroscope_x"); outputs with more than 16
/// are lists.
[[nodiscard]] MessageSchema sensor_schema(const RecordedSensor& sensor);

}  // namespace murosimf::recording
