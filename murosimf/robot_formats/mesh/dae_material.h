/// dae_material.h - colors and pictures of the materials of a COLLADA file.
///
/// Read is the diffuse color or the file of the diffuse texture of the common profile (phong, lambert, blinn), colors as sRGB, which
/// exporters write. Opacity is that of `transparent` and `transparency`, as its `opaque` says (A_ONE, A_ZERO, RGB_ONE, RGB_ZERO); pictures of
/// it are not read. Source: COLLADA - Digital Asset Schema Release 1.4.1, specification.
#pragma once

#include <map>
#include <string>

#include "murosimf/robot_formats/mesh/dae_geometry.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mesh {

/// The materials that the use of a geometry (`instance_geometry`) binds, by their symbols there. What is not understood has no color.
[[nodiscard]] std::map<std::string, MeshMaterial> bound_materials(const files::XmlElement& use, const DaeIds& ids);

}  // namespace murosimf::robot_formats::mesh
