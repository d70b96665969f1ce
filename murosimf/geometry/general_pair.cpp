#include <ccd/ccd.h>

#include <cmath>

#include "murosimf/geometry/build_manifold.h"
#include "murosimf/geometry/pair_tests.h"
#include "murosimf/geometry/support.h"

namespace murosimf::geometry {
namespace {

Vec3d vec_of(const ccd_vec3_t& v) { return {v.v[0], v.v[1], v.v[2]}; }

void support_for_ccd(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const auto& body = *static_cast<const Body*>(object);
  const Vec3d d = vec_of(*direction);
  const Vec3d p = body.core_support(d) + (body.margin() / norm(d)) * d;
  ccdVec3Set(point, p.x, p.y, p.z);
}

}  // namespace

bool collide_general(const Shape& a, const Pose& at_a, const Shape& b, const Pose& at_b, Manifold& found) {
  const Body body_a(a, at_a), body_b(b, at_b);
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support_for_ccd;
  ccd.max_iterations = 200;
  ccd.epa_tolerance = 1e-7;
  double depth = 0;
  ccd_vec3_t direction, position;
  if (ccdGJKPenetration(&body_a, &body_b, &ccd, &depth, &direction, &position) != 0 || !(depth > 0)) return false;
  only_point({-vec_of(direction), depth}, vec_of(position), 0, found);
  return true;
}

}  // namespace murosimf::geometry
