#include "murosimf/render/shape_facets.h"

#include <algorithm>
#include <cmath>

namespace murosimf::render {
namespace {

constexpr int around = 24;  // facets of a round shape
constexpr int quarter = 6;  // facets from equator to pole

/// A point of a contour that is turned about z; contours run from -z to +z.
struct Turned {
  double radius, z;
};

Vec3d corner(const Turned& at, int i) {
  const double angle = 2 * pi * (i % around) / around;
  return {at.radius * std::cos(angle), at.radius * std::sin(angle), at.z};
}

/// Side facets, and caps where the contour does not begin or end on the axis.
std::vector<Facet> solid_of_revolution(const std::vector<Turned>& contour) {
  std::vector<Facet> facets;
  for (std::size_t k = 0; k + 1 < contour.size(); ++k) {
    const Turned &low = contour[k], &high = contour[k + 1];
    for (int i = 0; i < around; ++i) {
      Facet facet;
      facet.push_back(corner(low, i));
      if (low.radius > 0) facet.push_back(corner(low, i + 1));
      facet.push_back(corner(high, i + 1));
      if (high.radius > 0) facet.push_back(corner(high, i));
      facets.push_back(facet);
    }
  }
  Facet bottom, top;
  for (int i = 0; i < around; ++i) {
    if (contour.front().radius > 0) bottom.insert(bottom.begin(), corner(contour.front(), i));
    if (contour.back().radius > 0) top.push_back(corner(contour.back(), i));
  }
  for (const Facet& cap : {bottom, top}) {
    if (!cap.empty()) facets.push_back(cap);
  }
  return facets;
}

/// Two half balls around a straight part.
std::vector<Turned> capsule_contour(double radius, double half_length) {
  std::vector<Turned> contour;
  for (int k = -quarter; k <= quarter; ++k) {
    const double latitude = pi / 2 * k / quarter;
    const double r = std::abs(k) == quarter ? 0 : radius * std::cos(latitude);
    const double z = radius * std::sin(latitude);
    if (k == 0 && half_length > 0) contour.push_back({r, z - half_length});
    contour.push_back({r, z + (k >= 0 ? half_length : -half_length)});
  }
  return contour;
}

struct Facets {
  std::vector<Facet> operator()(const Sphere& s) const { return solid_of_revolution(capsule_contour(s.radius, 0)); }
  std::vector<Facet> operator()(const Capsule& s) const {
    return solid_of_revolution(capsule_contour(s.radius, s.half_length));
  }
  std::vector<Facet> operator()(const Cylinder& s) const {
    return solid_of_revolution({{s.radius, -s.half_length}, {s.radius, s.half_length}});
  }
  std::vector<Facet> operator()(const Ellipsoid& s) const {
    auto facets = (*this)(Sphere{1});
    for (Facet& facet : facets) {
      for (Vec3d& p : facet) p = {s.semi_axes.x * p.x, s.semi_axes.y * p.y, s.semi_axes.z * p.z};
    }
    return facets;
  }
  std::vector<Facet> operator()(const Box& s) const {
    const auto& [x, y, z] = s.half_size;
    return {{{x, -y, -z}, {x, y, -z}, {x, y, z}, {x, -y, z}}, {{-x, y, -z}, {-x, -y, -z}, {-x, -y, z}, {-x, y, z}},
            {{x, y, -z}, {-x, y, -z}, {-x, y, z}, {x, y, z}}, {{-x, -y, -z}, {x, -y, -z}, {x, -y, z}, {-x, -y, z}},
            {{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}}, {{-x, y, -z}, {x, y, -z}, {x, -y, -z}, {-x, -y, -z}}};
  }
  std::vector<Facet> operator()(const Plane&) const { return {}; }
  std::vector<Facet> operator()(const Convex& s) const {
    std::vector<Facet> facets;
    for (const auto& face : s.hull->faces) {
      Facet& facet = facets.emplace_back();
      for (const std::uint32_t i : face) facet.push_back(s.hull->vertices[i]);
    }
    return facets;
  }
};

double turn(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

std::vector<Facet> shape_facets(const Shape& shape) { return std::visit(Facets{}, shape); }

std::vector<Vec3d> outline(std::vector<Vec3d> points) {
  const auto less = [](const Vec3d& a, const Vec3d& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::sort(points.begin(), points.end(), less);
  std::vector<Vec3d> hull;
  const auto add_chain = [&hull](auto first, auto last) {
    const std::size_t start = hull.size();
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // begins the other chain
  };
  if (points.size() < 3) return {};
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace murosimf::render
