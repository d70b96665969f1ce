// A build without meshoptimizer.
#include "murosimf/geometry/edge_collapse.h"

namespace murosimf::geometry {

bool can_collapse_edges() { return false; }

TriangleMesh collapse_edges(const TriangleMesh& mesh, [[maybe_unused]] double error) { return mesh; }

}  // namespace murosimf::geometry
