#include "murosimf/recording/recorded_series.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <map>

#include <fmt/format.h>

#include "murosimf/logging/log_plot.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/mcap/byte_string.h"
#include "murosimf/recording/mcap/protobuf.h"

namespace murosimf::recording {
namespace {

using logging::LogSeries;

std::string without_unit(const std::string& name) { return name.substr(0, name.find(" [")); }

/// "blue1/left_knee" in the notation of logs.
std::string dotted(std::string_view frame) {
  std::string name(frame);
  std::ranges::replace(name, '/', '.');
  return name;
}

/// Collects the requested numbers.
class Gathering {
 public:
  explicit Gathering(const std::vector<std::string>& patterns) : patterns_(patterns), found_(patterns.size(), false) {}

  /// Destination of the numbers of this name; null: not requested. Its address is stable.
  LogSeries* want(const std::string& name) {
    const auto [known, is_new] = by_name_.try_emplace(name, nullptr);
    if (!is_new) return known->second;
    names_.push_back(without_unit(name));
    std::size_t first = patterns_.size();
    for (std::size_t i = patterns_.size(); i-- > 0;) {
      if (!logging::matches_name(patterns_[i], names_.back())) continue;
      found_[i] = true;
      first = i;
    }
    if (first == patterns_.size() && !patterns_.empty()) return nullptr;
    series_.push_back({.pattern = first, .series = {.names = {name}, .times = {}, .values = {}}});
    return known->second = &series_.back().series;
  }

  /// A pattern without a number is an error, since it is most likely misspelled.
  [[nodiscard]] std::vector<LogSeries> take() {
    for (std::size_t i = 0; i < patterns_.size(); ++i) {
      if (!found_[i]) throw SetupError(unknown_name("number", patterns_[i], {names_.begin(), names_.end()}));
    }
    std::ranges::stable_sort(series_, {}, &Wanted::pattern);
    std::vector<LogSeries> all;
    for (Wanted& one : series_) all.push_back(std::move(one.series));
    return all;
  }

 private:
  struct Wanted {
    std::size_t pattern = 0;  // the first that denotes it
    LogSeries series;
  };
  const std::vector<std::string>& patterns_;
  std::vector<bool> found_;
  std::map<std::string, LogSeries*> by_name_;
  std::deque<Wanted> series_;
  std::vector<std::string> names_;
};

void note(LogSeries* series, Duration time, double value) {
  if (!series) return;
  series->times.push_back(time);
  series->values.push_back(value);
}

/// Dispatches messages by topic.
class MessageNumbers {
 public:
  MessageNumbers(const McapContents& contents, const std::vector<std::string>& patterns) : gathering_(patterns) {
    for (const Channel& channel : contents.channels) channels_[channel.id] = &channel;
  }

  void take(const Message& message) {
    const Channel& channel = *channels_.at(message.channel_id);
    const Duration time(message.log_time);
    const ProtobufReader content(message.data);
    if (channel.topic == "/tf") return take_transforms(content, time);
    if (channel.topic == "/joints") return take_joints(content, time, channel, false);
    if (channel.topic == "/targets") return take_joints(content, time, channel, true);
    if (channel.topic.starts_with("/sensors/")) take_sample(content, channel);
  }
  [[nodiscard]] std::vector<LogSeries> all() { return gathering_.take(); }

 private:
  using Axes = std::array<LogSeries*, 3>;
  using Joint = std::array<LogSeries*, 3>;  // position, velocity, torque; or the target

  template <class T, class Make>
  static const T& remembered(std::map<std::string, T, std::less<>>& known, std::string_view key, const Make& make) {
    const auto found = known.find(key);
    return found != known.end() ? found->second : known.emplace(std::string(key), make()).first->second;
  }

  void take_transforms(ProtobufReader in, Duration time) {
    poses_.clear();
    while (in.next()) {
      if (in.field() == 1) take_transform(in.message(), time);
    }
  }

  void take_transform(ProtobufReader in, Duration time) {
    std::string_view parent, child;
    Transformd pose;
    while (in.next()) {
      if (in.field() == 2) parent = in.bytes();
      if (in.field() == 3) child = in.bytes();
      if (in.field() == 4) pose.position = read_vector(in.message());
      if (in.field() == 5) pose.orientation = read_rotation(in.message());
    }
    const auto outer = poses_.find(parent);  // parents are written first
    if (outer != poses_.end()) pose = outer->second * pose;
    poses_.emplace(child, pose);
    const Axes& axes = remembered(axes_, child, [&] {
      const std::string name = dotted(child) + ".position.";
      return Axes{gathering_.want(name + "x [m]"), gathering_.want(name + "y [m]"), gathering_.want(name + "z [m]")};
    });
    note(axes[0], time, pose.position.x);
    note(axes[1], time, pose.position.y);
    note(axes[2], time, pose.position.z);
  }

  void take_joints(ProtobufReader in, Duration time, const Channel& channel, bool targets) {
    while (in.next()) {
      if (in.field() == 2) take_joint(in.message(), time, channel, targets);
    }
  }

  /// The name comes before the numbers, as the writer writes it.
  void take_joint(ProtobufReader in, Duration time, const Channel& channel, bool target) {
    const Joint* joint = nullptr;
    while (in.next()) {
      if (in.field() == 1) joint = &series_of_joint(in.bytes(), channel, target);
      if (!joint) continue;
      if (in.field() == 2) note((*joint)[0], time, in.number());
      if (in.field() == 3) note((*joint)[1], time, in.number());
      if (in.field() == 5) note((*joint)[2], time, in.number());
    }
  }

  const Joint& series_of_joint(std::string_view frame, const Channel& channel, bool target) {
    return remembered(target ? targets_ : joints_, frame, [&] {
      const std::string name = dotted(frame);
      const bool prismatic = channel.metadata.contains(std::string(frame));
      const std::string_view unit = prismatic ? "m" : "rad";
      if (target) return Joint{gathering_.want(fmt::format("{}.joint_target [{}]", name, unit)), nullptr, nullptr};
      return Joint{gathering_.want(fmt::format("{}.joint_position [{}]", name, unit)),
                   gathering_.want(fmt::format("{}.joint_velocity [{}/s]", name, unit)),
                   gathering_.want(fmt::format("{}.joint_torque [{}]", name, prismatic ? "N" : "N m"))};
    });
  }

  /// Fields with the value zero are missing in the message.
  void take_sample(ProtobufReader in, const Channel& channel) {
    const auto& fields = remembered(sensors_, channel.topic, [&] { return fields_of(channel); });
    std::map<int, std::vector<double>> values;
    Duration taken{};
    while (in.next()) {
      if (in.field() == 1) taken = read_time(in.message());
      const auto field = fields.find(in.field());
      if (field == fields.end()) continue;
      if (field->second.size() == 1) {
        values[in.field()] = {in.number()};
      } else {
        ByteReader numbers(in.bytes());
        while (!numbers.left().empty()) {
          values[in.field()].push_back(std::bit_cast<double>(numbers.number<std::uint64_t>()));
        }
      }
    }
    for (const auto& [number, series] : fields) {
      std::vector<double>& all = values[number];
      all.resize(series.size());
      for (std::size_t i = 0; i < series.size(); ++i) note(series[i], taken, all[i]);
    }
  }

  /// By number of the field: "/sensors/blue1/imu" and "gyroscope.x [rad/s]" make "blue1.imu.gyroscope.x [rad/s]".
  std::map<int, std::vector<LogSeries*>> fields_of(const Channel& channel) {
    std::map<int, std::vector<LogSeries*>> fields;
    const std::string sensor = dotted(std::string_view(channel.topic).substr(9));
    std::map<int, std::string> names_of_fields;  // sorted by number, which is the order of the sensor's outputs
    for (const auto& [key, names] : channel.metadata) {
      const int number = std::atoi(key.c_str());  // 0: it is no number, but a constant of an output
      if (number > 0) names_of_fields[number] = names;
    }
    for (const auto& [number, names] : names_of_fields) {
      std::vector<LogSeries*>& series = fields[number];
      for (std::size_t begin = 0; begin <= names.size();) {
        const std::size_t end = std::min(names.find('\n', begin), names.size());
        series.push_back(gathering_.want(sensor + "." + names.substr(begin, end - begin)));
        begin = end + 1;
      }
    }
    return fields;
  }

  Gathering gathering_;
  std::map<std::uint16_t, const Channel*> channels_;
  std::map<std::string, Transformd, std::less<>> poses_;  // of the present message
  std::map<std::string, Axes, std::less<>> axes_;
  std::map<std::string, Joint, std::less<>> joints_, targets_;
  std::map<std::string, std::map<int, std::vector<LogSeries*>>, std::less<>> sensors_;
};

}  // namespace

bool is_recording(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown))
    return false;  // opening a pipe would block until there is a writer
  std::string begin(mcap_magic.size(), '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin == mcap_magic;
}

/// Chunk by chunk: recordings may be larger than the memory.
std::vector<LogSeries> series_of(const McapReader& recording, const std::vector<std::string>& patterns) {
  MessageNumbers numbers(recording.contents(), patterns);
  for (const ChunkIndex& chunk : recording.contents().chunks) {
    recording.visit_messages(chunk, [&](const Message& message) { numbers.take(message); });
  }
  return with_context(recording.file().string(), [&] { return numbers.all(); });
}

/// Series have times of their own: each becomes a column with gaps.
files::CsvTable table_of(const std::vector<LogSeries>& series) {
  files::CsvTable table{.time = "time [s]", .columns = {}};
  for (const LogSeries& one : series) {
    MUROSIMF_ASSERT(one.names.size() == 1 && one.times.size() == one.values.size());
    const std::string& name = one.names.front();
    files::CsvColumn column{.name = without_unit(name), .unit = {}, .times = {}, .values = one.values};
    if (const auto unit = name.find(" ["); unit != std::string::npos) {
      column.unit = name.substr(unit + 2, name.size() - unit - 3);
    }
    for (const Duration time : one.times) column.times.push_back(static_cast<double>(time.count()) / 1e9);
    table.columns.push_back(std::move(column));
  }
  return table;
}

}  // namespace murosimf::recording
