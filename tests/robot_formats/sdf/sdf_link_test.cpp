/// sdf_link_test - shapes, colors and sensors of links of an SDF file.
#include "murosimf/robot_formats/sdf/sdf_link.h"

#include "tests/robot_formats/sdf/sdf_files.h"

namespace murosimf::robot_formats::sdf {
namespace {

using namespace sdf_files;

class SdfLink : public SdfTest {};

robot_formats::RobotDescription with(const std::string& inside, const std::string& beside = "") {
  return read(model(beside + link("a", inside)));
}

std::string shape(const std::string& geometry, const std::string& more = "", const std::string& kind = "collision") {
  return "<" + kind + " name='s'><geometry>" + geometry + "</geometry>" + more + "</" + kind + ">";
}

PlacedShape shape_of(const std::string& inside) { return with(inside).bodies.at(0).shapes.at(0).placed; }

TEST_F(SdfLink, HasShapesWithWholeSizes) {
  const auto box = std::get<Box>(shape_of(shape("<box><size>1 2 3</size></box>")).shape);
  expect_near(box.half_size, {0.5, 1, 1.5});
  EXPECT_EQ(std::get<Sphere>(shape_of(shape("<sphere><radius>2</radius></sphere>")).shape).radius, 2);
  const auto cylinder =
      std::get<Cylinder>(shape_of(shape("<cylinder><radius>2</radius><length>3</length></cylinder>")).shape);
  EXPECT_EQ(cylinder.radius, 2);
  EXPECT_EQ(cylinder.half_length, 1.5);
  const auto capsule =
      std::get<Capsule>(shape_of(shape("<capsule><radius>2</radius><length>3</length></capsule>")).shape);
  EXPECT_EQ(capsule.half_length, 1.5);
  expect_near(std::get<Ellipsoid>(shape_of(shape("<ellipsoid><radii>1 2 3</radii></ellipsoid>")).shape).semi_axes,
              {1, 2, 3});
}

TEST_F(SdfLink, PlacesShapesInFrames) {
  const auto robot = with(shape("<sphere><radius>1</radius></sphere>", "<pose relative_to='f'>0 0 1 0 0 0</pose>"),
                          "<frame name='f'><pose>5 0 0 0 0 0</pose></frame>");
  expect_near(robot.bodies.at(0).shapes.at(0).placed.position, {5, 0, 1});
}

TEST_F(SdfLink, TakesFrictionOfSurfaces) {
  const std::string ball = "<sphere><radius>1</radius></sphere>";
  EXPECT_EQ(shape_of(shape(ball)).surface.friction, 1.0);
  EXPECT_EQ(shape_of(shape(ball, "<surface><friction><ode><mu>0.4</mu></ode></friction></surface>")).surface.friction,
            0.4);
  const auto robot = with(shape(ball, "<surface><friction><ode><mu>0.4</mu><mu2>0.3</mu2></ode></friction></surface>"));
  EXPECT_TRUE(any_contains(robot.warnings, "friction differs by direction"));
}

TEST_F(SdfLink, LooksAsItsVisualsDo) {
  const std::string ball = "<sphere><radius>1</radius></sphere>";
  const auto seen = shape_of(shape(ball,
                                   "<material><ambient>0 0 0 1</ambient><diffuse>0.1 0.2 0.3 0.5</diffuse></material>"
                                   "<transparency>0.5</transparency>",
                                   "visual"));
  EXPECT_FALSE(seen.collides);
  EXPECT_EQ(seen.color, (Color{0.1, 0.2, 0.3, 0.25}));
  EXPECT_EQ(shape_of(shape(ball, "<material><ambient>0 0 1 1</ambient></material>", "visual")).color,
            (Color{0, 0, 1, 1}));
}

TEST_F(SdfLink, TouchesOtherLinksOnlyWithSelfCollide) {
  const std::string ball = shape("<sphere><radius>1</radius></sphere>");
  EXPECT_EQ(with(ball).bodies.at(0).shapes.at(0).placed.contact_type, 2u);
  EXPECT_EQ(with(ball, "<self_collide>true</self_collide>").bodies.at(0).shapes.at(0).placed.contact_type, 1u);
}

TEST_F(SdfLink, HasMeshes) {
  write("meshes/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const std::string mesh = "<mesh><uri>meshes/m.obj</uri><scale>2 2 2</scale></mesh>";
  const auto robot = with(shape(mesh) + shape(mesh, "", "visual"));
  EXPECT_TRUE(std::holds_alternative<Convex>(robot.bodies.at(0).shapes.at(0).placed.shape));
  ASSERT_EQ(robot.bodies[0].visuals.size(), 1u);
  ASSERT_EQ(robot.meshes.size(), 1u);
  expect_near(robot.meshes[0].scale, {2, 2, 2});
  EXPECT_TRUE(any_contains(with(shape("<mesh><uri>model://no/m.obj</uri></mesh>", "", "visual")).warnings,
                           "there is no mesh file"));
  EXPECT_TRUE(contains(message(model(link("a", shape("<mesh><uri>no.obj</uri></mesh>")))),
                       "robot.sdf:2: there is no mesh file"));
}

// Rule: sdformat's specification, material/pbr/metal/albedo_map; without a material the mesh's own ones count.
TEST_F(SdfLink, ShowsTexturesOfMeshes) {
  write("meshes/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  write("meshes/skin.png", "");
  const auto visual = [](const std::string& material) {
    return with(shape("<mesh><uri>meshes/m.obj</uri></mesh>", material, "visual")).bodies.at(0).visuals.at(0);
  };
  const auto map = [](const std::string& name, const std::string& more = "") {
    return "<material>" + more + "<pbr><metal><albedo_map>" + name + "</albedo_map></metal></pbr></material>";
  };
  const auto skin = visual(map("meshes/skin.png"));
  EXPECT_EQ(std::filesystem::path(skin.picture).filename(), "skin.png");
  EXPECT_EQ(skin.color, (Color{1, 1, 1}));
  EXPECT_EQ(visual(map("meshes/skin.png", "<diffuse>0 1 0 1</diffuse>")).color, (Color{0, 1, 0}));
  EXPECT_EQ(visual(map("lost.png")).picture, "");
  EXPECT_FALSE(skin.mesh_colors);
  EXPECT_TRUE(visual("").mesh_colors);
}

TEST_F(SdfLink, CarriesSensors) {
  const auto robot = with(
      "<sensor name='i' type='imu'><pose relative_to='f'>0 0 1 0 0 0</pose><update_rate>100</update_rate>"
      "<imu><angular_velocity><x><noise type='gaussian'><stddev>0.1</stddev></noise></x></angular_velocity></imu>"
      "</sensor><sensor name='c' type='camera'><camera><horizontal_fov>1</horizontal_fov><image><width>64"
      "</width><height>48</height></image></camera></sensor>",
      "<frame name='f'><pose>5 0 0 0 0 0</pose></frame>");
  ASSERT_EQ(robot.sensors.size(), 2u);
  EXPECT_EQ(robot.sensors[0].kind, "imu");
  EXPECT_EQ(robot.sensors[0].frame, "a");
  EXPECT_EQ(robot.sensors[0].rate, 100);
  expect_near(robot.sensors[0].place.position, {5, 0, 1});
  EXPECT_EQ(robot.sensors[0].signals.at("gyroscope.x").noise, 0.1);
  EXPECT_EQ(robot.sensors[1].numbers.at("width"), 64);
  EXPECT_TRUE(robot.warnings.empty());
}

TEST_F(SdfLink, CarriesSensorsOfJoints) {
  const auto robot =
      read(pair("revolute",
                "<pose>0 0 1 0 0 0</pose><axis><xyz>0 0 1</xyz></axis><sensor name='ft' type='force_torque'>"
                "<force_torque><frame>parent</frame></force_torque></sensor>"));
  ASSERT_EQ(robot.sensors.size(), 1u);
  EXPECT_EQ(robot.sensors[0].frame, "b");
  expect_near(robot.sensors[0].place.position, {0, 0, 1});
  EXPECT_EQ(robot.sensors[0].texts.at("axes"), "a");
}

}  // namespace
}  // namespace murosimf::robot_formats::sdf
