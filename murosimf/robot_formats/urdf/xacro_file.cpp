#include "murosimf/robot_formats/urdf/xacro_file.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "murosimf/files/child_process.h"
#include "murosimf/files/file_access.h"
#include "murosimf/files/input_file.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/urdf/package_folders.h"
#include "murosimf/robot_formats/urdf/urdf_reader.h"

namespace murosimf::robot_formats::urdf {
namespace {

namespace fs = std::filesystem;

// Exit codes of the script below.
constexpr int package_is_missing = 3, xacro_is_missing = 4;

/// Standard input: name and folder of each known package, a line each. Arguments: the file, then name:=value.
constexpr const char* script = R"(
import sys
sys.path = [folder for folder in sys.path if folder]  # not the folder where the command runs: it may be the robot's
import types
try:
    import xacro
except ImportError as error:
    sys.stderr.write(str(error))
    sys.exit(4)
lines = sys.stdin.read().split("\n")
known = dict(zip(lines[0::2], lines[1::2]))
class Missing(BaseException):
    pass
def find(name):
    if name not in known:
        raise Missing(name)
    return known[name]
packages = types.ModuleType("ament_index_python.packages")
packages.get_package_share_directory = find
sys.modules["ament_index_python"] = types.ModuleType("ament_index_python")
sys.modules["ament_index_python.packages"] = packages
try:
    text = xacro.process_file(sys.argv[1], mappings=dict(a.split(":=", 1) for a in sys.argv[2:])).toprettyxml(indent=" ")
except Missing as missing:
    sys.stdout.write(str(missing))
    sys.exit(3)
except Exception as error:
    sys.stderr.write("%s: %s" % (type(error).__name__, error))
    sys.exit(5)
sys.stdout.buffer.write(text.encode())
)";

std::string lines_of(const std::map<std::string, fs::path>& packages) {
  std::string text;
  for (const auto& [name, folder] : packages) text += fmt::format("{}\n{}\n", name, folder.string());
  return text;
}

/// The nearest existing folder of the package.
fs::path folder_of(const fs::path& file, const std::string& package, PackageFolders& packages) {
  std::error_code error;
  for (const fs::path& folder : packages.folders_of(package)) {
    if (fs::is_directory(folder, error)) return folder;
  }
  throw SetupError(files::one_line(fmt::format(
      "{}: there is no package '{}' of $(find {}); put its folder above the file or into MUROSIMF_PACKAGE_PATH",
      file.string(), package, package)));
}

std::vector<std::string> command_of(const fs::path& file, const robot_formats::ReaderOptions& options) {
  std::vector<std::string> command{"python3", "-c", script, fs::absolute(file).string()};
  for (const auto& [name, value] : options.xacro) command.push_back(fmt::format("{}:={}", name, value));
  return command;
}

[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw SetupError(files::one_line(fmt::format("{}: {}", file.string(), why)));
}

}  // namespace

std::string expand_xacro(const fs::path& file, const robot_formats::ReaderOptions& options) {
  if (files::reads_are_limited()) {
    fail(file,
         "a file with macros starts the program xacro, which is not done for a scene that comes over a network; "
         "expand it first: xacro robot.xacro > robot.urdf");
  }
  files::check_input_file(file, files::most_xml_bytes);
  PackageFolders packages(fs::absolute(file).lexically_normal().parent_path(), options.packages, options.search_paths);
  const std::vector<std::string> command = command_of(file, options);
  // Each run reports one missing package: the script cannot ask back.
  for (std::map<std::string, fs::path> known;;) {
    const auto result = files::run_process(command, lines_of(known));
    if (!result || result->exit_code == xacro_is_missing) {
      fail(file, "it has macros, for which python3 with the package xacro is needed: pip install xacro");
    }
    if (result->exit_code == 0) return result->output;
    const std::string& package = result->output;
    if (result->exit_code != package_is_missing || known.contains(package)) {
      fail(file, "xacro gives up: " +
                     (result->errors.empty() ? fmt::format("exit code {}", result->exit_code) : result->errors));
    }
    MUROSIMF_ASSERT(!known.contains(package));
    known[package] = folder_of(file, package, packages);
  }
}

robot_formats::RobotDescription read_xacro(const fs::path& file, const robot_formats::ReaderOptions& options) {
  return read_urdf_text(file, expand_xacro(file, options), options);
}

}  // namespace murosimf::robot_formats::urdf
