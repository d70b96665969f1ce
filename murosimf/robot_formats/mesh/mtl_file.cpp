#include "murosimf/robot_formats/mesh/mtl_file.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/lower_case.h"
#include "murosimf/files/text_lines.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats::mesh {
namespace {

constexpr std::uintmax_t most_bytes = 16'000'000;

using Colors = std::map<std::string, Color, std::less<>>;

double share(files::TextLines& lines, std::string_view what) { return std::clamp(lines.number(what), 0.0, 1.0); }

/// Throws SetupError.
void read_mtl(const std::filesystem::path& file, Colors& colors, std::vector<std::string>& notes) {
  (void)files::check_input_file(file, most_bytes);
  files::TextLines lines(file);
  Color* color = nullptr;
  while (lines.next()) {
    const std::string word(lines.word());
    if (word == "newmtl") color = &colors.emplace(lines.word(), Color{}).first->second;
    if (!color) continue;
    if (word == "Kd") {
      // in the order of the numbers in the line
      const double red = share(lines, word), green = share(lines, word), blue = share(lines, word);
      *color = {red, green, blue, color->alpha};
    }
    if (word == "d") color->alpha = share(lines, word);
    if (word == "Tr") color->alpha = 1 - share(lines, word);
    if (word == "map_Kd") notes.push_back(fmt::format("{}: textures of meshes are not drawn", file.string()));
  }
}

/// Names after `mtllib`, before the first face.
std::vector<std::string> libraries_of(const std::filesystem::path& file) {
  std::vector<std::string> names;
  files::TextLines lines(file, true);
  while (lines.next()) {
    const std::string_view word = lines.word();
    if (word == "f") break;
    if (word != "mtllib") continue;
    for (auto name = lines.word(); !name.empty(); name = lines.word()) names.emplace_back(name);
  }
  return names;
}

bool lies_beside(const std::string& name) {
  const std::filesystem::path path(name);
  return path.filename() == path.lexically_normal() && files::lower_case(path.extension().string()) == ".mtl";
}

}  // namespace

std::vector<std::string> add_mtl_colors(const std::filesystem::path& file, MeshFile& mesh) {
  std::vector<std::string> notes;
  if (mesh.materials.empty() || files::lower_case(file.extension().string()) != ".obj") return notes;
  Colors colors;
  try {
    for (const std::string& name : libraries_of(file)) {
      if (lies_beside(name)) {
        read_mtl(file.parent_path() / name, colors, notes);
      } else {
        notes.push_back(fmt::format("{}: the materials of {} are not read: it is no .mtl file beside it", file.string(),
                                    files::quoted(name)));
      }
    }
  } catch (const SetupError& error) {
    notes.emplace_back(error.what());
  }
  for (MeshMaterial& material : mesh.materials) {
    if (const auto found = colors.find(material.name); found != colors.end()) material.color = found->second;
  }
  notes.erase(std::unique(notes.begin(), notes.end()), notes.end());
  return notes;
}

}  // namespace murosimf::robot_formats::mesh
