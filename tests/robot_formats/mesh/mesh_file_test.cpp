/// mesh_file_test - STL and OBJ files become the right triangles, and every error in them is named.
#include "murosimf/robot_formats/mesh/mesh_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/geometry/hull.h"
#include "murosimf/geometry/mesh_mass.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::mesh {
namespace {

using fixtures::error_of;
using fixtures::says;

/// An own file for every test.
std::filesystem::path test_file(const std::string& ending) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return fixtures::temp_folder() / (std::string("mesh_") + test->name() + ending);
}

std::filesystem::path write(const std::string& bytes, const std::string& ending) {
  const auto file = test_file(ending);
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

MeshFile read(const std::string& bytes, const std::string& ending) { return read_mesh_file(write(bytes, ending)); }

/// The error of the reader; it must be one line that begins with the file's name.
std::string complaint(const std::filesystem::path& file) {
  const std::string what = error_of([&] { (void)read_mesh_file(file); });
  EXPECT_TRUE(what.starts_with(file.string() + ":")) << what;
  EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  return what.substr(std::min(what.size(), file.string().size()));
}
std::string complaint(const std::string& bytes, const std::string& ending) { return complaint(write(bytes, ending)); }

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

std::string stl_header(std::uint32_t count, const std::string& title = "binary") {
  std::string bytes = title;
  bytes.resize(80, ' ');
  append(bytes, count);
  return bytes;
}

std::string binary_stl(const geometry::TriangleMesh& mesh, const std::string& title = "binary") {
  std::string bytes = stl_header(static_cast<std::uint32_t>(mesh.triangles.size()), title);
  for (const auto& corners : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0F);
    for (const auto corner : corners) {
      const Vec3d& v = mesh.vertices[corner];
      for (const double x : {v.x, v.y, v.z}) append(bytes, static_cast<float>(x));
    }
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string ascii_stl(const geometry::TriangleMesh& mesh) {
  std::string text = "solid a cube of facets\n";
  for (const auto& corners : mesh.triangles) {
    text += "  facet normal nan nan nan\n    outer loop\n";
    for (const auto corner : corners) {
      const Vec3d& v = mesh.vertices[corner];
      text += fmt::format("      vertex {:e} {:e} {:e}\r\n", v.x, v.y, v.z);
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid\n";
}

/// From (1, 2, 3) to (2, 4, 6).
geometry::TriangleMesh block() {
  std::vector<Vec3d> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({1.0 + (i & 1), 2.0 + (i & 2), i & 4 ? 6.0 : 3.0});
  const auto [hull, middle, error] = geometry::make_hull(corners);
  auto mesh = geometry::triangles_of(hull);
  for (Vec3d& v : mesh.vertices) v += middle;
  return mesh;
}

void expect_block(const MeshFile& file) {
  EXPECT_EQ(file.mesh.vertices.size(), 8U);
  EXPECT_EQ(file.mesh.triangles.size(), 12U);
  EXPECT_TRUE(geometry::find_seams(file.mesh).closed());
  const auto solid = geometry::solid_mass(file.mesh);
  EXPECT_NEAR(solid.volume, 6, 1e-13);
  EXPECT_LT(norm(solid.center - Vec3d{1.5, 3, 4.5}), 1e-13);
}

const std::string obj_block = R"(# a block
mtllib block.mtl
o block
v 1 2 3
v +2 2 3 1.0
v 2.0 4 3 0.5 0.5 0.5
v 1 4e0 3
v 1 2 6
v 2 2 6
v 2 4 6
v 1 4 6
vn 0 0 1
vt 0.5 0.5
usemtl steel
s off
f 4 3 2 1
f 5//1 6//1 7//1 8//1
f 1/1 2/1 6/1 5/1
f 2/1/1 3/1/1 \
  7/1/1 6/1/1
f -6 -5 -1 -2   # as seen from the last vertex
f 4 1 5 8)";

TEST(MeshFile, ReadsBinaryStl) { expect_block(read(binary_stl(block()), ".stl")); }

TEST(MeshFile, ReadsBinaryStlThatBeginsWithSolidOrHasMoreBytesThanNeeded) {
  expect_block(read(binary_stl(block(), "solid made by a program"), ".STL"));
  expect_block(read(binary_stl(block(), "solid made by a program") + "more", ".stl"));
}

TEST(MeshFile, ReadsAsciiStlWithLineEndsOfEitherKind) {
  expect_block(read(ascii_stl(block()), ".stl"));
  std::string one_row = ascii_stl(block());
  std::ranges::replace(one_row.begin() + 30, one_row.end(), '\n', ' ');
  expect_block(read(one_row, ".stl"));
}

TEST(MeshFile, ReadsSeveralSolidsOfAnAsciiStlAsOne) {
  const auto file = read(ascii_stl(block()) + "\n" + ascii_stl(block()), ".stl");
  EXPECT_EQ(file.mesh.triangles.size(), 24U);
  EXPECT_EQ(file.mesh.vertices.size(), 8U);
}

TEST(MeshFile, ReadsPolygonsAndRelativeCornersOfObj) {
  expect_block(read(obj_block, ".obj"));
  expect_block(read(obj_block + "\n", ".OBJ"));
}

TEST(MeshFile, PartsAreObjectsAndGroupsThatHaveFaces) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 2\nf 1 2 3\no a\ng a\nf 1 2 3 4\no empty\n"
      "g b\nf 2 3 5\no end\n";
  const auto file = read(text, ".obj");
  const auto parts = split_parts(file);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].triangles.size(), 1U);
  EXPECT_EQ(parts[1].triangles.size(), 2U);
  EXPECT_EQ(parts[2].triangles.size(), 1U);
  EXPECT_EQ(parts[1].vertices.size(), 4U);
  EXPECT_EQ(parts[2].vertices[2].z, 2);
  EXPECT_EQ(split_parts(read(obj_block, ".obj")).size(), 1U);
  EXPECT_EQ(split_parts(read(binary_stl(block()), ".stl")).size(), 1U);
}

TEST(MeshFile, DropsVerticesOfNoTriangleAndTheSignOfZero) {
  const auto file = read("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 0 -0.0\nv 0 0 1\nf 2 3 4\nf 5 3 6\n", ".obj");
  EXPECT_EQ(file.mesh.vertices.size(), 4U);
}

TEST(MeshFile, RefusesWhatIsNoMeshFile) {
  EXPECT_TRUE(says(complaint(test_file("missing.stl")), {"there is no such file"}));
  const auto folder = test_file("folder.stl");
  std::filesystem::create_directories(folder);
  EXPECT_TRUE(says(complaint(folder), {"folder"}));
  EXPECT_TRUE(says(complaint("", ".stl"), {"empty"}));
  EXPECT_TRUE(says(complaint("", ".obj"), {"empty"}));
  EXPECT_TRUE(says(complaint("x", ".ply"), {"unknown kind", "'.ply'", ".stl, .obj or .dae"}));
  EXPECT_TRUE(says(complaint("x", ""), {"unknown kind"}));
}

TEST(MeshFile, RefusesFilesWithoutTriangles) {
  EXPECT_TRUE(says(complaint(stl_header(0), ".stl"), {"no triangles"}));
  EXPECT_TRUE(says(complaint("solid x\nendsolid x\n", ".stl"), {"no triangles"}));
  EXPECT_TRUE(says(complaint("solid", ".stl"), {"no triangles"}));
  EXPECT_TRUE(says(complaint("v 0 0 0\n", ".obj"), {"no triangles"}));
}

TEST(MeshFile, RefusesBinaryStlThatIsCutOff) {
  const std::string bytes = binary_stl(block());
  EXPECT_TRUE(says(complaint(bytes.substr(0, bytes.size() - 1), ".stl"), {"cut off", "12 triangles", "684", "683"}));
  EXPECT_TRUE(says(complaint(bytes.substr(0, 83), ".stl"), {"header", "83 bytes"}));
  EXPECT_TRUE(says(complaint(binary_stl(block(), "solid").substr(0, 200), ".stl"), {"cut off"}));
  EXPECT_TRUE(says(complaint("plain text", ".stl"), {"header"}));
}

TEST(MeshFile, RefusesTenMillionTrianglesFromTheHeaderAlone) {
  const auto claimed = complaint(stl_header(10'000'000), ".stl");
  EXPECT_TRUE(says(claimed, {"10000000 triangles", "at most 1000000", "simplify"}));
  const auto file = write(stl_header(10'000'000, "solid"), ".stl");
  std::filesystem::resize_file(file, 84 + 50 * std::uintmax_t{10'000'000});  // a hole that takes no disk
  EXPECT_TRUE(says(complaint(file), {"10000000 triangles", "at most 1000000", "simplify"}));
  std::filesystem::remove(file);
}

TEST(MeshFile, RefusesTextThatNeverEndsItsLine) {
  const auto file = write("v 0 0 0\n", ".obj");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 28);
  EXPECT_TRUE(says(complaint(file), {":2: ", "too long"}));
  std::filesystem::remove(file);
}

TEST(MeshFile, RefusesMoreTrianglesInTextThanTheLimit) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (std::size_t i = 0; i <= most_triangles; ++i) text += "f 1 2 3\n";
  EXPECT_TRUE(says(complaint(text, ".obj"), {":1000004: ", "more than 1000000 triangles", "simplify"}));
  std::filesystem::remove(test_file(".obj"));
}

TEST(MeshFile, RefusesNumbersThatAreNone) {
  std::string bytes = binary_stl(block());
  const float nan = std::nanf("");
  std::memcpy(bytes.data() + 84 + 50 * 4 + 12, &nan, 4);
  EXPECT_TRUE(says(complaint(bytes, ".stl"), {"triangle 5", "not finite", "nan"}));
  const std::string facet = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  EXPECT_TRUE(says(complaint(facet + "vertex 0 nan 0\n", ".stl"), {":5: ", "'nan'", "not a finite number"}));
  EXPECT_TRUE(says(complaint(facet + "vertex 0 1,5 0\n", ".stl"), {":5: ", "'1,5'", "not a number"}));
  EXPECT_TRUE(says(complaint(facet + "vertex 0 1\n", ".stl"), {":5: ", "lacks a number"}));
  EXPECT_TRUE(says(complaint("v 0 0 0\nv 0 -inf 0\n", ".obj"), {":2: ", "'-inf'", "not a finite number"}));
  EXPECT_TRUE(says(complaint("v 0 0 0\nv 0 1e999 0\n", ".obj"), {":2: ", "'1e999'", "not a finite number"}));
  EXPECT_TRUE(says(complaint("v 0 x 0\n", ".obj"), {":1: ", "'x'", "not a number"}));
  EXPECT_TRUE(says(complaint("v 0 0\n", ".obj"), {":1: ", "lacks a number"}));
}

TEST(MeshFile, RefusesAsciiStlThatIsNoRowOfTriangles) {
  const std::string start = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  EXPECT_TRUE(says(complaint(start + "endloop\n", ".stl"), {":6: ", "2 vertices instead of three"}));
  EXPECT_TRUE(says(complaint(start + "vertex 0 1 0\nvertex 1 1 0\n", ".stl"), {":7: ", "more than three"}));
  EXPECT_TRUE(says(complaint(start, ".stl"), {"ends inside a triangle"}));
  EXPECT_TRUE(says(complaint("solid\nfact normal\n", ".stl"), {":2: ", "unknown word 'fact'"}));
}

TEST(MeshFile, RefusesFacesOfObjThatNameNoVertices) {
  const std::string start = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_TRUE(says(complaint(start + "f 1 2 4\n", ".obj"), {":4: ", "'4'", "3 vertices"}));
  EXPECT_TRUE(says(complaint(start + "f 1 2 0\n", ".obj"), {":4: ", "'0'"}));
  EXPECT_TRUE(says(complaint(start + "f 1 2 -4\n", ".obj"), {":4: ", "'-4'"}));
  EXPECT_TRUE(says(complaint(start + "f 1 2 99999999999999999999\n", ".obj"), {":4: ", "99999999999999999999"}));
  EXPECT_TRUE(says(complaint(start + "f 1 2 x\n", ".obj"), {":4: ", "'x'", "not a vertex number"}));
  EXPECT_TRUE(says(complaint(start + "f 1 2\n", ".obj"), {":4: ", "2 vertices"}));
}

/// A tetrahedron with normals and texture coordinates, which are skipped; `last`: the last corner of its last face.
std::string msh(std::int32_t last = 3, std::int32_t faces = 4) {
  std::string bytes;
  for (const std::int32_t count : {4, 4, 4, faces}) append(bytes, count);
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 2.F, 0.F, 0.F, 0.F, 3.F}) append(bytes, x);
  for (int i = 0; i < 4 * 3 + 4 * 2; ++i) append(bytes, 7.F);
  for (const std::int32_t corner : {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, last}) append(bytes, corner);
  return bytes;
}

TEST(MeshFile, ReadsTheBinaryFormatOfMujoco) {
  const MeshFile file = read(msh(), ".msh");
  EXPECT_EQ(file.mesh.vertices.size(), 4U);
  EXPECT_EQ(file.mesh.triangles.size(), 4U);
  EXPECT_NEAR(geometry::solid_mass(file.mesh).volume, 1.0, 1e-12) << "a sixth of 1 x 2 x 3";
  EXPECT_TRUE(says(complaint(msh(4), ".msh"), {"a face names vertex 4", "there are 4"}));
  EXPECT_TRUE(says(complaint(msh(3, 5), ".msh"), {"its header asks for", "export it anew"}));
  EXPECT_TRUE(says(complaint(msh(3, -1), ".msh"), {"count 4 of its header is -1"}));
  EXPECT_TRUE(says(complaint("abc", ".msh"), {"inside its header"}));
}

}  // namespace
}  // namespace murosimf::robot_formats::mesh
