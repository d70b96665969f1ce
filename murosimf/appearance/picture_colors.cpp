#include "murosimf/appearance/picture_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/file_spelling.h"
#include "murosimf/files/input_file.h"
#include "murosimf/files/lower_case.h"
#include "murosimf/files/text_lines.h"
#include "murosimf/imaging/srgb.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/render/picture_reading.h"

namespace murosimf::appearance {
namespace {

using robot_formats::mesh::MeshMaterial;
using robot_formats::mesh::PicturePlaces;

constexpr std::uintmax_t most_bytes = 64'000'000;  // of a picture
constexpr int most_samples = 24;                   // along a side of a triangle

/// The file that a name means; nothing if it is none that may be read for this mesh.
std::optional<std::filesystem::path> file_beside(const std::filesystem::path& mesh, const std::string& name) {
  const auto address = files::path_of_address(name);
  const std::string spelled = address.value_or(name);
  std::string plain = spelled;
  std::ranges::replace(plain, '\\', '/');
  const auto path = std::filesystem::path(files::percent_decoded(plain)).lexically_normal();
  auto part = path.begin();
  if (part != path.end() && *part == "..") ++part;
  const bool near = !path.has_root_path() && part != path.end() && *part != "..";
  const std::string extension = files::lower_case(path.extension().string());
  const bool picture = extension == ".png" || extension == ".jpg" || extension == ".jpeg";
  return near && picture ? files::find_spelled(mesh.parent_path(), spelled) : std::nullopt;
}

double share_of(int number, int count) { return (number + 1.0 / 3) / count; }

/// The pixel at a place [1] along a side of `size` pixels, which repeats.
int pixel_at(double place, int size) {
  const double inside = place - std::floor(place);
  return std::clamp(static_cast<int>(inside * size), 0, size - 1);
}

/// Colors in steps of 1 / `steps`.
std::size_t make_coarser(std::vector<std::optional<Color>>& colors, int steps) {
  std::set<std::array<double, 4>> different;
  for (std::optional<Color>& color : colors) {
    if (!color) continue;
    for (double* part : {&color->red, &color->green, &color->blue}) *part = std::round(*part * steps) / steps;
    different.insert({color->red, color->green, color->blue, color->alpha});
  }
  return different.size();
}

void limit(std::vector<std::optional<Color>>& colors) {
  for (const int steps : {255, 64, 32, 16, 8, 4, 3}) {
    if (make_coarser(colors, steps) <= most_picture_colors) return;
  }
}

Color times(const Color& picture, const Color& material) {
  const auto product = [](double a, double b) {
    return imaging::srgb_of_light(imaging::light_of_srgb(a) * imaging::light_of_srgb(b));
  };
  return {product(picture.red, material.red), product(picture.green, material.green),
          product(picture.blue, material.blue), material.alpha};
}

}  // namespace

PicturePtr MeshPictures::find(const std::filesystem::path& mesh, const std::string& name,
                              std::vector<std::string>& notes) {
  const auto file = file_beside(mesh, name);
  if (!file) {
    notes.push_back(
        fmt::format("{}: the texture {} is not drawn: it is no .png or .jpg file in this folder, below or beside it",
                    mesh.string(), files::quoted(name)));
    return nullptr;
  }
  return read(*file, notes);
}

PicturePtr MeshPictures::read(const std::filesystem::path& file, std::vector<std::string>& notes) {
  const auto [known, is_new] = pictures_.try_emplace(file);
  if (is_new) {
    try {
      imaging::ColorImage picture = render::picture_of_file(files::read_input_file(file, most_bytes));
      const std::size_t pixels = picture.pixels().size();
      if (pixels > pixels_left_) throw SetupError("all textures together have too many pixels; make them smaller");
      pixels_left_ -= pixels;
      known->second = std::make_shared<const imaging::MipPicture>(imaging::mip_picture(std::move(picture)));
    } catch (const SetupError& error) {
      const std::string what = error.what();
      const std::string where = what.starts_with(file.string()) ? "" : file.string() + ": ";
      notes.push_back(fmt::format("{}{}; the mesh is drawn without it", where, what));
    }
  }
  return known->second;
}

std::vector<PicturePtr> MeshPictures::of_materials(const std::filesystem::path& mesh,
                                                   const robot_formats::mesh::MeshFile& file,
                                                   std::vector<std::string>& notes) {
  std::vector<PicturePtr> found;
  for (const MeshMaterial& material : file.materials)
    found.push_back(material.picture.empty() ? nullptr : find(mesh, material.picture, notes));
  return found;
}

Color mean_color(const imaging::ColorImage& picture, const PicturePlaces& places) {
  MUROSIMF_ASSERT(!picture.empty());
  double longest = 0;  // [px]
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &a = places[i], &b = places[(i + 1) % 3];
    const double right = double{a[0]} - double{b[0]}, up = double{a[1]} - double{b[1]};
    longest = std::max(longest, std::hypot(right * picture.width(), up * picture.height()));
  }
  const int count = static_cast<int>(std::clamp(std::ceil(longest), 1.0, double{most_samples}));
  std::array<double, 3> sum{};
  int samples = 0;
  const auto add = [&](double s, double t) {
    const auto at = [&](std::size_t k) {
      return (1 - s - t) * double{places[0][k]} + s * double{places[1][k]} + t * double{places[2][k]};
    };
    const imaging::Rgb& pixel = picture(pixel_at(at(0), picture.width()), pixel_at(1 - at(1), picture.height()));
    sum[0] += imaging::light_table()[pixel.red];
    sum[1] += imaging::light_table()[pixel.green];
    sum[2] += imaging::light_table()[pixel.blue];
    ++samples;
  };
  // Middles of the small triangles into which the sides are cut: count^2, in equal shares.
  for (int i = 0; i < count; ++i) {
    for (int k = 0; i + k < count; ++k) {
      add(share_of(i, count), share_of(k, count));
      if (i + k + 1 < count) add(share_of(i, count) + 1.0 / (3 * count), share_of(k, count) + 1.0 / (3 * count));
    }
  }
  MUROSIMF_ASSERT(samples == count * count);
  const auto mean = [&](double part) { return imaging::srgb_of_light(part / samples / imaging::full_light); };
  return {mean(sum[0]), mean(sum[1]), mean(sum[2])};
}

std::vector<std::optional<Color>> picture_colors(const std::filesystem::path& mesh,
                                                 const robot_formats::mesh::MeshFile& file, MeshPictures& pictures,
                                                 std::vector<std::string>& notes) {
  const std::vector<PicturePtr> of_material = pictures.of_materials(mesh, file, notes);
  std::vector<std::optional<Color>> colors(file.mesh.triangles.size());
  const std::size_t end = std::min(colors.size(), file.material_of.size());
  for (std::size_t i = 0; i < end; ++i) {
    if (file.material_of[i] == 0) continue;
    const std::size_t material = file.material_of[i] - 1;
    MUROSIMF_ASSERT(material < of_material.size());
    if (!of_material[material]) continue;
    const PicturePlaces places = i < file.picture_places.size() ? file.picture_places[i] : PicturePlaces{};
    colors[i] = times(mean_color(of_material[material]->whole(), places),
                      file.materials[material].color.value_or(Color{1, 1, 1}));
  }
  limit(colors);
  return colors;
}

std::vector<std::optional<Color>> picture_colors(const imaging::ColorImage& picture,
                                                 const robot_formats::mesh::MeshFile& file, const Color& color) {
  std::vector<std::optional<Color>> colors;
  for (const PicturePlaces& places : file.picture_places)
    colors.emplace_back(times(mean_color(picture, places), color));
  limit(colors);
  return colors;
}

}  // namespace murosimf::appearance
