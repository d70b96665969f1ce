#include "murosimf/recording/rosbag2/rosbag2_export.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "murosimf/files/file_access.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/mcap_writer.h"
#include "murosimf/recording/recorded_run.h"
#include "murosimf/recording/robot_urdf.h"
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

/// Reliable, transient local, depth 1, in the numbers of rmw; line breaks as YAML has them in a string.
constexpr std::string_view kept_profile =
    R"(- history: 1\n  depth: 1\n  reliability: 1\n  durability: 1\n  deadline:\n    sec: 9223372036\n    nsec: 854775807\n)"
    R"(  lifespan:\n    sec: 9223372036\n    nsec: 854775807\n  liveliness: 1\n  liveliness_lease_duration:\n)"
    R"(    sec: 9223372036\n    nsec: 854775807\n  avoid_ros_namespace_conventions: false)";

/// With its line breaks.
std::string kept_profile_lines() {
  std::string text(kept_profile);
  for (std::size_t at = text.find("\\n"); at != std::string::npos; at = text.find("\\n")) text.replace(at, 2, "\n");
  return text;
}

class BagWriter {
 public:
  explicit BagWriter(const fs::path& file) : file_(file, {.library = "murosimf", .profile = "ros2"}) {}

  void write(const RosMessage& message, Duration time) {
    auto [topic, is_new] = topics_.try_emplace(message.topic);
    if (is_new)
      topic->second = {.type = message.type, .channel = channel_of(message), .messages = 0, .kept = message.kept};
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
          "        offered_qos_profiles: \"{}\"\n"
          "      message_count: {}\n",
          name, full_type(topic.type), topic.kept ? kept_profile : "", topic.messages);
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
    bool kept = false;
  };
  std::uint16_t channel_of(const RosMessage& message) {
    const std::string type = full_type(message.type);
    auto [schema, is_new] = schemas_.try_emplace(type, std::uint16_t{0});
    if (is_new) schema->second = file_.add_schema(type, "ros2msg", ros_definition(message.type));
    return file_.add_channel(message.topic, "cdr", schema->second,
                             {{"offered_qos_profiles", message.kept ? kept_profile_lines() : ""}});
  }

  McapWriter file_;
  std::map<std::string, Topic> topics_;
  std::map<std::string, std::uint16_t> schemas_;
  std::uint64_t messages_ = 0;
  Duration begin_{}, end_{};
};

/// At the first instant: a bag is played from there.
void describe(const std::vector<RobotDescription>& robots, Duration begin, BagWriter& bag) {
  for (const RobotDescription& one : robots) bag.write(ros_description(one.robot, one.urdf), begin);
}

void convert(const McapReader& recording, const std::vector<RobotDescription>& robots, BagWriter& bag) {
  std::map<std::uint16_t, Channel> channels;
  for (const Channel& channel : recording.contents().channels) {
    if (RosMessages::converts(channel)) channels.emplace(channel.id, channel);
  }
  FrameNames names;
  for (const RobotDescription& one : robots) names.merge(frames_by_links(one.robot, one.urdf));
  RosMessages messages(std::move(names));
  for (const ChunkIndex& chunk : recording.contents().chunks) {
    if (!has_any(chunk, channels)) continue;
    recording.visit_messages(chunk, [&](const Message& message) {
      const auto channel = channels.find(message.channel_id);
      if (channel == channels.end()) return;
      const Duration time = time_of(message);
      const std::vector<RosMessage> all = messages.of(channel->second, message.data, time);
      if (!all.empty() && bag.summary().messages == 0) describe(robots, time, bag);
      for (const RosMessage& one : all) bag.write(one, time);
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

std::vector<RobotDescription> recorded_descriptions(const fs::path& recording, std::vector<std::string>& why) {
  std::vector<RobotDescription> all;
  const auto attempt = [&](const std::string& what, const auto& call) {
    try {
      call();
    } catch (const SetupError& error) {
      why.push_back(fmt::format("{}: {}", what, error.what()));
    }
  };
  attempt("the bag has no robot_description", [&] {
    const RecordedRun run(recording);
    const files::FileScope scope(run.access());
    const auto scene = run.build_to_show({});
    if (!run.additions().empty()) {
      run.initialize(*scene);
      run.add_all(*scene);
    }
    for (const Entity* robot : scene->parts().robots) {
      attempt(fmt::format("the bag has no robot_description of {}", robot->name()), [&] {
        all.push_back({robot->name(), urdf_of(*scene, *robot)});
      });
    }
  });
  return all;
}

Rosbag2Summary write_rosbag2(const McapReader& recording, const fs::path& folder,
                             const std::vector<RobotDescription>& descriptions) {
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();  // "bag/" is "bag"
  PartFolder part(named);
  const std::string file_name = named.filename().string() + "_0.mcap";
  BagWriter bag(part.path() / file_name);
  with_context(recording.file().string(), [&] { convert(recording, descriptions, bag); });
  bag.close();
  files::write_file(part.path() / "metadata.yaml", bag.metadata(file_name));
  part.commit();
  return bag.summary();
}

}  // namespace murosimf::recording
