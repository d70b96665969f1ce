/// dae_file_test - COLLADA files become the triangles that their scene shows.
#include "murosimf/robot_formats/mesh/mesh_file.h"

#include <array>

#include "murosimf/geometry/mesh_mass.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot_formats::mesh {
namespace {

using robot_formats::urdf::urdf_files::contains;
using robot_formats::urdf::urdf_files::expect_near;

/// A tetrahedron with legs of 1 unit along the axes, its corners 0 to 3; `primitive` begins in line 4.
std::string library(const std::string& primitive) {
  return "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' count='12'>\n"
         "0 0 0  1 0 0  0 1 0  0 0 1</float_array><technique_common><accessor source='#a' count='4' stride='3'/>"
         "</technique_common></source><vertices id='v'><input semantic='POSITION' source='#p'/></vertices>\n" +
         primitive + "</mesh></geometry></library_geometries>\n";
}

const std::string triangles =
    "<triangles count='4'><input semantic='VERTEX' source='#v' offset='0'/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>";

std::string file_of(const std::string& library, const std::string& nodes, const std::string& asset = "") {
  return "<COLLADA version='1.4.1'>" + asset + "\n" + library + "<library_visual_scenes><visual_scene id='s'>" + nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>";
}

const std::string plain_node = "<node><instance_geometry url='#g'/></node>";

MeshFile read(const std::string& text) {
  return read_mesh_file(robot_formats::urdf::urdf_files::write("mesh.dae", text));
}

MeshFile read_primitive(const std::string& primitive) { return read(file_of(library(primitive), plain_node)); }

std::string complaint(const std::string& text) {
  try {
    (void)read(text);
  } catch (const SetupError& error) {
    return error.what();
  }
  return "no SetupError";
}

std::string complaint_about(const std::string& primitive) { return complaint(file_of(library(primitive), plain_node)); }

/// The solid of legs 1 has 1/6 of a unit cube, its center at a quarter of them; a wrong way round makes it negative.
void expect_tetrahedron(const MeshFile& file) {
  const auto solid = geometry::solid_mass(file.mesh);
  EXPECT_EQ(file.mesh.vertices.size(), 4u);
  EXPECT_TRUE(geometry::find_seams(file.mesh).closed());
  EXPECT_NEAR(solid.volume, 1.0 / 6, 1e-15);
  expect_near(solid.center, {0.25, 0.25, 0.25});
}

/// Three faces bound to a red material, one to another one, whose `diffuse` has this inside.
MeshFile read_materials(const std::string& diffuse) {
  const std::string input = "<input semantic='VERTEX' source='#v' offset='0'/>";
  const auto effect = [](const std::string& id, const std::string& inside) {
    return "<effect id='" + id + "'><profile_COMMON><technique sid='t'><phong><diffuse>" + inside +
           "</diffuse></phong></technique></profile_COMMON></effect>";
  };
  const std::string materials =
      "<library_effects>" + effect("e1", "<color>1 0 0.25 1</color>") + effect("e2", diffuse) +
      "</library_effects><library_materials><material id='m1'><instance_effect url='#e1'/></material><material id='m2'>"
      "<instance_effect url='#e2'/></material></library_materials>";
  const std::string bound =
      "<node><instance_geometry url='#g'><bind_material><technique_common><instance_material symbol='one' "
      "target='#m1'/><instance_material symbol='two' target='#m2'/></technique_common></bind_material>"
      "</instance_geometry></node>";
  return read(file_of(library("<triangles count='3' material='one'>" + input + "<p>0 2 1 0 1 3 0 3 2</p></triangles>" +
                              "<triangles count='1' material='two'>" + input + "<p>1 2 3</p></triangles>") +
                          materials,
                      bound));
}

TEST(DaeFile, MaterialsHaveTheirDiffuseColors) {
  const MeshFile file = read_materials("<color>0 0.5 2 1</color>");
  expect_tetrahedron(file);
  ASSERT_EQ(file.materials.size(), 2U);
  EXPECT_EQ(file.materials[0].color, (Color{1, 0, 0.25}));
  EXPECT_EQ(file.materials[1].color, (Color{0, 0.5, 1})) << "at most 1";
  EXPECT_EQ(file.material_of, (std::vector<std::uint32_t>{1, 1, 1, 2}));
}

TEST(DaeFile, MaterialsThatAreNotUnderstoodHaveNoColor) {
  const MeshFile textured = read_materials("<texture texture='picture' texcoord='uv'/>");
  EXPECT_EQ(textured.materials[1].picture, "picture");
  EXPECT_FALSE(textured.materials[1].color);
  EXPECT_FALSE(read_materials("<color>red</color>").materials[1].color);
  EXPECT_TRUE(read_primitive(triangles).materials.empty());
}

// Rule: COLLADA 1.4.1, "Determining Transparency".
TEST(DaeFile, MaterialsAreAsOpaqueAsTheirEffectsSay) {
  const auto opacity = [](const std::string& words) {
    return read_materials("<color>0 0.5 1 1</color></diffuse>" + words + "<diffuse>").materials[1].color->alpha;
  };
  const auto words = [](const std::string& kind, const std::string& color, const std::string& factor) {
    return "<transparent" + kind + "><color>" + color + "</color></transparent><transparency><float>" + factor +
           "</float></transparency>";
  };
  EXPECT_EQ(opacity(""), 1);
  EXPECT_EQ(opacity("<transparency><float>0.25</float></transparency>"), 0.25);
  EXPECT_EQ(opacity("<transparent><color>0 0 0 0.5</color></transparent>"), 0.5);
  EXPECT_EQ(opacity(words("", "1 1 1 0.5", "0.5")), 0.25);
  EXPECT_EQ(opacity(words(" opaque='A_ZERO'", "1 1 1 0.5", "0.5")), 0.75);
  EXPECT_NEAR(opacity(words(" opaque='RGB_ONE'", "1 0 0 1", "0.5")), 0.5 * 0.212671, 1e-9);
  EXPECT_NEAR(opacity(words(" opaque='RGB_ZERO'", "0 1 0 1", "1")), 1 - 0.71516, 1e-9);
  EXPECT_EQ(opacity(words("", "1 1 1 1", "0")), 1) << "of old exporters";
  EXPECT_EQ(opacity(words("", "1 1 1", "0.5")), 1) << "no color";
  EXPECT_EQ(opacity("<transparent><texture texture='a'/></transparent>"), 1);
}

/// A tetrahedron of one material, whose effect has these parameters and this diffuse texture; the file's image is "img".
MeshFile read_pictured(const std::string& parameters, const std::string& texture) {
  const std::string places =
      "<source id='uv'><float_array id='n' count='8'>0 0  0.5 0.25  1 1  0.25 0.75</float_array><technique_common>"
      "<accessor source='#n' count='4' stride='2'/></technique_common></source>";
  const std::string materials =
      "<library_images><image id='img'><init_from>skin%201.png</init_from></image></library_images><library_effects>"
      "<effect id='e'><profile_COMMON>" +
      parameters + "<technique sid='t'><lambert><diffuse><texture texture='" + texture +
      "' texcoord='UVMap'/></diffuse></lambert></technique></profile_COMMON></effect></library_effects>"
      "<library_materials><material id='m'><instance_effect url='#e'/></material></library_materials>";
  const std::string bound =
      "<node><instance_geometry url='#g'><bind_material><technique_common><instance_material symbol='one' target='#m'/>"
      "</technique_common></bind_material></instance_geometry></node>";
  return read(file_of(library(places + "<triangles count='4' material='one'><input semantic='TEXCOORD' source='#uv' "
                                       "offset='0' set='0'/><input semantic='VERTEX' source='#v' offset='1'/>"
                                       "<p>3 0 1 2 2 1  0 0 0 1 0 3  1 0 2 3 9 2  0 1 0 2 0 3</p></triangles>") +
                          materials,
                      bound));
}

TEST(DaeFile, TexturesAreFilesAndPlacesOfCorners) {
  const std::string
      sampler = "<newparam sid='img-sampler'><sampler2D><source>img-surface</source></sampler2D></newparam>",
      surface = "<newparam sid='img-surface'><surface type='2D'><init_from>img</init_from></surface></newparam>";
  const MeshFile file = read_pictured(surface + sampler, "img-sampler");
  expect_tetrahedron(file);
  ASSERT_EQ(file.materials.size(), 1U);
  EXPECT_EQ(file.materials[0].picture, "skin%201.png");
  ASSERT_EQ(file.picture_places.size(), 4U);
  EXPECT_EQ(file.picture_places[0], (PicturePlaces{{{0.25F, 0.75F}, {0.5F, 0.25F}, {1, 1}}}));
  EXPECT_EQ(file.picture_places[2], (PicturePlaces{{{0.5F, 0.25F}, {1, 1}, {0, 0}}})) << "there is no ninth place";
  EXPECT_EQ(read_pictured("", "img").materials[0].picture, "skin%201.png") << "without sampler and surface";
}

TEST(DaeFile, ReadsTriangles) { expect_tetrahedron(read_primitive(triangles)); }

TEST(DaeFile, SkipsNormalsBetweenTheCorners) {
  expect_tetrahedron(
      read_primitive("<triangles count='4'><input semantic='NORMAL' source='#n' offset='0'/>"
                     "<input semantic='VERTEX' source='#v' offset='1'/>"
                     "<p>9 0 9 2 9 1  9 0 9 1 9 3  9 0 9 3 9 2  9 1 9 2 9 3</p></triangles>"));
}

TEST(DaeFile, ReadsLinesOfPolygons) {
  const std::string input = "<input semantic='VERTEX' source='#v' offset='0'/>";
  expect_tetrahedron(read_primitive("<polylist count='4'>" + input +
                                    "<vcount>3 3 3 3</vcount><p>0 2 1 0 1 3 0 3 2 1 2 3</p></polylist>"));
  expect_tetrahedron(
      read_primitive("<polygons count='4'>" + input + "<p>0 2 1</p><p>0 1 3</p><p>0 3 2</p><p>1 2 3</p></polygons>"));
  expect_tetrahedron(read_primitive("<trifans count='2'>" + input + "<p>0 1 3 2 1</p><p>1 2 3</p></trifans>"));
  expect_tetrahedron(read_primitive("<tristrips count='1'>" + input + "<p>0 2 1 3 0 2</p></tristrips>"));
}

TEST(DaeFile, CutsPolygonsIntoFans) {
  const auto file = read_primitive(
      "<polylist count='1'><input semantic='VERTEX' source='#v' offset='0'/><vcount>4</vcount><p>0 1 2 "
      "3</p></polylist>");
  EXPECT_EQ(file.mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(DaeFile, TakesTheUnitOfTheFile) {
  const auto file = read(
      file_of(library(triangles), plain_node, "<asset><unit name='cm' meter='0.01'/><up_axis>Y_UP</up_axis></asset>"));
  EXPECT_NEAR(geometry::solid_mass(file.mesh).volume, 1e-6 / 6, 1e-20);
}

TEST(DaeFile, MovesNodesInTheOrderOfTheirSteps) {
  // the inner node turns x to y, then the outer one shifts by 10 along x and doubles lengths
  const auto file =
      read(file_of(library(triangles),
                   "<node><translate>10 0 0</translate><scale>2 2 2</scale><node><rotate>0 0 1 90</rotate>"
                   "<instance_geometry url='#g'/></node></node>"));
  const auto solid = geometry::solid_mass(file.mesh);
  EXPECT_NEAR(solid.volume, 8.0 / 6, 1e-12);
  expect_near(solid.center, {9.5, 0.5, 0.5});
}

TEST(DaeFile, ReadsMatricesByRows) {
  const auto file =
      read(file_of(library(triangles),
                   "<node><matrix>0 -1 0 1  1 0 0 2  0 0 1 3  0 0 0 1</matrix><instance_geometry url='#g'/></node>"));
  expect_near(geometry::solid_mass(file.mesh).center, {0.75, 2.25, 3.25});
}

TEST(DaeFile, KeepsTheOutsideOfMirroredNodesOutside) {
  const auto file =
      read(file_of(library(triangles), "<node><scale>-1 1 1</scale><instance_geometry url='#g'/></node>"));
  EXPECT_NEAR(geometry::solid_mass(file.mesh).volume, 1.0 / 6, 1e-15);
}

TEST(DaeFile, HasAPartForEachGeometryInTheScene) {
  const auto text = file_of(library(triangles) +
                                "<library_nodes><node id='again'><instance_geometry url='#g'/></node></library_nodes>",
                            plain_node + "<node><translate>5 0 0</translate><instance_node url='#again'/></node>");
  const auto parts = split_parts(read(text));
  ASSERT_EQ(parts.size(), 2u);
  expect_near(geometry::solid_mass(parts[1]).center, {5.25, 0.25, 0.25});
}

TEST(DaeFile, NamesTheLineOfEveryMistake) {
  const std::string input = "<input semantic='VERTEX' source='#v' offset='0'/>";
  EXPECT_TRUE(contains(complaint_about("<triangles>" + input + "<p>0 1 4</p></triangles>"),
                       "mesh.dae:4: vertex 4 is named, there are 4"));
  EXPECT_TRUE(contains(complaint_about("<triangles>" + input + "<p>0 1 -1</p></triangles>"), "vertex -1 is named"));
  EXPECT_TRUE(
      contains(complaint_about("<triangles>" + input + "<p>0 1 x</p></triangles>"), "mesh.dae:4: <p> holds something"));
  EXPECT_TRUE(contains(complaint_about("<triangles>" + input + "<p>0 1</p></triangles>"), "fewer corners"));
  EXPECT_TRUE(
      contains(complaint_about("<polylist>" + input + "<vcount>3 3</vcount><p>0 1 2</p></polylist>"), "fewer corners"));
  EXPECT_TRUE(contains(complaint_about("<triangles><p>0 1 2</p></triangles>"), "<triangles> has no VERTEX"));
  EXPECT_TRUE(contains(complaint_about("<polygons>" + input + "<ph/></polygons>"), "polygons with holes"));
  EXPECT_TRUE(contains(complaint_about("<lines>" + input + "<p>0 1</p></lines>"), "there are no triangles"));
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

// A small file can expand to a thousand times its size.
TEST(DaeFile, RefusesMoreThanAFileCanMean) {
  const std::string twice = "<node id='n0'>" + repeated("<instance_geometry url='#g'/>", 100) + "</node>" +
                            "<node id='n1'>" + repeated("<instance_node url='#n0'/>", 100) + "</node>" + "<node>" +
                            repeated("<instance_node url='#n1'/>", 100) + "</node>";
  const std::string empty = "<triangles count='0'><input semantic='VERTEX' source='#v' offset='0'/><p/></triangles>";
  EXPECT_TRUE(contains(complaint(file_of(library(empty), twice)), "the mesh has more than 3000000 vertices"));
  const std::string idle = "<node id='n0'>" + repeated("<extra/>", 2000) + "</node><node>" +
                           repeated("<instance_node url='#n0'/>", 2000) + "</node>";
  EXPECT_TRUE(contains(complaint(file_of(library(triangles), idle)), "never end"));
}

TEST(DaeFile, RefusesFilesThatAreNoneOrNeverEnd) {
  EXPECT_TRUE(contains(complaint("<robot/>"), "not <COLLADA>"));
  EXPECT_TRUE(contains(complaint("<COLLADA>"), "not well-formed"));
  EXPECT_TRUE(contains(complaint(file_of(library(triangles), "<node><instance_geometry url='#h'/></node>")),
                       "url '#h' is not in the file"));
  EXPECT_TRUE(contains(complaint(file_of("", "<node id='n'><instance_node url='#n'/></node>")), "never end"));
  EXPECT_TRUE(
      contains(complaint(file_of(library(triangles), plain_node, "<asset><unit meter='0'/></asset>")), "is no length"));
}

}  // namespace
}  // namespace murosimf::robot_formats::mesh
