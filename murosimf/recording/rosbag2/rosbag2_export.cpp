#include "murosimf/recording/rosbag2/rosbag2_export.h"

#include <algorithm>
#include <map>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/mcap_writer.h"
#include "murosimf/recording/rosbag2/ros_messages.h"
#include "murosimf/recording/rosbag2/ros_types.h"
#include "murosimf/recording/topics.h"

namespace murosimf::recording {
namespace {

namespace fs = std::filesystem;

/// "tf2_msgs/TFMessage" as ROS 2 names it where other kinds of interfaces have names, too.
std::string full_type(const std::string& type) {
  const std::size_t slash = type.find('/');
  return fmt::format("{}/msg/{}", type.substr(0, slash), type.substr(slash + 1));
}

class BagWriter {
 public:
  explicit BagWriter(const fs::path& file) : file_(file, {.library = "murosimf", .profile = "ros2"}) {}

  void write(const RosMessage& message, Duration time) {
    auto [topic, is_new] = topics_.try_emplace(message.topic);
    if (is_new) topic->second = {.type = message.type, .channel = channel_of(message), .messages = 0};
    if (topic->second.type != message.type)
      throw SetupError(fmt::format("'{}' would have two types of messages, {} and {}", message.topic,
                                   topic->second.type, message.type));
    file_.write(topic->second.channel, time, message.data);
    if (messages_++ == 0) begin_ = time;
    begin_ = std::min(begin_, time);
    end_ = std::max(end_, time);
    ++topic->second.messages;
  }

  void close() { file_.close(); }
  [[nodiscard]] Rosbag2Summary summary() const { return {.messages = messages_, .topics = topics_.size()}; }

  /// Version 5 of the file (rosbag2 of Humble), which later ones read, too.
  [[nodiscard]] std::string metadata(const std::string& file_name) const {
    std::string text = fmt::format(
        "rosbag2_bagfile_information:\n"
        "  version: 5\n"
        "  storage_identifier: mcap\n"
        "  duration:\n"
        "    nanoseconds: {0}\n"
        "  starting_time:\n"
        "    nanoseconds_since_epoch: {1}\n"
        "  message_count: {2}\n"
        "  topics_with_message_count:\n",
        (end_ - begin_).count(), begin_.count(), messages_);
    for (const auto& [name, topic] : topics_) {
      text += fmt::format(
          "    - topic_metadata:\n"
          "        name: {}\n"
          "        type: {}\n"
          "        serialization_format: cdr\n"
          "        offered_qos_profiles: \"\"\n"
          "      message_count: {}\n",
          name, full_type(topic.type), topic.messages);
    }
    text += fmt::format(
        "  compression_format: \"\"\n"
        "  compression_mode: \"\"\n"
        "  relative_file_paths:\n"
        "    - {0}\n"
        "  files:\n"
        "    - path: {0}\n"
        "      starting_time:\n"
        "        nanoseconds_since_epoch: {1}\n"
        "      duration:\n"
        "        nanoseconds: {2}\n"
        "      message_count: {3}\n",
        file_name, begin_.count(), (end_ - begin_).count(), messages_);
    return text;
  }

 private:
  struct Topic {
    std::string type;
    std::uint16_t channel = 0;
    std::uint64_t messages = 0;
  };
  std::uint16_t channel_of(const RosMessage& message) {
    const std::string type = full_type(message.type);
    auto [schema, is_new] = schemas_.try_emplace(type, std::uint16_t{0});
    if (is_new) schema->second = file_.add_schema(type, "ros2msg", ros_definition(message.type));
    return file_.add_channel(message.topic, "cdr", schema->second, {{"offered_qos_profiles", ""}});
  }

  McapWriter file_;
  std::map<std::string, Topic> topics_;
  std::map<std::string, std::uint16_t> schemas_;
  std::uint64_t messages_ = 0;
  Duration begin_{}, end_{};
};

void convert(const McapReader& recording, BagWriter& bag) {
  std::map<std::uint16_t, Channel> channels;
  for (const Channel& channel : recording.contents().channels) {
    if (RosMessages::converts(channel)) channels.emplace(channel.id, channel);
  }
  RosMessages messages;
  for (const ChunkIndex& chunk : recording.contents().chunks) {
    if (!has_any(chunk, channels)) continue;
    recording.visit_messages(chunk, [&](const Message& message) {
      const auto channel = channels.find(message.channel_id);
      if (channel == channels.end()) return;
      const Duration time = time_of(message);
      for (const RosMessage& one : messages.of(channel->second, message.data, time)) bag.write(one, time);
    });
  }
  if (bag.summary().messages == 0) throw SetupError("it has nothing that ROS 2 has messages for (--record-what)");
}

/// A folder that goes unless it is completed.
class PartFolder {
 public:
  explicit PartFolder(const fs::path& folder) : folder_(folder), part_(folder.string() + ".part") {
    std::error_code error;
    if (fs::exists(fs::symlink_status(folder_, error)))
      throw SetupError(fmt::format("'{}' exists; a bag is a new folder", folder_.string()));
    fs::remove_all(part_, error);
    if (!fs::create_directory(part_, error))
      throw SetupError(
          fmt::format("cannot write '{}': {}", folder_.string(), error ? error.message() : "it cannot be created"));
  }
  ~PartFolder() {
    std::error_code error;
    if (!done_) fs::remove_all(part_, error);
  }
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return part_; }
  void commit() {
    std::error_code error;
    fs::rename(part_, folder_, error);
    if (error) throw SetupError(fmt::format("cannot write '{}': {}", folder_.string(), error.message()));
    done_ = true;
  }

 private:
  fs::path folder_, part_;
  bool done_ = false;
};

}  // namespace

Rosbag2Summary write_rosbag2(const McapReader& recording, const fs::path& folder) {
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();  // "bag/" is "bag"
  PartFolder part(named);
  const std::string file_name = named.filename().string() + "_0.mcap";
  BagWriter bag(part.path() / file_name);
  with_context(recording.file().string(), [&] { convert(recording, bag); });
  bag.close();
  files::write_file(part.path() / "metadata.yaml", bag.metadata(file_name));
  part.commit();
  return bag.summary();
}

}  // namespace murosimf::recording
