/// urdf_mesh_test - meshes of URDF files are found, scaled and placed.
#include "tests/environment_variable.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot_formats::urdf {
namespace {

using namespace urdf_files;

std::string mesh(const std::string& name, const std::string& more = "") {
  return "<mesh filename='" + name + "' " + more + "/>";
}

/// The description of a robot in folder `pkg/urdf` with a link with one collision mesh.
robot_formats::RobotDescription read_package_robot(const std::string& name,
                                                   const robot_formats::ReaderOptions& options = {}) {
  return read_urdf(write("pkg/urdf/robot.urdf", with_link(collision_xml(mesh(name)))), options);
}

TEST(UrdfMesh, IsConvexScaledAndPlaced) {
  write("t.obj", tetrahedron());
  const auto description =
      read(with_link("<collision name='c'><origin xyz='10 0 0' rpy='0 0 1.5707963267948966'/><geometry>" +
                     mesh("t.obj", "scale='2 4 -6'") + "</geometry></collision>"));
  const auto& shapes = description.bodies.at(0).shapes;
  ASSERT_EQ(shapes.size(), 1u);
  EXPECT_EQ(shapes[0].mesh, "t");
  // corners 0 0 0, 2 0 0, 0 4 0, 0 0 -6 turned a quarter about z
  const PlacedShape& placed = shapes[0].placed;
  std::vector<Vec3d> corners;
  for (const Vec3d& v : std::get<Convex>(placed.shape).hull->vertices) {
    corners.push_back(placed.position + placed.orientation * v);
  }
  for (const Vec3d& expected : {Vec3d{10, 0, 0}, Vec3d{10, 2, 0}, Vec3d{6, 0, 0}, Vec3d{10, 0, -6}}) {
    EXPECT_TRUE(std::ranges::any_of(corners, [&](const Vec3d& c) { return norm(c - expected) < 1e-12; }))
        << expected.x << ' ' << expected.y << ' ' << expected.z;
  }
  ASSERT_EQ(description.meshes.size(), 1u);
  EXPECT_EQ(description.meshes[0].name, "t");
  expect_near(description.meshes[0].scale, {2, 4, -6});
}

TEST(UrdfMesh, IsSharedByAllThatUseIt) {
  write("t.obj", tetrahedron());
  const auto description = read(with_link(collision_xml(mesh("t.obj")) + collision_xml(mesh("t.obj"))));
  const auto& shapes = description.bodies.at(0).shapes;
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(std::get<Convex>(shapes[0].placed.shape).hull, std::get<Convex>(shapes[1].placed.shape).hull);
  EXPECT_EQ(description.meshes.size(), 1u);
}

TEST(UrdfMesh, OfAnotherScaleHasAnotherName) {
  write("t.obj", tetrahedron());
  const auto description =
      read(with_link(collision_xml(mesh("t.obj")) + collision_xml(mesh("t.obj", "scale='2 2 2'"))));
  EXPECT_EQ(description.bodies.at(0).shapes.at(0).mesh, "t");
  EXPECT_EQ(description.bodies.at(0).shapes.at(1).mesh, "t_2");
}

TEST(UrdfMesh, HasAPartForEachGroupWhereItIsAskedFor) {
  write("two.obj",
        "o a\n" + tetrahedron() + "o b\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n");
  const auto text = with_link(collision_xml(mesh("two.obj")));
  EXPECT_EQ(read(text).bodies.at(0).shapes.size(), 1u);
  EXPECT_EQ(read(text, {.part_per_group = {"two"}}).bodies.at(0).shapes.size(), 2u);
}

TEST(UrdfMesh, ForTheEyeIsNotRead) {
  write("t.dae", "this is no mesh");
  const auto description = read(
      with_link("<visual><origin xyz='1 2 3'/><geometry>" + mesh("t.dae", "scale='2 2 2'") + "</geometry></visual>"));
  ASSERT_EQ(description.bodies.at(0).visuals.size(), 1u);
  const robot_formats::VisualDescription& visual = description.bodies[0].visuals[0];
  ASSERT_EQ(description.meshes.size(), 1u);
  EXPECT_EQ(visual.mesh, description.meshes[0].name);
  EXPECT_EQ(description.meshes[0].file, test_folder() / "t.dae");
  expect_near(description.meshes[0].scale, {2, 2, 2});
  expect_near(visual.place.position, {1, 2, 3});
  EXPECT_TRUE(description.bodies[0].shapes.empty());
  EXPECT_TRUE(description.warnings.empty());
}

TEST(UrdfMesh, ForTheEyeMayBeMissing) {
  const auto description = read(with_link(visual(mesh("gone.stl")) + visual(mesh("gone.stl"))));
  ASSERT_EQ(description.warnings.size(), 1u);
  EXPECT_TRUE(contains(description.warnings[0], "robot.urdf:2: for the eye, there is no mesh file 'gone.stl'"));
}

TEST(UrdfMesh, ThatIsMissingIsLeftOutIfLenient) {
  const auto description = read(with_link(collision_xml(mesh("gone.stl"))), {.lenient = true});
  EXPECT_TRUE(description.bodies.at(0).shapes.empty());
  EXPECT_TRUE(any_contains(description.warnings, "collision mesh left out"));
}

TEST(UrdfMesh, ThatCannotBeReadIsNamedWithBothLines) {
  write("bad.obj", "v 0 0 0\nv x\n");
  const auto what = message(with_link(collision_xml(mesh("bad.obj"))));
  EXPECT_TRUE(contains(what, "robot.urdf:2: ")) << what;
  EXPECT_TRUE(contains(what, "bad.obj:2: ")) << what;
}

TEST(UrdfMesh, ThatIsFlatIsAnError) {
  write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  EXPECT_TRUE(contains(message(with_link(collision_xml(mesh("flat.obj")))), "robot.urdf:2: mesh 'flat'"));
  write("t.obj", tetrahedron());
  EXPECT_TRUE(contains(message(with_link(collision_xml(mesh("t.obj", "scale='1 0 1'")))), "scale of 0"));
}

TEST(UrdfMesh, InMillimetersIsAWarning) {
  write("big.obj", "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const auto description = read(with_link(collision_xml(mesh("big.obj"))));
  EXPECT_TRUE(any_contains(description.warnings, "a file in millimeters needs scale"));
}

TEST(UrdfMesh, IsFoundByPathsOfEveryKind) {
  const auto file = write("pkg/meshes/t.obj", tetrahedron());
  for (const std::string& name : {std::string("../meshes/t.obj"), file.string(), "file://" + file.string(),
                                  std::string("package://pkg/meshes/t.obj"), std::string("model://pkg/meshes/t.obj")}) {
    EXPECT_EQ(read_package_robot(name).meshes.at(0).file, file) << name;
  }
}

TEST(UrdfMesh, IsFoundInAPackageThatIsCalledOtherwise) {
  const auto file = write("pkg/meshes/t.obj", tetrahedron());
  write("pkg/package.xml", "<package format='3'><name> robot_description </name></package>");
  EXPECT_EQ(read_package_robot("package://robot_description/meshes/t.obj").meshes.at(0).file, file);
}

TEST(UrdfMesh, IsFoundInAPackageBesideItsOwn) {
  const auto file = write("looks/t.obj", tetrahedron());
  EXPECT_EQ(read_package_robot("package://looks/t.obj").meshes.at(0).file, file);
}

TEST(UrdfMesh, IsFoundWhereThePackageMapSays) {
  write("pkg/t.obj", "not this one");
  const auto file = write("elsewhere/t.obj", tetrahedron());
  const robot_formats::ReaderOptions options{.packages = {{"pkg", test_folder() / "elsewhere"}}};
  EXPECT_EQ(read_package_robot("package://pkg/t.obj", options).meshes.at(0).file, file);
}

TEST(UrdfMesh, IsFoundOnTheSearchPath) {
  const auto file = write("store/far/t.obj", tetrahedron());
  const robot_formats::ReaderOptions options{.search_paths = {test_folder() / "store"}};
  EXPECT_EQ(read_package_robot("package://far/t.obj", options).meshes.at(0).file, file);
  EXPECT_EQ(read_package_robot("far/t.obj", options).meshes.at(0).file, file);
}

TEST(UrdfMesh, IsFoundOnThePathOfTheEnvironment) {
  const auto file = write("store/far/t.obj", tetrahedron());
  const test::EnvironmentVariable path("MUROSIMF_PACKAGE_PATH", "/nowhere:" + (test_folder() / "store").string());
  const auto description = read_package_robot("package://far/t.obj");
  EXPECT_EQ(description.meshes.at(0).file, file);
}

TEST(UrdfMesh, IsFoundWhereOtherProgramsLookForPackages) {
  const std::string folder = test_folder().string();
  const auto file_of = [](const std::string& name) { return read_package_robot(name).meshes.at(0).file; };
  const auto ament = write("prefix/share/arm/t.obj", tetrahedron());
  const auto colcon = write("install/leg/share/leg/t.obj", tetrahedron());
  const auto ros = write("ws/src/robots/head_1/t.obj", tetrahedron());
  write("ws/src/robots/head_1/package.xml", "<package><name>head</name></package>");
  const auto model = write("models/ball/t.obj", tetrahedron());
  EXPECT_TRUE(contains(message(with_link(collision_xml(mesh("package://arm/t.obj")))), "package 'arm'"));
  {
    const test::EnvironmentVariable path("AMENT_PREFIX_PATH", "/nowhere:" + folder + "/prefix");
    EXPECT_EQ(file_of("package://arm/t.obj"), ament);
    EXPECT_EQ(file_of("$(find arm)/t.obj"), ament);
    EXPECT_EQ(file_of("$(find-pkg-share arm)/t.obj"), ament);
  }
  {
    const test::EnvironmentVariable path("COLCON_PREFIX_PATH", folder + "/install");
    EXPECT_EQ(file_of("package://leg/t.obj"), colcon);
  }
  {
    const test::EnvironmentVariable path("ROS_PACKAGE_PATH", folder + "/ws/src:/nowhere");
    EXPECT_EQ(file_of("package://head/t.obj"), ros);
  }
  {
    const test::EnvironmentVariable path("GZ_SIM_RESOURCE_PATH", folder + "/models");
    EXPECT_EQ(file_of("model://ball/t.obj"), model);
  }
}

TEST(UrdfMesh, IsFoundByTheSpellingsOfOtherSystems) {
  const auto file = write("pkg/my meshes/Tip.obj", tetrahedron());
  const std::string absolute = file.parent_path().string();
  for (const std::string& name :
       {std::string("package://pkg/my%20meshes/Tip.obj"), std::string("package://my%20meshes/Tip.obj"),
        std::string("..\\my meshes\\Tip.obj"), std::string("package://pkg\\my%20meshes\\Tip.obj"),
        std::string("../My Meshes/tip.OBJ"), "file:" + absolute + "/Tip.obj",
        "file://localhost" + absolute + "/Tip.obj", std::string("PACKAGE://pkg/my meshes/Tip.obj")}) {
    EXPECT_EQ(read_package_robot(name).meshes.at(0).file, file) << name;
  }
}

TEST(UrdfMesh, ThatIsMissingSaysWhereItWasLookedFor) {
  const auto what = [](const std::string& name) { return message(with_link(collision_xml(mesh(name)))); };
  const std::string folder = test_folder().string();
  EXPECT_TRUE(contains(what("meshes/gone.stl"), "(not there: " + folder + "/meshes/gone.stl)"))
      << what("meshes/gone.stl");
  EXPECT_TRUE(contains(what("https://a.org/t.stl"), "it is an address in the web; download it"));
  for (const char* name : {"a", "b", "c", "d", "e"}) std::filesystem::create_directories(test_folder() / name / "pkg");
  std::string path;
  for (const char* name : {"a", "b", "c", "d", "e"}) path += folder + "/" + name + ":";
  const test::EnvironmentVariable variable("MUROSIMF_PACKAGE_PATH", path);
  EXPECT_TRUE(contains(what("package://pkg/t.stl"), folder + "/c/pkg/t.stl and 2 more)"))
      << what("package://pkg/t.stl");
}

TEST(UrdfMesh, IsFoundInTheFolderThatAMujocoBlockNames) {
  const auto file = write("assets/t.obj", tetrahedron());
  const auto text = [](const std::string& compiler) {
    return "<robot name='r'><mujoco><compiler meshdir='assets' " + compiler + "/></mujoco><link name='base'>" +
           collision_xml(mesh("meshes/t.obj")) + "</link></robot>";
  };
  EXPECT_EQ(read(text("")).meshes.at(0).file, file);
  EXPECT_TRUE(contains(message(text("strippath='false'")), "there is no mesh"));
}

}  // namespace
}  // namespace murosimf::robot_formats::urdf
