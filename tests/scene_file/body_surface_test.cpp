// Bodies from tables of heights and meshes: what a scene says of them, and what is wrong with it.
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/collision/relief/relief.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/written_scene.h"

namespace murosimf {
namespace {

std::string one(const std::string& keys) { return fixtures::write_scene("[[bodies]]\nname = 'b'\n" + keys); }

std::string message_of(const std::string& keys) {
  try {
    const scene::Scene scene(one(keys));
  } catch (const SetupError& error) {
    return error.what();
  }
  return "";
}

/// A pyramid 0.3 m high whose base, of 0.2 m x 0.2 m, is at z = 0.1; in mm.
std::string pyramid(bool inside_out = false) {
  const auto file = fixtures::temp_folder() / (inside_out ? "turned.obj" : "pyramid.obj");
  std::ofstream out(file);
  out << "v -100 -100 100\nv 100 -100 100\nv 100 100 100\nv -100 100 100\nv 0 0 400\n";
  for (std::string face : {"1 2 5", "2 3 5", "3 4 5", "4 1 5", "1 4 3", "1 3 2"}) {
    if (inside_out) std::swap(face[0], face[2]);
    out << "f " << face << "\n";
  }
  return file.string();
}

const std::string field = "shape = 'heightfield'\nstatic = true\nsize = [1, 2]\n";

const collision::Relief& relief_of(const scene::Scene& scene) {
  const Model& model = scene.simulation().world().entity("field").model();
  return **model.find(properties::relief, *model.find_object("b"));
}

TEST(BodySurfaces, AreHeightsWithTheFirstRowAtTheLargestY) {
  const scene::Scene scene(one(field + "heights = [[0, 1, 2], [3, 4, 5]]\nheight_scale = 0.1\nthickness = 0.3\n"));
  const auto& vertices = relief_of(scene).mesh().vertices;
  const auto has = [&](const Vec3d& p) {
    return std::ranges::any_of(vertices, [&](const Vec3d& v) { return norm(v - p) < 1e-12; });
  };
  EXPECT_TRUE(has({-0.5, 1, 0}));
  EXPECT_TRUE(has({0.5, 1, 0.2}));
  EXPECT_TRUE(has({0, -1, 0.4}));
  EXPECT_TRUE(has({0.5, -1, -0.3})) << "the foot of a wall";
}

TEST(BodySurfaces, StandWhereTheirFileHasThem) {
  const scene::Scene scene(
      one("shape = 'mesh'\nstatic = true\nscale = 0.001\nposition = [1, 0, 0.5]\nfile = '" + pyramid() + "'\n"));
  const auto& mesh = relief_of(scene).mesh();
  EXPECT_EQ(mesh.triangles.size(), 6U);
  EXPECT_NEAR(std::ranges::max(mesh.vertices, {}, &Vec3d::z).z, 0.4, 1e-12);
  const Model& model = scene.simulation().world().entity("field").model();
  EXPECT_NEAR(model.placement(*model.find_object("b")).offset.z, 0.5, 1e-12);
}

TEST(BodySurfaces, ThatAreInsideOutAreTurnedRound) {
  const scene::Scene scene(one("shape = 'mesh'\nstatic = true\nscale = 0.001\nfile = '" + pyramid(true) + "'\n"));
  for (const auto& triangle : relief_of(scene).triangles()) {
    EXPECT_GT(dot(triangle.normal, triangle.corners[0] - Vec3d{0, 0, 0.2}), 0);
  }
}

// A pyramid's center of mass is a quarter of its height above its base; its box's middle is half of it.
TEST(BodySurfaces, ThatMoveAreHullsAboutTheirCenterOfMass) {
  const scene::Scene scene(one("shape = 'mesh'\nscale = 0.001\ndensity = 1000\nfile = '" + pyramid() + "'\n"));
  const Model& model = scene.simulation().world().entity("b").model();
  EXPECT_NEAR(*model.find(properties::mass, 0), 1000 * 0.2 * 0.2 * 0.3 / 3, 1e-9);
  const PlacedShape& hull = model.find(properties::shapes, 0)->front();
  double top = 0;
  for (const Vec3d& v : std::get<Convex>(hull.shape).hull->vertices) top = std::max(top, (hull.position + v).z);
  EXPECT_NEAR(top, 0.75 * 0.3, 1e-9);
}

TEST(BodySurfaces, ThatAreWrongAreRefusedInOneLine) {
  const auto says = [](const std::string& keys, const std::string& what) {
    const std::string message = message_of(keys);
    EXPECT_NE(message.find(what), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find(".toml:"), std::string::npos) << message;
  };
  says("shape = 'heightfield'\nsize = [1, 1]\nheights = [[0, 0], [0, 0]]\n", "needs static = true");
  says(field, "'file' of the heights is missing");
  says(field + "file = 'nothing.png'\n", "nothing.png");
  says(field + "file = 'nothing.png'\nheights = [[0, 0], [0, 0]]\n", "say the same");
  says(field + "heights = [[0, 0]]\n", "at least two of two");
  says(field + "heights = [[0, 0], [0]]\n", "rows of different lengths");
  says(field + "heights = [0, 0]\n", "must be rows of numbers");
  says(field + "heights = [[0, nan], [0, 0]]\n", "heights");
  says(field + "heights = [[0, 1], [0, 0]]\nheight_scale = 1e6\n", "more than 1000 m");
  says(field + "heights = [[0, 1], [0, 0]]\nthickness = 0\n", "above 0");
  says(field + "heights = [[0, 1], [0, 0]]\nmass = 1\n", "is nothing that a static body has");
  says(field + "heights = [[0, 1], [0, 0]]\nscale = 2\n", "is nothing that a heightfield has");
  says("shape = 'heightfield'\nstatic = true\nsize = [1, 1, 1]\nheights = [[0, 0], [0, 0]]\n", "two numbers above 0");
  says("shape = 'mesh'\nstatic = true\n", "of the mesh is missing");
  says("shape = 'mesh'\nstatic = true\nfile = 'nothing.stl'\n", "nothing.stl");
  says("shape = 'mesh'\nstatic = true\nfile = '" + pyramid() + "'\nscale = 10\n", "farther than 1000 m");
  says("shape = 'mesh'\nfile = '" + pyramid() + "'\nmass = 1\nscale = 0.001\nthickness = 1\n",
       "that a mesh that moves has");
  says("shape = 'box'\nsize = [1, 1, 1]\nmass = 1\nfile = 'a.png'\n", "is nothing that a box has");
}

}  // namespace
}  // namespace murosimf
