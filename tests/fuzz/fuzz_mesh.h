/// fuzz_mesh.h - a mesh file, and what a robot makes of it: parts, hulls and masses.
#pragma once

#include "murosimf/geometry/hull.h"
#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"
#include "tests/fuzz/fuzz.h"

namespace murosimf::fuzz {

inline void feed_mesh(const std::uint8_t* data, std::size_t size, const std::string& extension) {
  feed(data, size, extension, [](const auto& file) {
    for (const geometry::TriangleMesh& part :
         robot_formats::mesh::split_parts(robot_formats::mesh::read_mesh_file(file))) {
      (void)geometry::summed_mass(part);
      if (geometry::find_seams(part).closed()) (void)geometry::solid_mass(part);
      (void)geometry::solid_mass(geometry::make_hull(part.vertices).hull);
    }
  });
}

}  // namespace murosimf::fuzz
