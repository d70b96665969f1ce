// Colors of triangles from the pictures of OBJ and COLLADA files.
#include "murosimf/appearance/picture_colors.h"

#include <algorithm>

#include "murosimf/imaging/srgb.h"
#include "murosimf/render/png_bytes.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"
#include "murosimf/robot_formats/mesh/mtl_file.h"
#include "tests/fixtures.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::appearance {
namespace {

using fixtures::says;
using robot_formats::mesh::MeshFile;
using robot_formats::urdf::urdf_files::write;

constexpr imaging::Rgb red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, white{255, 255, 255};

/// Red and green above, blue and white below; each of 4 x 4 pixels.
imaging::ColorImage quarters() {
  imaging::ColorImage image(8, 8);
  for (int v = 0; v < 8; ++v) {
    for (int u = 0; u < 8; ++u) image(u, v) = v < 4 ? (u < 4 ? red : green) : (u < 4 ? blue : white);
  }
  return image;
}

void expect_color(const std::optional<Color>& found, double r, double g, double b) {
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->red, r, 0.003);
  EXPECT_NEAR(found->green, g, 0.003);
  EXPECT_NEAR(found->blue, b, 0.003);
}

// Rule: of COLLADA 1.4.1 and OBJ, (0, 0) is the lower left corner of a picture.
TEST(PictureColors, AreThoseOfThePlacesOfATriangle) {
  const imaging::ColorImage image = quarters();
  expect_color(mean_color(image, {{{0.1F, 0.9F}, {0.3F, 0.9F}, {0.1F, 0.6F}}}), 1, 0, 0);
  expect_color(mean_color(image, {{{0.6F, 0.9F}, {0.9F, 0.9F}, {0.6F, 0.6F}}}), 0, 1, 0);
  expect_color(mean_color(image, {{{0.1F, 0.1F}, {0.3F, 0.1F}, {0.1F, 0.3F}}}), 0, 0, 1);
  expect_color(mean_color(image, {{{2.6F, -2.9F}, {2.9F, -2.9F}, {2.6F, -2.6F}}}), 1, 1, 1);
}

// Law: the mean is one of light, not of sRGB values; half of the light is srgb_of_light(0.5).
TEST(PictureColors, AreMeansOfLight) {
  imaging::ColorImage stripes(64, 1);
  for (int u = 0; u < 64; ++u) stripes(u, 0) = u % 2 == 0 ? white : imaging::Rgb{};
  const Color mean = mean_color(stripes, {{{0, 0}, {8, 0}, {0, 1}}});
  EXPECT_NEAR(mean.red, imaging::srgb_of_light(0.5), 0.08);
  const Color same = mean_color(imaging::ColorImage(3, 3, {120, 7, 200}), {{{0, 0}, {5, 1}, {-3, 2}}});
  expect_color(same, 120 / 255.0, 7 / 255.0, 200 / 255.0);
}

#ifdef MUROSIMF_HAS_CAIRO  // libpng comes with it

/// A tetrahedron with its faces in the four quarters of the picture, and its colors.
std::vector<std::optional<Color>> colors_of_obj(const std::string& mtl, std::vector<std::string>& notes) {
  const auto mesh =
      write("quarters.obj",
            "mtllib quarters.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0.1 0.9\nvt 0.6 0.9\nvt 0.1 0.1\nvt -0.1 0.1\n"
            "usemtl skin\nf 1/1 3/1 2/1\nf 1/2/1 2/2/1 4/2/1\nf 1/-2 4/-2 3/-2\nusemtl plain\nf 2/4 3/4 4/4\n");
  write("quarters.mtl", "newmtl skin\n" + mtl + "\nnewmtl plain\nKd 1 1 0\n");
  MeshFile file = robot_formats::mesh::read_mesh_file(mesh);
  notes = robot_formats::mesh::add_mtl_colors(mesh, file);
  MeshPictures pictures;
  return picture_colors(mesh, file, pictures, notes);
}

TEST(PictureColors, OfObjFilesAreOfTheirMtlFiles) {
  write("my skin.png", render::png_bytes(quarters()));
  std::vector<std::string> notes;
  for (const std::string name : {"my skin.png", "my%20skin.png", ".\\my skin.png"}) {
    const auto colors = colors_of_obj("map_Kd " + name, notes);
    EXPECT_TRUE(notes.empty()) << notes[0];
    ASSERT_EQ(colors.size(), 4U);
    expect_color(colors[0], 1, 0, 0);
    expect_color(colors[1], 0, 1, 0);
    expect_color(colors[2], 0, 0, 1);
    EXPECT_FALSE(colors[3]) << "its material has no picture";
  }
  const auto dark = colors_of_obj("Kd 0.5 0.5 0.5\nd 0.25\nmap_Kd -s 1 1 my%20skin.png", notes);
  expect_color(dark[0], 0.5, 0, 0);
  EXPECT_EQ(dark[0]->alpha, 0.25);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(says(notes[0], {"quarters.mtl", "options of map_Kd"})) << notes[0];
}

TEST(PictureColors, PicturesThatCannotBeReadAreNamed) {
  write("broken.png", "\x89PNG\r\n\x1a\n and no more");
  const std::vector<std::pair<std::string, std::string>> cases{
      {"broken.png", "the picture cannot be read"}, {"missing.png", "'missing.png' is not drawn"},
      {"skin.jpg", "'skin.jpg' is not drawn"},      {"../../skin.png", "'../../skin.png' is not drawn"},
      {"a/../../../b.png", "is not drawn"},         {"/etc/skin.png", "'/etc/skin.png' is not drawn"},
      {"%2e%2e/%2e%2e/skin.png", "is not drawn"},   {"file:///etc/skin.png", "is not drawn"}};
  for (const auto& [name, says_so] : cases) {
    std::vector<std::string> notes;
    const auto colors = colors_of_obj("map_Kd " + name, notes);
    EXPECT_TRUE(std::ranges::none_of(colors, [](const auto& color) { return color.has_value(); })) << name;
    ASSERT_EQ(notes.size(), 1U) << name;
    EXPECT_TRUE(says(notes[0], {says_so})) << notes[0];
    EXPECT_EQ(notes[0].find('\n'), std::string::npos);
  }
}

TEST(MeshPictures, HaveALimitOfAllPixels) {
  MeshPictures pictures(100);
  std::vector<std::string> notes;
  const auto first = write("first.png", render::png_bytes(imaging::ColorImage(8, 8)));
  const auto second = write("second.png", render::png_bytes(imaging::ColorImage(8, 8)));
  EXPECT_TRUE(pictures.read(first, notes));
  EXPECT_TRUE(pictures.read(first, notes)) << "once";
  EXPECT_TRUE(notes.empty());
  EXPECT_FALSE(pictures.read(second, notes));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(says(notes[0], {"second.png: all textures together have too many pixels"})) << notes[0];
}

TEST(PictureColors, HaveNotTooManyDifferentColors) {
  imaging::ColorImage many(64, 64);
  for (int v = 0; v < 64; ++v) {
    for (int u = 0; u < 64; ++u) many(u, v) = {static_cast<std::uint8_t>(4 * u), static_cast<std::uint8_t>(4 * v), 100};
  }
  const auto mesh = write("many.obj", "");
  write("many.png", render::png_bytes(many));
  MeshFile file;
  file.mesh.vertices.resize(3);
  file.materials = {{.name = "skin", .picture = "many.png"}};
  for (int i = 0; i < 64 * 64; ++i) {
    const float u = (static_cast<float>(i % 64) + 0.5F) / 64, v = (static_cast<float>(i / 64) + 0.5F) / 64;
    file.mesh.triangles.push_back({0, 1, 2});
    file.material_of.push_back(1);
    file.picture_places.push_back({{{u, v}, {u, v}, {u, v}}});
  }
  MeshPictures pictures;
  std::vector<std::string> notes;
  const auto colors = picture_colors(mesh, file, pictures, notes);
  std::vector<Color> different;
  for (const auto& color : colors) {
    ASSERT_TRUE(color);
    if (std::ranges::find(different, *color) == different.end()) different.push_back(*color);
  }
  EXPECT_LE(different.size(), most_picture_colors);
  EXPECT_GT(different.size(), most_picture_colors / 4);
  // coarse, but near: the lower left is dark red and green, the upper right bright
  EXPECT_NEAR(colors[0]->red, 0, 0.2);
  EXPECT_NEAR(colors[0]->green, 252 / 255.0, 0.2) << "the lowest row of the picture";
}

#endif

}  // namespace
}  // namespace murosimf::appearance
