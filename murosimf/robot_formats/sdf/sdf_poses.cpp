#include "murosimf/robot_formats/sdf/sdf_poses.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/child_process.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/sdf/sdf_program.h"

namespace murosimf::robot_formats::sdf {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw SetupError(files::one_line(fmt::format("{}: {}", file.string(), why)));
}

/// Reads a number from JSON; one that is not finite is null there.
double number(const Json& value) {
  if (!value.is_number() || !std::isfinite(value.get<double>()) || std::abs(value.get<double>()) > 1e100) {
    throw SetupError("a pose or an axis is not finite");
  }
  return value.get<double>();
}

Transformd pose(const Json& values) {
  const Quaterniond turn{number(values.at(3)), number(values.at(4)), number(values.at(5)), number(values.at(6))};
  // libsdformat normalizes; half a unit is far from both zero and one.
  if (!(turn.w * turn.w + turn.x * turn.x + turn.y * turn.y + turn.z * turn.z > 0.5)) {
    throw SetupError("a pose has a quaternion of zeros");
  }
  return {{number(values.at(0)), number(values.at(1)), number(values.at(2))}, to_matrix(normalized(turn))};
}

std::map<std::string, Transformd> poses(const Json& values) {
  std::map<std::string, Transformd> all;
  for (const auto& [name, value] : values.items()) all.emplace(name, pose(value));
  return all;
}

SdfLinkPose link(const Json& entry) {
  return {pose(entry.at("pose")), pose(entry.at("inertial")), poses(entry.at("visuals")), poses(entry.at("collisions")),
          poses(entry.at("sensors"))};
}

SdfJointPose joint(const Json& entry) {
  SdfJointPose joint{pose(entry.at("pose")), entry.at("parent"), entry.at("child"), {}, poses(entry.at("sensors"))};
  for (const Json& axis : entry.at("axes")) {
    const Vec3d direction{number(axis.at(0)), number(axis.at(1)), number(axis.at(2))};
    const double length = norm(direction);
    joint.axes.push_back(length > 1e-9 ? (1.0 / length) * direction : Vec3d{});  // zero: the reader reports it
  }
  return joint;
}

SdfError error(const Json& entry, const fs::path& file) {
  const std::string name = entry.at("file");
  const int line = entry.at("line");
  const bool is_main = name.empty() || fs::path(name) == fs::absolute(file).lexically_normal();
  const std::string where = is_main ? file.string() : name;
  return {entry.at("kind"), line > 0 ? fmt::format("{}:{}", where, line) : "", entry.at("message")};
}

SdfPoses parse(const std::string& text, const fs::path& file) {
  const Json all = Json::parse(text);
  SdfPoses poses;
  for (const auto& [name, entry] : all.at("links").items()) poses.links.emplace(name, link(entry));
  for (const auto& [name, entry] : all.at("joints").items()) poses.joints.emplace(name, joint(entry));
  for (const Json& entry : all.at("frames")) {
    poses.frames.push_back({entry.at("name"), entry.at("body"), pose(entry.at("pose"))});
  }
  for (const Json& entry : all.at("errors")) poses.errors.push_back(error(entry, file));
  return poses;
}

}  // namespace

SdfPoses resolve_poses(const fs::path& file, const std::string& model,
                       const std::map<std::string, fs::path>& includes) {
  Json uris = Json::object();
  for (const auto& [uri, path] : includes) uris[uri] = path.string();
  const std::string input = uris.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::string path = fs::absolute(file).lexically_normal().string();
  const auto done = files::run_process({sdf_program(file).string(), path, model}, input);
  if (!done) fail(file, "the program that reads SDF files is gone; build or install it anew");
  if (done->exit_code != 0) {
    // A crash of libsdformat ends the child process alone.
    fail(file, "libsdformat gives up: " +
                   (done->errors.empty() ? fmt::format("exit code {}", done->exit_code) : done->errors.substr(0, 300)));
  }
  try {
    return parse(done->output, file);
  } catch (const Json::exception& error) {
    fail(file, fmt::format("libsdformat makes nothing of it ({})", error.what()));
  } catch (const SetupError& error) {
    fail(file, error.what());
  }
}

Transformd seen_from(const Transformd& frame, const Transformd& inner) {
  const Mat3d back = transpose(frame.orientation);
  // The inverse of a rotation matrix is its transpose.
  return {back * (inner.position - frame.position), back * inner.orientation};
}

}  // namespace murosimf::robot_formats::sdf
