// `murosimf convert`: writes a robot file as MJCF or URDF in our normal form, and a TOML file beside it.
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/files/data_path.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/input_file.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/robot_conversion.h"

namespace murosimf::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_copied_bytes = 100'000'000;

struct ConvertOptions {
  std::string model;
  std::string out;  ///< MJCF or URDF file to write: the ending decides
  std::string fit;  ///< sphere, capsule, cylinder, box or best; empty: meshes stay meshes
  bool lenient = false;
  std::vector<std::string> xacro;    ///< name:=value
  std::string body;                  ///< of the robot, if the file has several
  bool force = false;                ///< replace the file
  std::vector<std::string> plugins;  ///< sensors of the robot may come from there
};

void define(const Command& command, ConvertOptions& options) {
  command
      .add("model", options.model,
           "Robot file ('murosimf list formats'), or the name of one that comes with the program")
      .required()
      .offers_list("models");
  command.add("--out", options.out, "File to write: MJCF (.xml) or URDF (.urdf)").required();
  command.add("--fit", options.fit,
              "Put a primitive of the same volume in the place of each mesh that collides: sphere, capsule, cylinder, "
              "box or best");
  add_lenient(command, options.lenient);
  add_xacro(command, options.xacro);
  add_body(command, options.body);
  command.add("--force", options.force, "Replace the file if it is there");
  add_plugins(command, options.plugins);
}

bool is_file(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error) && !fs::is_directory(file, error);
}

[[noreturn]] void refuse_replacement(const fs::path& file) {
  throw SetupError(fmt::format("'{}' is there already; --force replaces it", file.string()));
}

void check_output(const fs::path& in, const fs::path& out, bool force) {
  if (out.extension() != ".xml" && out.extension() != ".urdf") {
    throw SetupError(
        fmt::format("--out '{}': the name must end in .xml (MJCF) or .urdf; a .toml file will stand beside it",
                    out.string()));
  }
  files::note_input(in);
  files::claim_output("--out", out);
  if (is_file(out) && !force) refuse_replacement(out);
}

std::string fits_text(const std::vector<robot::MeshFit>& fits) {
  std::string text;
  for (const robot::MeshFit& fit : fits) {
    text += fmt::format("  {}: mesh {} becomes a {}, {:.0f} % of the volume in common\n", fit.body, fit.mesh, fit.shape,
                        100 * fit.overlap);
  }
  return text;
}

/// What the TOML file names: motions, the table of steps, servos, parts.
std::string copy_table_files(const fs::path& folder, const robot::RobotConversion& robot) {
  std::string text;
  for (const auto& [from, place] : robot.files) {
    const fs::path to = folder / place;
    std::error_code error;
    if (fs::exists(to, error)) {
      if (!fs::equivalent(from, to, error)) text += fmt::format("{}: was there, kept as it is\n", to.string());
      continue;
    }
    fs::create_directories(to.parent_path(), error);  // what keeps it from being there, write_file says
    files::claim_output("--out", to);
    files::write_file(to, files::read_input_file(from, most_copied_bytes));
    text += fmt::format("{}: copied from beside the robot file\n", to.string());
  }
  return text;
}

/// A TOML file that exists may have been edited by hand, and names files of its own: it is not overwritten.
std::string write_table(const fs::path& file, const robot::RobotConversion& robot) {
  std::error_code error;
  if (fs::exists(file, error)) return fmt::format("{}: was there, kept as it is\n", file.string());
  files::write_file(file, robot.toml);
  return fmt::format("{}: {}\n", file.string(),
                     robot.own_table ? "copied from beside the robot file"
                                     : "soles, frames and servos, partly guessed; correct it") +
         copy_table_files(file.parent_path(), robot);
}

/// Of shapes that no file holds.
void write_meshes(const fs::path& folder, const std::map<std::string, std::string>& meshes) {
  for (const auto& [name, text] : meshes) {
    const fs::path file = folder / name;
    std::error_code error;
    fs::create_directories(file.parent_path(), error);  // what keeps it from being there, write_file says
    files::claim_output("--out", file);
    files::write_file(file, text);
  }
}

std::string lines_of(const std::vector<std::string>& lines, const char* head) {
  std::string text;
  for (const std::string& line : lines) text += head + line + "\n";
  return text;
}

int convert(const ConvertOptions& options) {
  load_plugins(options.plugins);
  const fs::path in = files::find_data_file(options.model, "models", ".xml"), out = options.out;
  check_output(in, out, options.force);
  robot::ConversionOptions conversion{.folder = out.parent_path(),
                                      .reader = {.lenient = options.lenient,
                                                 .xacro = xacro_values(options.xacro),
                                                 .body = options.body}};
  if (out.extension() == ".urdf") conversion.format = robot::WrittenFormat::urdf;
  conversion.mesh_folder = out.stem().string() + "_meshes";
  if (!options.fit.empty()) conversion.fit = with_context("--fit", [&] { return robot::primitive_kind(options.fit); });
  const robot::RobotConversion robot = robot::convert_robot(in, conversion);
  for (const auto& [name, mesh] : robot.meshes) {
    if (is_file(out.parent_path() / name) && !options.force) refuse_replacement(out.parent_path() / name);
  }
  write_meshes(out.parent_path(), robot.meshes);
  files::write_file(out, robot.text);
  std::string text =
      fmt::format("{}: {} bodies, {} joints, {:.4g} kg\n", out.string(), robot.bodies, robot.joints, robot.mass);
  text += fits_text(robot.fits);
  text += write_table(fs::path(out).replace_extension(".toml"), robot);
  text += lines_of(robot.left_out, "left out: ");
  text += lines_of(robot.warnings, "warning: ");
  write_standard_output(text);
  return 0;
}

}  // namespace

void add_convert(CommandLine& line) {
  line.add<ConvertOptions>("convert", "Write a robot as one plain MJCF or URDF file, and a TOML file", define, convert);
}

}  // namespace murosimf::app
