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

using Materials = std::map<std::string, MeshMaterial, std::less<>>;

double share(files::TextLines& lines, std::string_view what) { return std::clamp(lines.number(what), 0.0, 1.0); }

/// The file of a picture: the rest of the line, without options, which stand in front of it.
std::string read_picture(files::TextLines& lines, const std::filesystem::path& file, std::vector<std::string>& notes) {
  std::string name;
  bool options = false;
  for (auto word = lines.word(); !word.empty(); word = lines.word()) {
    options = options || word.front() == '-';
    if (!name.empty() && !options) name += ' ';  // of a name with spaces
    if (options) name.clear();
    name += word;
  }
  if (options) notes.push_back(fmt::format("{}: options of map_Kd have no effect", file.string()));
  return name;
}

/// Throws SetupError.
void read_mtl(const std::filesystem::path& file, Materials& materials, std::vector<std::string>& notes) {
  (void)files::check_input_file(file, most_bytes);
  files::TextLines lines(file);
  MeshMaterial* material = nullptr;
  bool has_color = false;
  while (lines.next()) {
    const std::string word(lines.word());
    if (word == "newmtl") {
      const std::string name(lines.word());
      has_color = false;
      material = &materials.emplace(name, MeshMaterial{.name = name}).first->second;
    }
    if (!material) continue;
    Color& color = material->color ? *material->color : material->color.emplace();
    if (word == "Kd") {
      has_color = true;
      // in the order of the numbers in the line
      const double red = share(lines, word), green = share(lines, word), blue = share(lines, word);
      color = {red, green, blue, color.alpha};
    }
    if (word == "d") color.alpha = share(lines, word);
    if (word == "Tr") color.alpha = 1 - share(lines, word);
    if (word == "map_Kd") {
      material->picture = read_picture(lines, file, notes);
      if (!has_color) color = {1, 1, 1, color.alpha};
    }
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
  Materials materials;
  try {
    for (const std::string& name : libraries_of(file)) {
      if (lies_beside(name)) {
        read_mtl(file.parent_path() / name, materials, notes);
      } else {
        notes.push_back(fmt::format("{}: the materials of {} are not read: it is no .mtl file beside it", file.string(),
                                    files::quoted(name)));
      }
    }
  } catch (const SetupError& error) {
    notes.emplace_back(error.what());
  }
  for (MeshMaterial& material : mesh.materials) {
    if (const auto found = materials.find(material.name); found != materials.end()) material = found->second;
  }
  notes.erase(std::unique(notes.begin(), notes.end()), notes.end());
  return notes;
}

}  // namespace murosimf::robot_formats::mesh
