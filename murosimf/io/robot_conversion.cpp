#include "murosimf/io/robot_conversion.h"

#include <fstream>
#include <sstream>

#include "murosimf/io/mjcf_reader.h"
#include "murosimf/io/mjcf_writer.h"
#include "murosimf/io/robot_reader.h"
#include "murosimf/io/robot_table.h"
#include "murosimf/io/servo_stub.h"
#include "murosimf/io/urdf_reader.h"
#include "murosimf/io/xml_element.h"

namespace murosimf::io {
namespace {

namespace fs = std::filesystem;

/// With all of the bodies of the file: read_robot has welded those that do not move.
RobotDraft read_all_bodies(const fs::path& file, ReaderOptions options) {
  for (const TableName& mesh : read_table_beside(file).part_per_group) options.part_per_group.push_back(mesh.name);
  const bool urdf = XmlFile(file).root().tag() == "robot";
  return urdf ? read_urdf(file, options) : read_mjcf(file, options);
}

std::string text_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void count(const RobotDraft& draft, RobotConversion& result) {
  result.bodies = static_cast<int>(draft.bodies.size());
  for (const DraftBody& body : draft.bodies) {
    result.joints += static_cast<int>(body.joints.size());
    result.mass += body.solid.mass;
  }
}

}  // namespace

RobotConversion convert_robot(const fs::path& file, const ConversionOptions& options) {
  RobotConversion result;
  result.warnings = read_robot(file, options.reader).warnings;  // whether it is a robot at all
  RobotDraft draft = read_all_bodies(file, options.reader);
  if (options.fit) result.fits = fit_meshes(draft, *options.fit);
  count(draft, result);
  result.mjcf = to_mjcf(draft, {options.folder});
  fs::path table = file;
  table.replace_extension(".toml");
  result.own_table = fs::exists(table);
  result.toml = result.own_table ? text_of(table) : servo_stub(draft);
  return result;
}

}  // namespace murosimf::io
