/// build_manifold.h - points of a manifold from what faces each other along its normal.
#pragma once

#include "murosimf/geometry/outline.h"
#include "murosimf/geometry/segments.h"
#include "murosimf/geometry/spread.h"

namespace murosimf::geometry {

/// The normal that parts A and B with the least shift, from B to A, and that shift [m].
struct Penetration {
  Vec3d normal;
  double depth = 0;
};

/// How far a face may lean against the normal and still count as the side that carries: cosine of 2.5 degrees.
inline constexpr double flat = 0.999;
/// Edges that lean less than this against each other count as lying side by side: sine of 0.6 degrees.
inline constexpr double side_by_side = 0.01;

/// Starts a manifold anew.
void begin(const Penetration& penetration, Manifold& found);
/// A single point.
void only_point(const Penetration& penetration, const Vec3d& middle, std::uint32_t name, Manifold& found);
/// Two segments with rounded surroundings of radius [m], side by side: one point at each end of their overlap. False, and
/// no point, if they do not lie side by side.
bool add_side_by_side(const Penetration& penetration, const Segment& a, double radius_a, const Segment& b,
                      double radius_b, std::uint32_t name, Manifold& found);
/// No two points may have the same name; the deepest one gets the exact depth.
void finish(const Penetration& penetration, Manifold& found);

/// Points of `incident`, which was cut to the size of the face `reference`, where they are below it. `out`: the normal,
/// seen from the shape of the reference face.
template <int Most, int MostReference>
void add_points_below(const Outline<Most>& incident, const Outline<MostReference>& reference, const Vec3d& out,
                      Manifold& found) {
  const Vec3d upright = (1 / dot(reference.normal, out)) * reference.normal;
  const double height = dot(upright, reference.corners[0].point);
  const auto depth = [&](int i) { return height - dot(upright, incident.corners[i].point); };
  const auto point = [&](int i) { return incident.corners[i].point; };
  const Chosen chosen = choose_spread(incident.count, point, depth);
  for (int k = 0; k < chosen.count && found.count < Manifold::most_points; ++k) {
    const int i = chosen.index[k];
    found.points[found.count++] = {point(i) + 0.5 * depth(i) * out, depth(i),
                                   joined(incident.corners[i].name, reference.name)};
  }
}

}  // namespace murosimf::geometry
