// Visual meshes: their places in a model, and their drawing.
#include "murosimf/appearance/visual_meshes.h"

#include <fmt/format.h>

#include "murosimf/model/properties.h"
#include "murosimf/render/png_bytes.h"
#include "murosimf/render/render_mesh.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/fixtures.h"
#include "tests/robot_data.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::appearance {
namespace {

using fixtures::error_of;
using fixtures::says;
using robot_formats::urdf::urdf_files::expect_near;
using robot_formats::urdf::urdf_files::write;

/// A base and an arm at a hinge; `assets` in line 1, `geoms` of the arm in line 3.
robot::RobotFile read_arm(const std::string& assets, const std::string& geoms) {
  const std::string mass = "<inertial mass='1' pos='0 0 0' diaginertia='1 1 1'/>";
  return robot::read_robot(write("robot.xml", "<mujoco model='r'><asset>" + assets +
                                                  "</asset>\n<worldbody><body name='base'><freejoint/>" + mass +
                                                  "<body name='arm' pos='0 0 1'><joint name='elbow' axis='0 1 0'/>" +
                                                  mass + "\n" + geoms + "</body></body></worldbody></mujoco>"));
}

const std::string silent = " type='mesh' contype='0' conaffinity='0' ";

/// The only visual mesh of a robot, as triangles.
geometry::TriangleMesh only_mesh(const robot::RobotFile& robot, const std::string& object) {
  const Model& model = *robot.model;
  EXPECT_EQ(model.having(properties::visuals), std::vector<int>{model.object_index(object)});
  const Visuals* visuals = model.find(properties::visuals, model.object_index(object));
  return visuals && visuals->size() == 1 ? visual_triangles(visuals->at(0)) : geometry::TriangleMesh{};
}

// Rule: scale * (R(refquat)^T (v - refpos)) in the geom's frame (MuJoCo's documentation, asset/mesh), computed by hand.
TEST(VisualMeshes, StandWhereTheMjcfFilePutsThem) {
  write("t.obj", robot_formats::urdf::urdf_files::tetrahedron());
  const robot::RobotFile robot = read_arm(
      "<mesh name='t' file='t.obj' scale='2 3 4' refpos='1 0 0' refquat='0.7071067811865476 0 0 0.7071067811865476'/>",
      "<geom mesh='t' pos='0.1 0.2 0.3' euler='90 0 0' rgba='0.1 0.2 0.3 1'" + silent + "/>");
  const auto mesh = only_mesh(robot, "arm");
  ASSERT_EQ(mesh.vertices.size(), 4U);
  // file (0,0,0) (1,0,0) (0,1,0) (0,0,1), less refpos, turned by -90 deg about z: (x, y) -> (y, -x), scaled; then the
  // geom's turn by 90 deg about x: (x, y, z) -> (x, -z, y)
  const std::vector<Vec3d> expected{{0, 0, 3}, {0, 0, 0}, {2, 0, 3}, {0, -4, 3}};
  for (const Vec3d& v : expected) {
    double nearest = 1;
    for (const Vec3d& found : mesh.vertices) nearest = std::min(nearest, norm(found - v - Vec3d{0.1, 0.2, 0.3}));
    EXPECT_LT(nearest, 1e-12) << v.x << ' ' << v.y << ' ' << v.z;
  }
  EXPECT_EQ(robot.model->find(properties::visuals, robot.model->object_index("elbow"))->at(0).color.blue, 0.3);
}

/// A tetrahedron whose faces have no material, "red", "red" and "dark", which `library` defines.
std::string painted(const std::string& library) {
  return library + "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nusemtl red\nf 1 2 4\nf 1 4 3\nusemtl dark\nf 2 3 4\n";
}

struct Painted {
  std::vector<VisualPart> parts;
  std::vector<std::string> notes;
};
/// The visual of a URDF file with t.obj as its mesh.
Painted read_painted(const std::string& material = "") {
  using namespace robot_formats::urdf::urdf_files;
  const auto file = write("robot.urdf", with_link(solid() + "<visual><geometry><mesh filename='t.obj'/></geometry>" +
                                                  material + "</visual>"));
  const robot::RobotFile robot = robot::read_robot(file);
  const Visuals* visuals = robot.model->find(properties::visuals, robot.model->having(properties::visuals).at(0));
  Painted painted;
  MeshPictures pictures;
  painted.parts = visual_parts(visuals->at(0), pictures, PictureUse::by_triangle, painted.notes);
  return painted;
}

TEST(VisualMeshes, OfUrdfHaveTheColorsOfTheirFiles) {
  write("t.obj", painted("mtllib t.mtl\n"));
  write("t.mtl", "# colors\nnewmtl red\nKd 0.9 0.1 0\nd 0.5\nnewmtl dark\nKd 0.5 0.5 0.5\nmap_Kd skin.jpg\n");
  const Painted found = read_painted();
  ASSERT_EQ(found.parts.size(), 3U);
  EXPECT_EQ(found.parts[0].color, Color{}) << "without a material: as the robot";
  EXPECT_EQ(found.parts[0].mesh.triangles.size(), 1U);
  EXPECT_EQ(found.parts[1].color, (Color{0.9, 0.1, 0, 0.5}));
  EXPECT_EQ(found.parts[1].mesh.triangles.size(), 2U);
  EXPECT_EQ(found.parts[1].mesh.vertices.size(), 4U);
  EXPECT_EQ(found.parts[2].color, Color{});
  EXPECT_TRUE(found.parts[2].as_it_is) << "gray of a material is no robot's own color";
  EXPECT_FALSE(found.parts[0].as_it_is);
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_TRUE(says(found.notes[0], {"t.obj", "'skin.jpg' is not drawn", ".jpg"})) << found.notes[0];

  const Painted own = read_painted("<material name='blue'><color rgba='0 0 1 1'/></material>");
  ASSERT_EQ(own.parts.size(), 1U) << "what the robot file says counts";
  EXPECT_EQ(own.parts[0].color.blue, 1);
  EXPECT_TRUE(own.notes.empty());
}

TEST(VisualMeshes, ColorsThatCannotBeReadAreNamed) {
  write("t.obj", painted("mtllib ../t.mtl /etc/passwd missing.mtl\n"));
  const Painted found = read_painted();
  ASSERT_EQ(found.parts.size(), 1U);
  EXPECT_EQ(found.parts[0].mesh.triangles.size(), 4U);
  ASSERT_EQ(found.notes.size(), 3U);
  EXPECT_TRUE(says(found.notes[0], {"'../t.mtl'", "beside"})) << found.notes[0];
  EXPECT_TRUE(says(found.notes[1], {"'/etc/passwd'", "beside"})) << found.notes[1];
  EXPECT_TRUE(says(found.notes[2], {"missing.mtl"})) << found.notes[2];
  write("t.obj", painted("mtllib t.mtl\n"));
  write("t.mtl", "newmtl red\nKd 0.9 much 0\n");
  EXPECT_TRUE(says(read_painted().notes.at(0), {"t.mtl:2", "Kd"}));
}

TEST(VisualMeshes, OfMjcfHaveTheTexturesOfTheirMaterials) {
  write("t.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt .5 .5\nf 1/1 3/1 2/1\nf 1/1 2/1 4/1\nf 1/1 4/1 3/1\nf 2/1 3/1 4/1\n");
  const std::string assets =
      "<mesh name='t' file='t.obj'/><texture name='skin' type='2d' file='skin.png'/><material name='m' texture='skin' "
      "rgba='1 1 0 1'/>";
  const auto parts_of = [&](std::vector<std::string>& notes) {
    const robot::RobotFile robot = read_arm(assets, "<geom mesh='t' material='m'" + silent + "/>");
    MeshPictures pictures;
    return visual_parts(robot.model->find(properties::visuals, robot.model->object_index("elbow"))->at(0), pictures,
                        PictureUse::by_triangle, notes);
  };
  std::vector<std::string> notes;
  write("skin.png", "no picture");
  auto parts = parts_of(notes);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].color, (Color{1, 1, 0}));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(says(notes[0], {"skin.png", "the mesh is drawn without it"})) << notes[0];
#ifdef MUROSIMF_HAS_CAIRO
  notes.clear();
  write("skin.png", render::png_bytes(imaging::ColorImage(4, 4, {0, 255, 255})));
  parts = parts_of(notes);
  EXPECT_TRUE(notes.empty());
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].color, (Color{0, 1, 0})) << "cyan times yellow";
  write("t.obj", robot_formats::urdf::urdf_files::tetrahedron());
  EXPECT_EQ(parts_of(notes)[0].color, (Color{1, 1, 0}));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(says(notes[0], {"t.obj", "skin.png", "no corner has a place"})) << notes[0];
#endif
}

#ifdef MUROSIMF_HAS_CAIRO
// Rule: of OBJ, the second number of vt counts upwards. Corners keep their own places through mirroring.
TEST(VisualMeshes, ShowPicturesPixelByPixel) {
  write("t.obj",
        "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 .75\nusemtl skin\nf 1/1 3/3 2/2\n"
        "f 1/1 2/2 4/3\nusemtl plain\nf 1/1 4/1 3/1\nf 2/1 3/1 4/1\n");
  write("t.mtl", "newmtl skin\nKd 1 .5 1\nmap_Kd skin.png\nnewmtl plain\nKd 0 1 0\n");
  imaging::ColorImage image(2, 2);
  image(1, 0) = {9, 8, 7};
  write("skin.png", render::png_bytes(image));
  MeshPictures pictures;
  std::vector<std::string> notes;
  const std::string file = write("t.obj.txt", "").replace_filename("t.obj").string();
  for (const double side : {1.0, -1.0}) {
    const auto parts =
        visual_parts({.file = file, .scale = {1, side, 1}, .mesh_colors = true}, pictures, PictureUse::by_pixel, notes);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].color, (Color{1, 0.5, 1}));
    ASSERT_TRUE(parts[0].picture);
    EXPECT_EQ(parts[0].picture->whole()(1, 0).red, 9);
    EXPECT_FALSE(parts[1].picture);
    EXPECT_TRUE(parts[1].mesh.places.empty());
    ASSERT_EQ(parts[0].mesh.places.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& p = parts[0].mesh.vertices[parts[0].mesh.triangles[i][k]];
        EXPECT_EQ(parts[0].mesh.places[i][k][0], p.x > 0 ? 1 : 0) << side;
        EXPECT_EQ(parts[0].mesh.places[i][k][1], side * p.y + p.z > 0 ? 0.75F : 0) << side;
      }
    }
    const render::RenderMesh solid = render::render_mesh_of(parts[0].mesh, parts[0].picture);
    ASSERT_EQ(solid.places.size(), solid.corners.size());
    for (std::size_t i = 0; i < solid.corners.size(); ++i)
      EXPECT_EQ(solid.places[i][1], solid.corners[i].place[1] != 0 || solid.corners[i].place[2] > 0 ? 0.25F : 1);
  }
  EXPECT_TRUE(notes.empty());
}

// Rule: MuJoCo repeats from the upper left corner on. Two uses of one file share its pixels.
TEST(VisualMeshes, RepeatAndSharePictures) {
  const std::string file = write("t.obj",
                                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 .5\nvt 1 1\nf 1/1 3/2 2/2\nf 1/1 2/2 4/2\nf "
                                 "1/1 4/2 3/2\nf 2/1 3/1 4/1\n")
                               .string();
  const std::string skin = write("skin.png", render::png_bytes(imaging::ColorImage(4, 4, {9, 8, 7}))).string();
  MeshPictures pictures;
  std::vector<std::string> notes;
  const auto part = [&](const std::array<double, 2>& repeat) {
    return visual_parts({.file = file, .picture = skin, .picture_repeat = repeat}, pictures, PictureUse::by_pixel,
                        notes)
        .at(0);
  };
  const VisualPart once = part({1, 1}), often = part({3, 2});
  EXPECT_EQ(once.picture, often.picture);
  EXPECT_EQ(once.mesh.places[0], (geometry::PicturePlaces{{{0, 0.5F}, {1, 1}, {1, 1}}}));
  EXPECT_EQ(often.mesh.places[0], (geometry::PicturePlaces{{{0, 0}, {3, 1}, {3, 1}}}));
  EXPECT_TRUE(notes.empty());
}
#endif

TEST(VisualMeshes, OfWeldedLinksBelongToWhatTheyAreWeldedTo) {
  using namespace robot_formats::urdf::urdf_files;
  write("t.obj", tetrahedron());
  const std::string mesh = "<mesh filename='t.obj' scale='0.1 0.1 0.1'/>";
  const auto file =
      write("robot.urdf",
            robot_formats::urdf::urdf_files::robot_xml(
                link("arm", solid()) + joint("revolute", "base", "arm", any_limit, "elbow") +
                link("hand", visual(mesh)) +
                joint("fixed", "arm", "hand", "<origin xyz='1 2 3' rpy='0 0 1.5707963267948966'/>", "wrist")));
  const auto triangles = only_mesh(robot::read_robot(file), "arm");
  ASSERT_EQ(triangles.vertices.size(), 4U);
  Vec3d sum;
  for (const Vec3d& v : triangles.vertices) sum += v;
  expect_near(0.25 * sum, Vec3d{1 - 0.025, 2 + 0.025, 3 + 0.025});
}

TEST(VisualMeshes, MirroredOnesStayOutsideOut) {
  write("t.obj", robot_formats::urdf::urdf_files::tetrahedron());
  const auto mesh =
      only_mesh(read_arm("<mesh name='t' file='t.obj' scale='1 -1 1'/>", "<geom mesh='t'" + silent + "/>"), "arm");
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    volume += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
  }
  EXPECT_NEAR(volume, 1.0 / 6, 1e-12);
}

TEST(VisualMeshes, NameTheFileThatCannotBeRead) {
  EXPECT_TRUE(says(error_of([] { (void)visual_triangles({.file = "/no/such/mesh.stl"}); }), {"/no/such/mesh.stl"}));
  const auto file = write("t.obj", robot_formats::urdf::urdf_files::tetrahedron()).string();
  EXPECT_TRUE(says(error_of([&] { (void)visual_triangles({.file = file, .scale = {1, 0, 1}}); }), {"t.obj", "scale"}));
}

TEST(Appearance, AreMeshesForTheEyeInsteadOfWhatCollides) {
  write("t.obj", robot_formats::urdf::urdf_files::tetrahedron());
  const std::string ball = "<geom type='sphere' size='0.1'/>";
  const std::string eye = "<geom type='box' size='1 1 1' contype='0' conaffinity='0'/>";
  const std::string mesh = "<mesh name='t' file='t.obj'/>";
  const Appearance dressed = appearance_of(*read_arm(mesh, ball + eye + "<geom mesh='t'" + silent + "/>").model);
  ASSERT_EQ(dressed.meshes.size(), 1U);
  ASSERT_EQ(dressed.shapes.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<Box>(dressed.shapes[0].placed.shape));
  const Appearance bare = appearance_of(*read_arm(mesh, ball + eye).model);
  EXPECT_TRUE(bare.meshes.empty());
  EXPECT_EQ(bare.shapes.size(), 2U);
}

TEST(Appearance, HaveConvexPolyhedraAmongTheMeshes) {
  write("t.obj", robot_formats::urdf::urdf_files::tetrahedron());
  const robot::RobotFile robot = read_arm("<mesh name='t' file='t.obj'/>", "<geom type='mesh' mesh='t' pos='0 0 5'/>");
  const Appearance appearance = appearance_of(*robot.model);
  ASSERT_EQ(appearance.meshes.size(), 1U);
  EXPECT_EQ(appearance.meshes[0].object, robot.model->object_index("arm"));
  EXPECT_EQ(appearance.meshes[0].mesh.triangles.size(), 4U);
  Vec3d sum;
  for (const Vec3d& v : appearance.meshes[0].mesh.vertices) sum += v;
  expect_near(0.25 * sum, Vec3d{0.25, 0.25, 5.25});
}

TEST(Appearance, LeaveOutWhatCannotBeReadWithAWarning) {
  const auto broken = write("t.obj", "v 0 0 0\nf 1 2 3\n");
  const Appearance appearance = appearance_of(
      *read_arm("<mesh name='t' file='t.obj'/>", "<geom type='sphere' size='0.1'/><geom mesh='t'" + silent + "/>")
           .model);
  EXPECT_TRUE(appearance.meshes.empty());
  EXPECT_EQ(appearance.shapes.size(), 1U) << "what collides is drawn instead";
  ASSERT_EQ(appearance.warnings.size(), 1U);
  EXPECT_TRUE(says(appearance.warnings[0], {"t.obj:2", "'elbow' is drawn without it"}));
}

TEST(Appearance, OfARealRobotHaveFewTriangles) {
  if (!std::filesystem::exists(k1_mjcf())) GTEST_SKIP() << "no " << k1_mjcf();
  const robot::RobotFile robot = robot::read_robot(k1_mjcf());
  const Appearance all = appearance_of(*robot.model, 1'000'000), few = appearance_of(*robot.model);
  const auto count = [](const Appearance& appearance) {
    std::size_t triangles = 0;
    for (const SeenMesh& seen : appearance.meshes) triangles += seen.mesh.triangles.size();
    return triangles;
  };
  EXPECT_GT(count(all), 200'000U);
  EXPECT_LE(count(few), usual_triangles);
  EXPECT_GT(count(few), usual_triangles / 2);
  EXPECT_LT(few.error, 0.01);
  EXPECT_TRUE(few.warnings.empty());
}

}  // namespace
}  // namespace murosimf::appearance
