/// mjcf_mesh_test - meshes of an MJCF file: place, convex parts, mass, and one clear line for every error.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/robot_formats/mjcf/mjcf_geom.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::mjcf {
namespace {

using fixtures::difference;
using fixtures::error_of;
using fixtures::says;

/// A folder of its own for every test.
std::filesystem::path folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto path = fixtures::temp_folder() / (std::string("mjcf_mesh_") + test->name());
  std::filesystem::create_directories(path / "meshes");
  return path;
}

std::filesystem::path write(const std::string& name, const std::string& text) {
  std::ofstream(folder() / name) << text;
  return folder() / name;
}

/// A block from `low` to `high` as an OBJ file; `first` is the number of its first vertex.
std::string block(const Vec3d& low, const Vec3d& high, int first = 1) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    text += fmt::format("v {} {} {}\n", i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
  }
  for (const auto& f : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4}, std::array{2, 6, 7, 3},
                        std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    text += fmt::format("f {} {} {} {}\n", f[0] + first, f[1] + first, f[2] + first, f[3] + first);
  }
  return text;
}

/// 0.2 x 0.4 x 0.6 m with a corner at the origin.
std::string brick() { return block({0, 0, 0}, {0.2, 0.4, 0.6}); }

/// Two blocks that touch nowhere: 0.1 m wide, 0.1 m apart.
std::string pair() {
  return "o left\n" + block({0, 0, 0}, {0.1, 0.1, 0.1}) + "o right\n" + block({0.2, 0, 0}, {0.3, 0.1, 0.1}, 9);
}

/// Line 1: `assets`; line 2 on: a base without inertial, in it `geoms` from line 3 on.
robot::RobotFile read(const std::string& assets, const std::string& geoms, bool lenient = false) {
  return robot::read_robot(write("robot.xml", "<mujoco model='r'>" + assets +
                                                  "\n<worldbody><body name='b'><freejoint/>\n" + geoms +
                                                  "\n</body></worldbody></mujoco>"),
                           {lenient});
}

const std::string brick_asset = "<asset><mesh file='brick.obj'/></asset>";
const std::string brick_geom = "<geom type='mesh' mesh='brick'/>";
const std::string inertial = "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>";

std::string complaint(const std::string& assets, const std::string& geoms, bool lenient = false) {
  const std::string what = error_of([&] { (void)read(assets, geoms, lenient); });
  EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  EXPECT_TRUE(what.starts_with((folder() / "robot.xml").string() + ":")) << what;
  return what.substr(folder().string().size());
}

const Shapes& shapes_of(const robot::RobotFile& result) { return *result.model->find(properties::shapes, 0); }
double mass_of(const robot::RobotFile& result) { return *result.model->find(properties::mass, 0); }
Vec3d center_of(const robot::RobotFile& result) { return *result.model->find(properties::center_of_mass, 0); }
SymMat3d inertia_of(const robot::RobotFile& result) { return *result.model->find(properties::inertia, 0); }

/// Lowest and highest corner of a placed hull, body frame.
std::array<Vec3d, 2> box_of(const PlacedShape& placed) {
  std::array<Vec3d, 2> box{Vec3d{1e9, 1e9, 1e9}, Vec3d{-1e9, -1e9, -1e9}};
  for (const Vec3d& vertex : std::get<Convex>(placed.shape).hull->vertices) {
    const Vec3d v = placed.position + placed.orientation * vertex;
    box[0] = {std::min(box[0].x, v.x), std::min(box[0].y, v.y), std::min(box[0].z, v.z)};
    box[1] = {std::max(box[1].x, v.x), std::max(box[1].y, v.y), std::max(box[1].z, v.z)};
  }
  return box;
}

void expect_box(const PlacedShape& placed, const Vec3d& low, const Vec3d& high) {
  const auto box = box_of(placed);
  EXPECT_LT(difference(box[0], low), 1e-14) << box[0].x << ' ' << box[0].y << ' ' << box[0].z;
  EXPECT_LT(difference(box[1], high), 1e-14) << box[1].x << ' ' << box[1].y << ' ' << box[1].z;
}

std::size_t warnings_with(const robot::RobotFile& result, const std::string& part) {
  return static_cast<std::size_t>(std::ranges::count_if(result.warnings, [&](const std::string& line) {
    return line.find(part) != std::string::npos;
  }));
}

TEST(MjcfMesh, StandsWhereItsFileAndTheGeomSay) {
  write("brick.obj", brick());
  const auto result = read(brick_asset, "<geom type='mesh' mesh='brick' pos='1 2 3' euler='0 0 90'/>");
  ASSERT_EQ(shapes_of(result).size(), 1U);
  expect_box(shapes_of(result)[0], {0.6, 2, 3}, {1, 2.2, 3.6});
  EXPECT_TRUE(shapes_of(result)[0].collides);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(MjcfMesh, HasTheMassOfASolidBlock) {
  write("brick.obj", brick());
  const auto result = read(brick_asset, "<geom type='mesh' mesh='brick' density='500' pos='1 2 3'/>");
  const double mass = 500 * 0.048;
  EXPECT_NEAR(mass_of(result), mass, 1e-12);
  EXPECT_LT(difference(center_of(result), Vec3d{1.1, 2.2, 3.3}), 1e-14);
  const SymMat3d expected{0.16 + 0.36, 0.04 + 0.36, 0.04 + 0.16};
  EXPECT_LT(difference(inertia_of(result), (mass / 12) * expected), 1e-13);
  const auto given = read(brick_asset, "<geom type='mesh' mesh='brick' mass='2'/>");
  EXPECT_LT(difference(inertia_of(given), (2.0 / 12) * expected), 1e-14);
}

TEST(MjcfMesh, SameBlockAsMeshAndAsBoxWeighTheSame) {
  write("brick.obj", brick());
  const auto mesh = read(brick_asset, "<geom type='mesh' mesh='brick' pos='1 0 0' euler='10 20 30'/>");
  const MjcfCompiler compiler;
  const Shape shape = shapes_of(mesh)[0].shape;
  EXPECT_NEAR(robot_formats::volume(shape), robot_formats::volume(Box{{0.1, 0.2, 0.3}}), 1e-15);
  EXPECT_LT(difference(robot_formats::unit_inertia(shape), robot_formats::unit_inertia(Box{{0.1, 0.2, 0.3}})), 1e-15);
}

TEST(MjcfMesh, IsMovedTurnedAndScaledInThisOrder) {
  write("brick.obj", brick());
  // moved by (-1, 0, 0), turned by -90 degrees about z, then y scaled and mirrored: (x, y) -> (y, 2 (x - 1))
  const auto result = read(
      "<asset><mesh name='m' file='brick.obj' refpos='1 0 0' refquat='1 0 0 1' scale='1 -2 1' "
      "inertia='exact'/></asset>",
      "<geom type='mesh' mesh='m'/>");
  expect_box(shapes_of(result)[0], {0, -2 * 1.0, 0}, {0.4, -2 * 0.8, 0.6});
  EXPECT_NEAR(mass_of(result), 96, 1e-11);
}

TEST(MjcfMesh, TakesScaleFromItsClassAndFilesFromMeshdir) {
  write("meshes/brick.obj", brick());
  const std::string defaults =
      "<default><mesh scale='2 2 2'/><default class='small'><mesh scale='.5 .5 .5'/></default></default>";
  const std::string assets = "<asset><mesh file='brick.obj'/><mesh name='s' class='small' file='brick.obj'/></asset>";
  for (const char* compiler : {"<compiler meshdir='meshes'/>", "<compiler assetdir='meshes/'/>",
                               "<compiler assetdir='nowhere' meshdir='meshes'/>"}) {
    const auto result = read(compiler + defaults + assets, brick_geom + "<geom type='mesh' mesh='s'/>");
    expect_box(shapes_of(result)[0], {0, 0, 0}, {0.4, 0.8, 1.2});
    expect_box(shapes_of(result)[1], {0, 0, 0}, {0.1, 0.2, 0.3});
  }
  const std::string away = "<asset><mesh file='away/brick.obj'/></asset>";
  EXPECT_EQ(shapes_of(read("<compiler meshdir='meshes' strippath='true'/>" + away, brick_geom)).size(), 1U);
}

TEST(MjcfMesh, CanStandInTheFileItself) {
  const std::string corners = "vertex='0 0 0 1 0 0 0 1 0 0 0 1'";
  const auto hull = read("<asset><mesh name='m' " + corners + "/></asset>", "<geom type='mesh' mesh='m' density='6'/>");
  EXPECT_NEAR(mass_of(hull), 1, 1e-14);
  EXPECT_LT(difference(center_of(hull), Vec3d{0.25, 0.25, 0.25}), 1e-14);
  const auto faces =
      read("<asset><mesh name='m' " + corners + " face='0 2 1 0 1 3 1 2 3 0 3 2' inertia='exact'/></asset>",
           "<geom type='mesh' mesh='m' density='6'/>");
  EXPECT_NEAR(mass_of(faces), 1, 1e-14);
}

TEST(MjcfMesh, ConcaveOneBecomesItsHullWithAWarning) {
  write("pair.obj", pair());
  const auto result = read("<asset><mesh file='pair.obj'/></asset>", "<geom type='mesh' mesh='pair'/>");
  ASSERT_EQ(shapes_of(result).size(), 1U);
  expect_box(shapes_of(result)[0], {0, 0, 0}, {0.3, 0.1, 0.1});
  EXPECT_EQ(warnings_with(result, "robot.xml:1: mesh 'pair' (pair.obj): the mesh is concave"), 1U);
  EXPECT_EQ(warnings_with(result, "1.5 times its volume"), 1U);
}

TEST(MjcfMesh, PartPerGroupGivesOneHullForEachObject) {
  write("pair.obj", pair());
  write("robot.toml", "[meshes]\npart_per_group = [\"pair\"]\n");
  const auto result = read("<asset><mesh file='pair.obj' inertia='exact'/></asset>",
                           "<geom type='mesh' mesh='pair' mass='2' pos='1 0 0'/>");
  ASSERT_EQ(shapes_of(result).size(), 2U);
  expect_box(shapes_of(result)[0], {1, 0, 0}, {1.1, 0.1, 0.1});
  expect_box(shapes_of(result)[1], {1.2, 0, 0}, {1.3, 0.1, 0.1});
  EXPECT_NEAR(mass_of(result), 2, 1e-14);
  EXPECT_LT(difference(center_of(result), Vec3d{1.15, 0.05, 0.05}), 1e-14);
  EXPECT_TRUE(result.warnings.empty());
  const auto convex =
      read("<asset><mesh file='pair.obj' inertia='convex'/></asset>", "<geom type='mesh' mesh='pair'/>");
  EXPECT_NEAR(mass_of(convex), 2, 1e-12);
  EXPECT_LT(difference(inertia_of(convex), inertia_of(result)), 1e-14);

  write("robot.toml", "[meshes]\npart_per_group = [\"pear\"]\n");
  const auto unknown = error_of([&] { (void)read("<asset><mesh file='pair.obj'/></asset>", ""); });
  EXPECT_TRUE(says(unknown, {"robot.toml:2:", "unknown mesh 'pear'", "did you mean 'pair'?"}));
}

TEST(MjcfMesh, InertiaKindsDifferForConcaveMeshes) {
  write("pair.obj", pair());
  const auto mass = [&](const std::string& kind) {
    return mass_of(
        read("<asset><mesh file='pair.obj' inertia='" + kind + "'/></asset>", "<geom type='mesh' mesh='pair'/>"));
  };
  EXPECT_NEAR(mass("exact"), 2, 1e-12);
  EXPECT_NEAR(mass("convex"), 3, 1e-12);
  EXPECT_NEAR(mass("shell"), 120, 1e-10);
  // from the middle between the blocks, the two sides that face it count as well
  EXPECT_NEAR(mass("legacy"), 1000 * 2 * (0.001 + 2 * 0.01 * 0.05 / 3), 1e-10);
  const auto result = read("<asset><mesh file='pair.obj'/></asset>", "<geom type='mesh' mesh='pair'/>");
  EXPECT_EQ(warnings_with(result, "write inertia=\"exact\""), 1U);
}

TEST(MjcfMesh, OpenOneWarnsWhereItMatters) {
  const std::string whole = brick();
  write("brick.obj", whole.substr(0, whole.rfind('f')));
  const std::string eye = "<geom type='mesh' mesh='brick' contype='0' conaffinity='0'/>";
  EXPECT_TRUE(read(brick_asset, inertial + eye).warnings.empty());
  const auto contact = read(brick_asset, inertial + brick_geom + brick_geom);
  ASSERT_EQ(contact.warnings.size(), 1U);
  EXPECT_TRUE(says(contact.warnings[0], {"robot.xml:1: ", "brick.obj", "not closed (4 open edges", "convex hull"}));
  const auto mass = read(brick_asset, eye);
  ASSERT_EQ(mass.warnings.size(), 1U);
  EXPECT_TRUE(says(mass.warnings[0], {"not closed", "its mass is an estimate", "inertia=\"convex\""}));
  const std::string exact = "<asset><mesh file='brick.obj' inertia='exact'/></asset>";
  EXPECT_TRUE(says(complaint(exact, brick_geom), {":1: ", "brick.obj", "not closed"}));
}

TEST(MjcfMesh, ForTheEyeOnlyCountsForMassUnlessItIsZero) {
  write("brick.obj", brick());
  const auto eye = read(brick_asset, "<geom type='mesh' mesh='brick' contype='0' conaffinity='0' group='2'/>");
  EXPECT_EQ(eye.model->find(properties::shapes, 0), nullptr);
  ASSERT_EQ(eye.description.bodies[0].visuals.size(), 1U);
  EXPECT_EQ(eye.description.bodies[0].visuals[0].mesh, "brick");
  EXPECT_NEAR(mass_of(eye), 48, 1e-12);
  const auto massless = read(brick_asset, "<geom size='1' mass='3'/><geom type='mesh' mesh='brick' mass='0'/>");
  EXPECT_EQ(mass_of(massless), 3);
}

TEST(MjcfMesh, FlatOneIsOnlyForTheEye) {
  write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n");
  const std::string asset = "<asset><mesh file='flat.obj'/></asset>";
  const std::string seen = "<geom type='mesh' mesh='flat' contype='0' conaffinity='0'/>";
  const auto eye = read(asset, inertial + seen);
  EXPECT_EQ(eye.model->find(properties::shapes, 0), nullptr);
  EXPECT_TRUE(eye.warnings.empty());
  EXPECT_TRUE(says(complaint(asset, inertial + "<geom type='mesh' mesh='flat'/>"),
                   {":1: mesh 'flat' (flat.obj): ", "in a plane", "needs a volume"}));
  EXPECT_TRUE(says(complaint(asset, seen), {"in a plane", "inertial"}));
}

TEST(MjcfMesh, OneThatIsOnlyLookedAtMayBeMissingButNotSilently) {
  const std::string asset = "<asset><mesh file='nowhere.stl'/></asset>";
  const auto eye = read(asset, inertial + "<geom type='mesh' mesh='nowhere' contype='0' conaffinity='0'/>");
  EXPECT_EQ(warnings_with(eye, "nowhere.stl; it is visual only and left out"), 1U);
}

TEST(MjcfMesh, ABrokenOneIsLeftOutWhereverItIsUsed) {
  write("brick.obj", "v 0 0 0\nv 0 nan 0\n");
  const auto robot = read(brick_asset, inertial + brick_geom + brick_geom, true);
  EXPECT_EQ(robot.model->find(properties::shapes, 0), nullptr);
  EXPECT_EQ(warnings_with(robot, "ignored"), 2U);
}

TEST(MjcfMesh, InsideOutMattersToExactInertiaOnly) {
  write("brick.obj", brick());
  const auto turned = [](const std::string& kind) {
    return "<asset><mesh name='m' vertex='0 0 0 1 0 0 0 1 0 0 0 1' face='0 1 2 0 3 1 1 3 2 0 2 3' inertia='" + kind +
           "'/></asset>";
  };
  const std::string geom = "<geom type='mesh' mesh='m' density='6'/>";
  EXPECT_TRUE(says(complaint(turned("exact"), geom), {":1: mesh 'm': ", "inside out", "flip"}));
  EXPECT_NEAR(mass_of(read(turned("legacy"), geom)), 1, 1e-14);
}

TEST(MjcfMesh, WarnsOfMillimetersAndOfRichHulls) {
  write("brick.obj", block({0, 0, 0}, {200, 400, 600}));
  EXPECT_EQ(warnings_with(read(brick_asset, brick_geom), "scale=\"0.001 0.001 0.001\""), 1U);
  fixtures::Dice dice("rich");
  std::string vertices;
  for (int i = 0; i < 300; ++i) {
    const Vec3d v = dice.unit();
    vertices += fmt::format("{} {} {} ", v.x, v.y, v.z);
  }
  const auto rich = read("<asset><mesh name='m' vertex='" + vertices + "'/></asset>", "<geom type='mesh' mesh='m'/>");
  EXPECT_EQ(warnings_with(rich, "its hull has 300 vertices"), 1U);
}

TEST(MjcfMesh, NamesFileAndLineOfWhatIsWrong) {
  write("brick.obj", "v 0 0 0\nv 0 nan 0\n");
  EXPECT_TRUE(says(complaint(brick_asset, brick_geom), {":1: mesh 'brick': ", "brick.obj:2: ", "'nan'"}));
  EXPECT_TRUE(says(complaint("<asset><mesh file='x.stl'/></asset>", "<geom type='mesh' mesh='x'/>"),
                   {":1: mesh 'x': ", "x.stl: ", "there is no such file"}));
  write("brick.obj", brick());
  EXPECT_TRUE(
      says(complaint("<asset><mesh file='brick.obj' scale='1 0 1'/></asset>", brick_geom), {":1: ", "scale '1 0 1'"}));
  EXPECT_TRUE(
      says(complaint("<asset><mesh file='brick.obj' scale='1 inf 1'/></asset>", brick_geom), {":1: ", "scale"}));
  EXPECT_TRUE(
      says(complaint("<asset><mesh file='brick.obj' scale='1 1e300 1'/></asset>", brick_geom), {":1: ", "finite"}));
  EXPECT_TRUE(
      says(complaint(brick_asset, "<geom type='mesh' mesh='brik'/>"), {":3: ", "unknown mesh 'brik'", "'brick'"}));
  EXPECT_TRUE(says(complaint(brick_asset, "<geom type='mesh'/>"), {":3: ", "without a mesh"}));
  EXPECT_TRUE(says(complaint(brick_asset, "<geom type='box' mesh='brick'/>"), {":3: ", "box", "type=\"mesh\""}));
  EXPECT_TRUE(says(complaint(brick_asset, "<geom mesh='brick'/>"), {":3: ", "sphere", "type=\"mesh\""}));
  EXPECT_TRUE(says(complaint("<asset><mesh file='a.stl'/><mesh file='b/a.obj'/></asset>", ""),
                   {":1: ", "'a' is already there"}));
  EXPECT_TRUE(says(complaint("<asset><mesh/></asset>", ""), {":1: ", "without name and file"}));
  EXPECT_TRUE(says(complaint("<asset><mesh name='brick'/></asset>", brick_geom), {":1: ", "file or vertices"}));
  EXPECT_TRUE(says(complaint("<asset><mesh name='brick' vertex='0 0 0 1 0 0 0 1 0 0 0 1 5'/></asset>", brick_geom),
                   {"13 numbers"}));
  EXPECT_TRUE(
      says(complaint("<asset><mesh name='brick' vertex='0 0 0 1 0 0 0 1 0 0 0 1' face='0 1 4'/></asset>", brick_geom),
           {"vertex 4"}));
  EXPECT_TRUE(says(complaint("<asset><mesh name='brick' vertex='0 0 0 1 0 0 0 1 0 1 1 0'/></asset>", brick_geom),
                   {"in a plane"}));
}

TEST(MjcfMesh, ThatCannotBeUsedIsLeftOutIfLenient) {
  const auto result =
      read("<asset><mesh file='x.stl'/></asset>", inertial + "<geom type='mesh' mesh='x'/><geom size='1'/>", true);
  EXPECT_EQ(shapes_of(result).size(), 1U);
  EXPECT_EQ(warnings_with(result, "robot.xml:3: mesh 'x' ignored: "), 1U);
  EXPECT_EQ(warnings_with(result, "there is no such file"), 1U);
}

}  // namespace
}  // namespace murosimf::robot_formats::mjcf
