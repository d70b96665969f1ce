/// gl_meshes.h - solids in the graphics device's memory, drawn by instance.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/render/instances.h"
#include "murosimf/render/opengl/gl_attributes.h"
#include "murosimf/render/opengl/gl_handles.h"

namespace murosimf::render {

/// Corners of all solids in one buffer.
struct MeshBuffers {
  struct Range {
    std::size_t first_index = 0, indices = 0;
    GLint first_corner = 0;
  };

  void fill(const MeshCatalog& catalog) {
    std::vector<Vertex> corners;
    std::vector<std::array<float, 2>> places;  // as many as reach to the last corner that has one
    std::vector<std::uint32_t> indices;
    for (const RenderMesh& solid : catalog.meshes) {
      ranges.push_back({indices.size(), solid.triangles.size(), static_cast<GLint>(corners.size())});
      if (solid.picture) {
        places.resize(corners.size());
        places.insert(places.end(), solid.places.begin(), solid.places.end());
      }
      corners.insert(corners.end(), solid.corners.begin(), solid.corners.end());
      indices.insert(indices.end(), solid.triangles.begin(), solid.triangles.end());
    }
    glBindVertexArray(*array);
    upload(GL_ELEMENT_ARRAY_BUFFER, *index_buffer, indices, GL_STATIC_DRAW);
    upload(GL_ARRAY_BUFFER, *corner_buffer, corners, GL_STATIC_DRAW);
    attribute(0, 3, GL_FLOAT, sizeof(Vertex), offsetof(Vertex, place), false);
    attribute(1, 3, GL_FLOAT, sizeof(Vertex), offsetof(Vertex, normal), false);
    if (places.empty()) return;
    places.resize(corners.size());
    upload(GL_ARRAY_BUFFER, *place_buffer, places, GL_STATIC_DRAW);
    attribute(8, 2, GL_FLOAT, sizeof(places[0]), 0, false);
  }

  /// Loads the instances of the following calls of draw().
  void load(std::span<const Instance> instances) {
    glBindBuffer(GL_ARRAY_BUFFER, *instance_buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(), GL_STREAM_DRAW);
  }

  void draw(std::span<const InstanceGroup> groups) {
    glBindVertexArray(*array);
    glBindBuffer(GL_ARRAY_BUFFER, *instance_buffer);
    for (const InstanceGroup& group : groups) {
      const std::size_t base = group.first * sizeof(Instance);
      const auto place = [&](GLuint index, GLint numbers, GLenum type, std::size_t offset, bool normalized = false) {
        attribute(index, numbers, type, sizeof(Instance), base + offset, true, normalized);
      };
      place(2, 4, GL_FLOAT, offsetof(Instance, row_x));
      place(3, 4, GL_FLOAT, offsetof(Instance, row_y));
      place(4, 4, GL_FLOAT, offsetof(Instance, row_z));
      place(5, 3, GL_FLOAT, offsetof(Instance, normal_scale));
      place(6, 4, GL_UNSIGNED_BYTE, offsetof(Instance, color), true);
      place(7, 1, GL_UNSIGNED_INT, offsetof(Instance, label));
      MUROSIMF_ASSERT(group.solid < ranges.size());
      const Range& range = ranges[group.solid];
      glDrawElementsInstancedBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(range.indices), GL_UNSIGNED_INT,
                                        reinterpret_cast<const void*>(range.first_index * sizeof(std::uint32_t)),
                                        static_cast<GLsizei>(group.count), range.first_corner);
    }
  }

  std::vector<Range> ranges;
  GlVertexArray array;
  GlBuffer corner_buffer, place_buffer, index_buffer, instance_buffer;
};

}  // namespace murosimf::render
