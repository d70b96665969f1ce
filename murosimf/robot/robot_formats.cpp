#include "murosimf/robot/robot_formats.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/files/lower_case.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_reader.h"
#include "murosimf/robot_formats/mjcf/mjcf_schema.h"
#include "murosimf/robot_formats/proto/proto_reader.h"
#include "murosimf/robot_formats/sdf/sdf_reader.h"
#include "murosimf/robot_formats/sdf/sdf_schema.h"
#include "murosimf/robot_formats/urdf/gazebo_schema.h"
#include "murosimf/robot_formats/urdf/urdf_reader.h"
#include "murosimf/robot_formats/urdf/xacro_file.h"

namespace murosimf::robot {
namespace {

std::vector<RobotFormat> built_in_formats() {
  return {
      RobotFormat{"mjcf", "the format of MuJoCo", ".xml", "mujoco", robot_formats::mjcf::read_mjcf,
                  robot_formats::mjcf::mjcf_schema},
      RobotFormat{"urdf", "the format of ROS, with gazebo blocks", ".urdf .xml", "robot",
                  robot_formats::urdf::read_urdf, robot_formats::urdf::urdf_words},
      RobotFormat{"sdf", "the format of Gazebo, models and worlds", ".sdf .world", "sdf", robot_formats::sdf::read_sdf,
                  robot_formats::sdf::sdf_schema},
      RobotFormat{"xacro", "URDF with macros, by the program xacro", ".xacro", "", robot_formats::urdf::read_xacro},
      RobotFormat{"proto", "PROTO files of Webots, and worlds with one robot", ".proto .wbt", "",
                  robot_formats::proto::read_proto},
  };
}

/// ".urdf" of "nao.URDF"
std::string ending_of(const std::filesystem::path& file) { return files::lower_case(file.extension().string()); }

bool has_ending(const RobotFormat& format, const std::string& ending) {
  return !ending.empty() && fmt::format(" {} ", format.endings).find(fmt::format(" {} ", ending)) != std::string::npos;
}

/// "mjcf (<mujoco>), lump (.lump)"
std::string known_formats() {
  std::vector<std::string> all;
  for (const RobotFormat& format : robot_formats()) {
    all.push_back(fmt::format("{} ({})", format.name, format.root.empty() ? format.endings : "<" + format.root + ">"));
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

/// A file that is no XML and has an unknown extension is probably of a format that is not registered.
std::unique_ptr<files::XmlFile> open_xml(const std::filesystem::path& file, const std::string& ending) {
  try {
    return std::make_unique<files::XmlFile>(file);
  } catch (const SetupError& error) {
    const auto& all = robot_formats();
    const bool known =
        std::any_of(all.begin(), all.end(), [&](const auto& format) { return has_ending(format, ending); });
    std::error_code none;
    if (known || ending.empty() || !std::filesystem::is_regular_file(file, none)) throw;
    throw SetupError(fmt::format("{}; or is its format unknown? known: {}", error.what(), known_formats()));
  }
}

}  // namespace

Registry<RobotFormat>& robot_format_registry() {
  static Registry<RobotFormat> registry("format of robot files", built_in_formats());
  return registry;
}

const Registry<RobotFormat>& robot_formats() { return robot_format_registry(); }

const RobotFormat& format_of(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  for (const RobotFormat& format : robot_formats()) {
    // By extension first: only XML files have to be opened.
    if (format.root.empty() && has_ending(format, ending)) return format;
  }
  const auto xml = open_xml(file, ending);
  const std::string root = xml->root().tag();
  for (const RobotFormat& format : robot_formats()) {
    if (!format.root.empty() && format.root == root) return format;
  }
  xml->root().fail(fmt::format("unknown format of a robot file: its root is <{}>; known: {}", root, known_formats()));
}

robot_formats::RobotDescription read_description(const std::filesystem::path& file,
                                                 const robot_formats::ReaderOptions& options) {
  const RobotFormat& format = format_of(file);
  if (!options.xacro.empty() && format.name != "xacro") {
    throw SetupError(fmt::format("{}: arguments of xacro mean nothing here: it is no .xacro file", file.string()));
  }
  if (!options.body.empty() && format.name != "mjcf") {
    throw SetupError(
        fmt::format("{}: there is one robot in a file of this kind; body = \"{}\" chooses among those of MJCF files",
                    file.string(), options.body));
  }
  return format.read(file, options);
}

}  // namespace murosimf::robot
