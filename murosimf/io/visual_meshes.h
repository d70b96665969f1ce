/// visual_meshes.h - meshes for the eye (model/visual_mesh.h) as triangles: here their files are read.
#pragma once

#include "murosimf/geometry/triangle_mesh.h"
#include "murosimf/io/robot_draft.h"
#include "murosimf/model/visual_mesh.h"

namespace murosimf::io {

/// The meshes for the eye of a body of the draft, in the body's frame. Left out is what stands in the robot file itself.
[[nodiscard]] Visuals visuals_of(const RobotDraft& draft, const DraftBody& body);

/// All triangles of the mesh, in the frame of its object; corners at the same place are one vertex. Throws SetupError:
/// mesh file, line if there is one, what is wrong, what to do.
[[nodiscard]] geometry::TriangleMesh visual_triangles(const VisualMesh& mesh);

}  // namespace murosimf::io
