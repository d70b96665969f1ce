#include "murosimf/robot/motion_file.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "murosimf/files/data_path.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::robot {
namespace {

using locomotion::Channel;
using locomotion::KeyframeMotion;

Channel read_channel(const toml::node& node, std::set<std::string>& seen) {
  if (!node.is_string() || node.as_string()->get().empty()) {
    files::fail_at(node.source(), "a column is the name of a joint or of a foot's axis, or a list of names");
  }
  // A minus sign reverses the channel: mirrored joints share a column.
  const std::string& text = node.as_string()->get();
  Channel channel = text[0] == '-' ? Channel{text.substr(1), -1} : Channel{text, 1};
  if (!seen.insert(channel.name).second) files::fail_at(node.source(), fmt::format("'{}' is set twice", channel.name));
  return channel;
}

void read_columns(const files::TomlTable& table, KeyframeMotion& motion) {
  const toml::node* node = table.find("columns");
  const toml::array* columns = node ? node->as_array() : nullptr;
  if (!columns || columns->empty()) {
    throw SetupError(fmt::format("{}: 'columns' must list what the values of a key frame set", table.where("columns")));
  }
  std::set<std::string> seen;  // a channel in two columns would have two values
  for (const toml::node& column : *columns) {
    auto& channels = motion.columns.emplace_back();
    if (const toml::array* several = column.as_array()) {
      for (const toml::node& one : *several) channels.push_back(read_channel(one, seen));
    } else {
      channels.push_back(read_channel(column, seen));
    }
  }
}

std::vector<double> read_values(const files::TomlTable& table, std::string_view key, std::size_t count) {
  const toml::node* node = table.find(key);
  const auto numbers = node && node->is_array() ? files::numbers_of(*node) : std::nullopt;
  if (!numbers || numbers->size() != count) {
    throw SetupError(fmt::format("{}: '{}' must be {} number{} in brackets, one per column", table.where(key), key,
                                 count, count == 1 ? "" : "s"));
  }
  for (const double number : *numbers) {
    if (!std::isfinite(number)) throw SetupError(fmt::format("{}: '{}' must be finite numbers", table.where(key), key));
  }
  return *numbers;
}

/// kick = {ball = [X, Y], direction = RAD}
locomotion::Kick read_kick(const toml::table& node) {
  const files::TomlTable table(node, {"ball", "direction"});
  constexpr double farthest = 10;  // [m]
  const toml::node* ball = table.find("ball");
  const auto place = ball && ball->is_array() ? files::numbers_of(*ball) : std::nullopt;
  // Bounds in which a ball can be reached; a foot on the middle line would have no side.
  const auto near = [](double x) { return std::abs(x) <= farthest; };
  if (!place || place->size() != 2 || !std::ranges::all_of(*place, near) || (*place)[1] == 0) {
    throw SetupError(
        fmt::format("{}: 'ball' must be where the ball lies, [x, y] in m, on the side of the foot that kicks",
                    table.where("ball")));
  }
  locomotion::Kick kick{.ball = {(*place)[0], (*place)[1], 0}};
  table.read("direction", kick.direction);
  if (!(std::abs(kick.direction) <= pi))
    throw SetupError(fmt::format("{}: 'direction' must be from -pi to pi", table.where("direction")));
  return kick;
}

std::filesystem::path beside_or_named(const std::string& name, const std::filesystem::path& file) {
  const auto beside = files::look_for_data_file((file.parent_path() / name).string(), "motions", ".toml");
  return beside ? *beside : find_motion(name, file.parent_path());
}

/// A file with `mirror_of` as its only key.
KeyframeMotion read_mirrored(const toml::table& document, const std::filesystem::path& file) {
  const files::TomlTable table(document, {"mirror_of"});
  std::string name;
  table.read("mirror_of", name);
  const std::string where = table.where("mirror_of");
  if (name.empty()) throw SetupError(where + ": 'mirror_of' must name a motion");
  const auto original = with_context(where, [&] { return beside_or_named(name, file); });
  if (files::parse_toml_file(original).contains("mirror_of")) {
    // A chain of images would hide which side the values are for.
    throw SetupError(fmt::format("{}: '{}' is a mirror image itself; name what it is an image of", where, name));
  }
  KeyframeMotion motion = with_context(where, [&] { return read_motion(original); });
  motion.name = file.stem().string();
  motion.other_side = true;
  return motion;
}

}  // namespace

std::filesystem::path find_motion(std::string_view name, const std::filesystem::path& beside) {
  // A scene may have the name of the motion that it shows: a bare name is only searched for in folders `motions`.
  const std::string place = name.ends_with(".toml") ? std::string(name) : fmt::format("motions/{}", name);
  if (const auto file = files::look_for_data_file(place, "motions", ".toml", beside)) return *file;
  const auto names = files::data_file_names("motions", ".toml");
  throw SetupError(unknown_name("motion", name, {names.begin(), names.end()}));
}

KeyframeMotion read_motion(const std::filesystem::path& file) {
  const toml::table document = files::parse_toml_file(file);
  if (document.contains("mirror_of")) return read_mirrored(document, file);
  const files::TomlTable table(document, {"columns", "start", "frames", "kick"});
  KeyframeMotion motion;
  motion.name = file.stem().string();
  read_columns(table, motion);
  const std::size_t count = motion.columns.size();
  motion.start = read_values(table, "start", count);
  for (const toml::table* node : table.tables("frames")) {
    const files::TomlTable frame(*node, {"duration", "values"});
    double duration = 0;
    frame.read("duration", duration);
    if (!(duration > 0)) throw SetupError(fmt::format("{}: 'duration' must be positive", frame.where("duration")));
    motion.frames.push_back({duration, read_values(frame, "values", count)});
  }
  if (const toml::table* kick = table.table("kick")) motion.kick = read_kick(*kick);
  if (motion.frames.empty()) throw SetupError(fmt::format("{}: the motion has no [[frames]]", table.where("frames")));
  return motion;
  MUROSIMF_ASSERT(motion.start.size() == motion.columns.size());
}

}  // namespace murosimf::robot
