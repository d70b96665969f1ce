/// qhull_faces.h - one run of qhull: the faces of the convex hull of points.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace murosimf::geometry {

/// Each face as numbers of points, in order round it but in either direction. Nothing if qhull gives up (flat or broken
/// input) or a face has no simple outline. `coordinates`: x y z of each point, unchanged; `options`: "qhull ...".
[[nodiscard]] std::optional<std::vector<std::vector<std::uint32_t>>> qhull_faces(std::vector<double>& coordinates,
                                                                                 const std::string& options);

}  // namespace murosimf::geometry
