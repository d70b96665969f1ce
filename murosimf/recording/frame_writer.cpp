#include "murosimf/recording/frame_writer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/model.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/recorded_external_input.h"
#include "murosimf/recording/recording_schemas.h"

namespace murosimf::recording {
namespace {

constexpr Duration scene_period = std::chrono::seconds(5);        // after a seek, viewers search back for the last one
constexpr Duration arrow_period = std::chrono::milliseconds(50);  // enough for display
constexpr std::size_t most_named = 16;                            // numbers of an output
constexpr int log_info = 2, log_warning = 3;                      // foxglove.Log.Level

/// Converts a text to a valid name of a field.
std::string identifier(std::string text) {
  for (char& c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return text.empty() || std::isdigit(static_cast<unsigned char>(text.front())) != 0 ? "_" + text : text;
}

/// Pose relative to `outer`, both in the world.
Transformd seen_from(const Transformd& outer, const Transformd& inner) {
  return {transposed_times(outer.orientation, inner.position - outer.position),
          transpose(outer.orientation) * inner.orientation};
}

void put_transform(ProtobufWriter& out, const std::string& time, std::string_view parent, std::string_view child,
                   const Transformd& pose) {
  out.message(1, [&](ProtobufWriter& in) {
    in.bytes(1, time);
    in.text(2, parent);
    in.text(3, child);
    put_vector(in, 4, rounded(pose.position, pose_step));
    put_rotation(in, 5, pose.orientation);
  });
}

/// A joint without torque has no such field: readers distinguish it from 0.
void put_joint(ProtobufWriter& out, const std::string& name, const JointNumbers& joint) {
  out.message(2, [&](ProtobufWriter& in) {
    in.text(1, name);
    in.present_number(2, rounded(joint.position, joint_step));
    in.present_number(3, rounded(joint.velocity, velocity_step));
    if (!std::isnan(joint.torque)) in.present_number(5, rounded(joint.torque, torque_step));
  });
}

void put_target(ProtobufWriter& out, const std::string& name, const JointNumbers& joint) {
  out.message(2, [&](ProtobufWriter& in) {
    in.text(1, name);
    if (!std::isnan(joint.target)) in.present_number(2, rounded(joint.target, joint_step));
  });
}

/// Units of prismatic joints, which have lengths as positions.
TextMap prismatic_joints(const std::vector<RecordedEntity>& entities) {
  TextMap units;
  for (const RecordedEntity& entity : entities) {
    for (const RecordedEntity::Joint& joint : entity.joints) {
      const Object& object = entity.entity->model().objects()[static_cast<std::size_t>(joint.object)];
      if (object.kind == Kind::prismatic) units[joint.name] = "m";
    }
  }
  return units;
}

/// Names of a sensor's fields in logs, by number of the field: "2" is "gyroscope.x [rad/s]". A list has all names, by lines.
/// Of outputs with constants also these, "ranges.fov", and "period" [s].
TextMap names_of(const RecordedSensor& sensor) {
  TextMap names;
  const auto unit = [](const sensors::Output& output) {
    return output.unit.empty() ? std::string{} : fmt::format(" [{}]", output.unit);
  };
  int field = 2;
  for (const sensors::Output& output : sensor.reading->info->outputs) {
    const bool list = output.size() > most_named;
    if (output.labels.empty()) names[fmt::format("{}", field++)] = output.name + unit(output);
    std::string all;
    for (const std::string& label : output.labels) {
      const std::string name = fmt::format("{}.{}{}", output.name, label, unit(output));
      if (list) all += (all.empty() ? "" : "\n") + name;
      if (!list) names[fmt::format("{}", field++)] = name;
    }
    if (list) names[fmt::format("{}", field++)] = all;
    if (!output.constants.empty()) names["period"] = fmt::format("{}", seconds(sensor.reading->info->period));
    for (const auto& [constant, value] : output.constants)
      names[fmt::format("{}.{}", output.name, constant)] = fmt::format("{}", value);
  }
  return names;
}

}  // namespace

const std::vector<std::string>& recordable() {
  static const std::vector<std::string> names = {"poses",  "scene",  "joints", "contacts", "sensors",
                                                 "events", "hashes", "states", "drawings", "pictures"};
  return names;
}

std::set<std::string> usually_recorded() {
  std::set<std::string> names(recordable().begin(), recordable().end());
  names.erase("sensors");
  names.erase("pictures");
  return names;
}

void put_state(std::string& bytes, Duration time, std::uint64_t hash, std::span<const std::byte> state) {
  ProtobufWriter out(bytes);
  put_time(out, 1, time);
  out.fixed64(2, hash);
  if (!state.empty()) out.bytes(3, {reinterpret_cast<const char*>(state.data()), state.size()});
}

/// Each sensor has a schema of its own, with the names of its outputs as fields.
MessageSchema sensor_schema(const RecordedSensor& sensor) {
  MessageSchema schema{.name = fmt::format("murosimf.sensors.{}_{}", identifier(sensor.entity),
                                           identifier(sensor.reading->info->name)),
                       .enums = {},
                       .fields = {{.type = "google.protobuf.Timestamp", .name = "timestamp", .number = 1}}};
  const auto add = [&](const std::string& name, bool repeated) {
    schema.fields.push_back({.type = "double",
                             .name = identifier(name),
                             .number = static_cast<int>(schema.fields.size()) + 1,
                             .repeated = repeated});
  };
  for (const sensors::Output& output : sensor.reading->info->outputs) {
    if (output.labels.empty() || output.size() > most_named) {
      add(output.name, !output.labels.empty());
    } else {
      for (const std::string& label : output.labels) add(output.name + "_" + label, false);
    }
  }
  return schema;
}

FrameWriter::FrameWriter(MessageSink& file, const std::vector<RecordedEntity>& entities,
                         const std::vector<RecordedSensor>& sensors, const SceneLooks* looks,
                         const std::set<std::string>& what)
    : file_(file), entities_(entities), sensors_(sensors), looks_(looks), what_(what) {
  transforms_ = channel_if("poses", "/tf", "foxglove.FrameTransforms");
  scene_ = channel_if("scene", "/scene", "foxglove.SceneUpdate");
  contacts_ = channel_if("contacts", "/contacts", "murosimf.Contacts");
  forces_ = channel_if("contacts", "/contact_forces", "foxglove.SceneUpdate");
  events_ = channel_if("events", "/events", "foxglove.Log");
  warnings_ = channel_if("events", "/warnings", "foxglove.Log");
  hashes_ = channel_if("hashes", "/state_hash", "murosimf.StateHash");
  open_joints();
  meet_newcomers(looks);
}

void FrameWriter::open_joints() {
  prismatic_ = prismatic_joints(entities_);
  joints_ = channel_if("joints", "/joints", "foxglove.JointStates", prismatic_);
  targets_ = channel_if("joints", "/targets", "foxglove.JointStates", prismatic_);
}

/// Channels of joints say which of them slide: where there are more such joints, others are written from then on.
void FrameWriter::meet_newcomers(const SceneLooks* looks) {
  looks_ = looks;
  if (prismatic_joints(entities_) != prismatic_) open_joints();
  while (what_.contains("sensors") && samples_.size() < sensors_.size()) {
    const RecordedSensor& sensor = sensors_[samples_.size()];
    samples_.push_back(channel(fmt::format("/sensors/{}/{}", sensor.entity, sensor.reading->info->name),
                               sensor_schema(sensor), names_of(sensor)));
  }
}

std::uint16_t FrameWriter::channel(const std::string& topic, const MessageSchema& schema, const TextMap& metadata) {
  auto [known, is_new] = schemas_.try_emplace(schema.name, std::uint16_t{0});
  if (is_new) known->second = file_.add_schema(schema.name, "protobuf", descriptors_of(schema));
  return file_.add_channel(topic, "protobuf", known->second, metadata);
}

std::uint16_t FrameWriter::add_channel(const std::string& topic, const std::string& schema, const TextMap& metadata) {
  return channel(topic, find_schema(schema), metadata);
}

std::uint16_t FrameWriter::late_channel(std::optional<std::uint16_t>& known, const std::string& topic,
                                        const std::string& schema) {
  if (!known) known = channel(topic, find_schema(schema));
  return *known;
}

std::optional<std::uint16_t> FrameWriter::channel_if(const std::string& what, const std::string& topic,
                                                     const std::string& schema, const TextMap& metadata) {
  if (!what_.contains(what)) return std::nullopt;
  return channel(topic, find_schema(schema), metadata);
}

void FrameWriter::write(const RecordedFrame& frame) {
  if (events_) {
    for (const auto& [time, text] : frame.events) write_line(*events_, time, log_info, text);
    for (const auto& [time, text] : frame.warnings) write_line(*warnings_, time, log_warning, text);
  }
  for (const auto& [time, text] : frame.commands) {
    write_line(late_channel(commands_, "/commands", "foxglove.Log"), time, log_info, text);
  }
  for (const auto& [channel, note] : frame.outside) {
    bytes_.clear();
    put_outside(bytes_, channel, note);
    file_.write(late_channel(outside_, "/outside", "murosimf.Outside"), frame.time, bytes_);
  }
  for (const SensorSample& sample : frame.samples) write_sample(sample);
  write_state(frame);
  if (!frame.of_poses) return;
  // repeated for readers that start in the middle, and at once when an entity leaves or enters
  const bool repeat = !scene_written_ || frame.time - *scene_written_ >= scene_period;
  if (scene_ && looks_ && (repeat || frame.present != scene_present_)) {
    file_.write(*scene_, frame.time, looks_->message(frame.time, frame.present));
    scene_written_ = frame.time;
    scene_present_ = frame.present;
  }
  if (transforms_) write_transforms(frame);
  for (const bool targets : {false, true}) {
    if (joints_) write_joints(frame, targets);
  }
  if (contacts_) write_contacts(frame);
}

/// Hashes alone in each frame; whole states are much larger, and less frequent.
void FrameWriter::write_state(const RecordedFrame& frame) {
  if (!frame.hash) return;
  bytes_.clear();
  put_state(bytes_, frame.time, *frame.hash, {});
  if (hashes_) file_.write(*hashes_, frame.time, bytes_);
  if (frame.state.empty()) return;
  bytes_.clear();
  put_state(bytes_, frame.time, *frame.hash, frame.state);
  file_.write(late_channel(states_, "/state", "murosimf.State"), frame.time, bytes_);
}

/// Absent entities have no transforms, so that viewers do not show them.
void FrameWriter::write_transforms(const RecordedFrame& frame) {
  MUROSIMF_ASSERT(frame.present.size() <= entities_.size());
  std::string time;
  ProtobufWriter clock(time);
  clock.varint(1, static_cast<std::uint64_t>(frame.time.count() / 1'000'000'000));
  clock.varint(2, static_cast<std::uint64_t>(frame.time.count() % 1'000'000'000));
  bytes_.clear();
  ProtobufWriter out(bytes_);
  const Transformd* pose = frame.poses.data();
  for (std::size_t i = 0; i < frame.present.size(); pose += entities_[i].links.size(), ++i) {
    if (frame.present[i] == 0) continue;
    for (std::size_t k = 0; k < entities_[i].links.size(); ++k) {
      const RecordedEntity::Link& link = entities_[i].links[k];
      if (link.parent < 0) {
        put_transform(out, time, "world", link.frame, pose[k]);
      } else {
        put_transform(out, time, entities_[i].links[static_cast<std::size_t>(link.parent)].frame, link.frame,
                      seen_from(pose[link.parent], pose[k]));
      }
    }
  }
  MUROSIMF_ASSERT(pose == frame.poses.data() + frame.poses.size());
  file_.write(*transforms_, frame.time, bytes_);
}

/// Measured numbers or targets, in messages of the same form.
void FrameWriter::write_joints(const RecordedFrame& frame, bool targets) {
  MUROSIMF_ASSERT(frame.present.size() <= entities_.size());
  bytes_.clear();
  ProtobufWriter out(bytes_);
  put_time(out, 1, frame.time);
  const JointNumbers* joint = frame.joints.data();
  for (std::size_t i = 0; i < frame.present.size(); joint += entities_[i].joints.size(), ++i) {
    if (frame.present[i] == 0) continue;
    for (std::size_t k = 0; k < entities_[i].joints.size(); ++k) {
      (targets ? put_target : put_joint)(out, entities_[i].joints[k].name, joint[k]);
    }
  }
  MUROSIMF_ASSERT(joint == frame.joints.data() + frame.joints.size());
  file_.write(targets ? *targets_ : *joints_, frame.time, bytes_);
}

void FrameWriter::write_contacts(const RecordedFrame& frame) {
  bytes_.clear();
  ProtobufWriter out(bytes_);
  put_time(out, 1, frame.time);
  for (const ContactMark& contact : frame.contacts) {
    out.message(2, [&](ProtobufWriter& in) {
      put_vector(in, 1, rounded(contact.point, point_step));
      put_vector(in, 2, rounded(contact.force, force_step));
      in.varint(3, static_cast<std::uint64_t>(contact.ground_contact_of + 1));
    });
  }
  file_.write(*contacts_, frame.time, bytes_);
  if (arrows_written_ && frame.time - *arrows_written_ < arrow_period) return;
  arrows_written_ = frame.time;
  file_.write(*forces_, frame.time, force_arrows(frame.time, frame.contacts));
}

/// With the instant of the sample, which lies before the one at which it arrives.
void FrameWriter::write_sample(const SensorSample& sample) {
  MUROSIMF_ASSERT(sample.sensor < sensors_.size() && sample.sensor < samples_.size());
  bytes_.clear();
  ProtobufWriter out(bytes_);
  put_time(out, 1, sample.taken);
  const double* value = sample.values.data();
  int field = 2;
  for (const sensors::Output& output : sensors_[sample.sensor].reading->info->outputs) {
    const std::span<const double> values(value, output.size());
    value += output.size();
    if (output.size() > most_named) {
      out.packed_numbers(field++, values);
    } else {
      for (const double one : values) out.number(field++, one);
    }
  }
  MUROSIMF_ASSERT(value == sample.values.data() + sample.values.size());
  file_.write(samples_[sample.sensor], sample.arrived, bytes_);
}

void FrameWriter::write_line(std::uint16_t channel, Duration time, int level, const std::string& text) {
  bytes_.clear();
  ProtobufWriter out(bytes_);
  put_time(out, 1, time);
  out.varint(2, static_cast<std::uint64_t>(level));
  out.text(3, text);
  out.text(4, "murosimf");
  file_.write(channel, time, bytes_);
}

}  // namespace murosimf::recording
