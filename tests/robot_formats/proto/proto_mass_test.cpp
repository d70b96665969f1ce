/// proto_mass_test - masses and shapes against closed forms.
#include <cmath>

#include "tests/robot_formats/proto/proto_files.h"

namespace murosimf::robot_formats::proto {
namespace {

using namespace proto_files;

const robot_formats::MassProperties& solid_of(const robot_formats::RobotDescription& description) {
  return description.bodies.at(0).solid;
}

void expect_inertia(const SymMat3d& I, const SymMat3d& other, double tolerance = 1e-12) {
  expect_near({I.xx, I.yy, I.zz}, {other.xx, other.yy, other.zz}, tolerance);
  expect_near({I.xy, I.xz, I.yz}, {other.xy, other.xz, other.yz}, tolerance);
}

TEST(ProtoPhysics, FillsABoxWithItsDensity) {
  const auto description =
      read(block("Pose { translation 1 0 0 children [ Box { size 0.1 0.2 0.3 } ] }", "density 500"));
  const double m = 500 * 0.1 * 0.2 * 0.3;
  EXPECT_NEAR(solid_of(description).mass, m, 1e-12);
  expect_near(solid_of(description).center, {1, 0, 0});
  expect_inertia(solid_of(description).inertia, {m / 12 * 0.13, m / 12 * 0.10, m / 12 * 0.05});
}

TEST(ProtoPhysics, CountsOverlapsTwiceAndWaterIsTheUsualDensity) {
  const auto description = read(block("Group { children [ Sphere { radius 0.1 } Sphere { radius 0.1 } ] }", ""));
  EXPECT_NEAR(solid_of(description).mass, 2 * 1000 * 4.0 / 3 * pi * 1e-3, 1e-12);
}

TEST(ProtoPhysics, ScalesTheBoundingObjectToTheMass) {
  const auto description = read(block("Box { size 0.1 0.2 0.3 }", "density -1 mass 12 centerOfMass [ 0 0 0.5 ]"));
  expect_near(solid_of(description).center, {0, 0, 0.5});
  expect_inertia(solid_of(description).inertia, {0.13, 0.10, 0.05});
}

TEST(ProtoPhysics, TakesTheWrittenInertia) {
  const auto description = read(block("NULL", "mass 2 centerOfMass [ 1 2 3 ] inertiaMatrix [ 4 5 6, 0.1 0.2 0.3 ]"));
  expect_near(solid_of(description).center, {1, 2, 3});
  expect_inertia(solid_of(description).inertia, {4, 5, 6, 0.1, 0.2, 0.3});
  EXPECT_EQ(solid_of(read(block("Box { }", "mass 2 density 7"))).mass, 2);
}

TEST(ProtoPhysics, TurnsCylindersOfOldVersions) {
  const double r = 0.1, h = 0.4, m = 1000 * pi * r * r * h;
  const double along = m * r * r / 2, across = m * (3 * r * r + h * h) / 12;
  const std::string cylinder = "Cylinder { radius 0.1 height 0.4 }";
  expect_inertia(solid_of(read(block(cylinder, ""))).inertia, {across, across, along});
  const auto old = read(block(cylinder, "", "R2021b"));
  expect_inertia(solid_of(old).inertia, {across, along, across});
  EXPECT_TRUE(any_contains(old.notes, "robot.proto:1: of Webots R2021: cylinders and capsules along y"));
}

TEST(ProtoPhysics, FillsHullsOfFaces) {
  const auto description =
      read(block("Transform { scale 2 2 2 children [ Shape { geometry IndexedFaceSet { coord Coordinate { "
                 "point [ 0 0 0 1 0 0 0 1 0 0 0 1 ] } coordIndex [ 0 2 1 -1 ] } } ] }",
                 "density 3"));
  EXPECT_NEAR(solid_of(description).mass, 3 * 8.0 / 6, 1e-12);
  expect_near(solid_of(description).center, {0.5, 0.5, 0.5});
  EXPECT_EQ(description.bodies[0].shapes.size(), 1u);
}

TEST(ProtoPhysics, ScalesAndMirrorsMeshes) {
  write("tetra.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const auto description =
      read(block("Transform { scale 2 -1 3 translation 0 0 1 children [ Pose { translation 1 1 1 children [ Mesh { url "
                 "\"tetra.obj\" } ] } ] }",
                 "density 1"));
  EXPECT_NEAR(solid_of(description).mass, 1, 1e-12);
  expect_near(solid_of(description).center, {2 + 2.0 / 4, -1 - 1.0 / 4, 1 + 3 + 3.0 / 4});
}

TEST(ProtoPhysics, ReadsMeshesBesideTheFile) {
  write("tetra.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const auto description = read(block("Mesh { url [ \"tetra.obj\" ] }", "density 6"));
  EXPECT_NEAR(solid_of(description).mass, 1, 1e-12);
  EXPECT_EQ(description.meshes.at(0).name, "tetra");
  EXPECT_TRUE(
      contains(message(block("Mesh { url \"none.obj\" }", "")), "robot.proto:3: there is no mesh file 'none.obj'"));
}

TEST(ProtoPhysics, RefusesWhatNoBodyHas) {
  struct Case {
    std::string text, message;
  };
  const std::vector<Case> cases{
      {block("NULL", "mass -2"), "robot.proto:4: mass -2 kg is negative"},
      {block("NULL", "density -1"), "robot.proto:4: Physics has neither mass nor density"},
      {block("NULL", "density 5"), "robot.proto:4: Physics has a density, but its Solid has no boundingObject"},
      {block("NULL", "mass 1 inertiaMatrix [ 1 1 1 ]"), "robot.proto:4: inertiaMatrix has 3 numbers"},
      {block("NULL", "mass 1 inertiaMatrix [ 1 1 0, 0 0 0 ]"), "robot.proto:4: moments of inertia must be more than 0"},
      {block("Box { size 1 0 1 }", "mass 1"), "robot.proto:3: size of Box must be three numbers more than 0"},
      {block("Sphere { radius -1 }", "mass 1"), "robot.proto:3: radius of Sphere is -1; it must be more than 0"},
      {block("Transform { scale 1 2 1 children [ Sphere { } ] }", "mass 1"),
       "robot.proto:3: Sphere in a Transform with scale 1 2 1; write out its size"},
      {block("Transform { scale 1 2 1 children [ Pose { rotation 0 0 1 1 children [ Box { } ] } ] }", "mass 1"),
       "robot.proto:3: Pose turns what a Transform around it scales by 1 2 1"},
      {block("Transform { scale 0 1 1 children [ Box { } ] }", "mass 1"), "robot.proto:3: scale must not be 0"},
      {block("NULL", "mas 1"),
       "robot.proto:4: unknown field of Physics 'mas'; did you mean 'mass'? (--lenient reads on)"},
      {block("Plane { }", "mass 1"), "robot.proto:3: Plane as boundingObject is not supported"},
  };
  for (const auto& [text, expected] : cases) EXPECT_TRUE(contains(message(text), expected)) << message(text);
  EXPECT_TRUE(any_contains(read(block("Plane { }", "mass 1"), {.lenient = true}).warnings, "Plane as boundingObject"));
  EXPECT_TRUE(any_contains(read(block("NULL", "mass 1 inertiaMatrix [ 1 1 9, 0 0 0 ]")).warnings,
                           "robot.proto:4: no solid body has the principal moments 1 1 9"));
}

TEST(ProtoShapes, AreForContactAndForTheEye) {
  const auto description =
      read(robot("Pose { translation 0 0 1 rotation 0 0 2 1.5707963267948966 children [ Shape { appearance "
                 "PBRAppearance { baseColor 1 0.5 0 transparency 0.25 } geometry Capsule { radius 0.1 "
                 "height 0.4 } } ] }\nShape { appearance Appearance { material Material { } } geometry Cone { } }"));
  const auto& shapes = description.bodies.at(0).shapes;
  ASSERT_EQ(shapes.size(), 1u);
  EXPECT_FALSE(shapes[0].placed.collides);
  EXPECT_EQ(shapes[0].placed.color, (Color{1, 0.5, 0, 0.75}));
  EXPECT_EQ(std::get<Capsule>(shapes[0].placed.shape).half_length, 0.2);
  expect_near(shapes[0].placed.position, {0, 0, 1});
  expect_near(shapes[0].placed.orientation.x, {0, 1, 0});
  EXPECT_TRUE(names_unused(description, "robot.proto:6: Cone for the eye is not drawn"));
  const auto uneven = read(robot("Transform { scale 1 2 3 children [ Shape { geometry Sphere { } } ] }"));
  EXPECT_TRUE(names_unused(uneven, "robot.proto:5: Sphere for the eye with an uneven scale is not drawn"));
}

TEST(ProtoShapes, OfOneRobotTouchEachOtherOnlyIfItSaysSo) {
  const auto shapes_of = [](const std::string& word) {
    return read("PROTO P [ ] { Robot { selfCollision " + word +
                " boundingObject Group { children [ Box { } Box { } ] } } }")
        .bodies.at(0)
        .shapes;
  };
  const auto apart = shapes_of("FALSE"), touching = shapes_of("TRUE");
  EXPECT_FALSE(may_touch(apart.at(0).placed, apart.at(1).placed));
  EXPECT_TRUE(may_touch(touching.at(0).placed, touching.at(1).placed));
  EXPECT_TRUE(may_touch(apart[0].placed, PlacedShape{}));  // the ground
}

}  // namespace
}  // namespace murosimf::robot_formats::proto
