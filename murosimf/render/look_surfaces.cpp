#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/random.h"
#include "murosimf/render/look.h"

namespace murosimf::render {
namespace {

constexpr int pieces_across = 10, pieces_back = 8;  // of a net
constexpr double sag = 0.10;                        // [1] of the depth of a net
constexpr double usual_half = 4;                    // [m] of a hall without a field

LookCorner corner(const Vec3d& place, double u, double v) {
  return {{static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)},
          {static_cast<float>(u), static_cast<float>(v)}};
}

/// Adds the quadrilateral of four corners, counterclockwise.
void add_quad(LookSurface& surface, const std::array<LookCorner, 4>& corners) {
  const auto first = static_cast<std::uint32_t>(surface.corners.size());
  surface.corners.insert(surface.corners.end(), corners.begin(), corners.end());
  surface.triangles.insert(surface.triangles.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
}

/// A point of the line from the crossbar to the bar at the back, from above to below.
struct Slope {
  double x = 0, z = 0, length = 0;  // [m]; length: from the crossbar
};

/// Back from the crossbar, sagging, then down to the bar behind, a little slack.
std::vector<Slope> slope_of(const GoalNet& net) {
  std::vector<Slope> slope;
  for (int i = 0; i <= pieces_back; ++i) {
    const double t = 2.0 * i / pieces_back, back = std::min(1.0, t), down = std::max(0.0, t - 1);
    const double slack = 4 * sag * (net.rear - net.front);
    Slope point{net.front + back * (net.rear - net.front) - slack * down * (1 - down),
                net.high - down * (net.high - net.low) - slack * back * (1 - back)};
    if (i > 0) point.length = slope.back().length + std::hypot(point.x - slope.back().x, point.z - slope.back().z);
    slope.push_back(point);
  }
  return slope;
}

/// Top and back.
void add_back(LookSurface& surface, const GoalNet& net, const std::vector<Slope>& slope) {
  for (std::size_t i = 0; i + 1 < slope.size(); ++i) {
    for (int k = 0; k < pieces_across; ++k) {
      const auto at = [&](const Slope& p, int step) {
        const double y = net.half_width * (2.0 * step / pieces_across - 1);
        return corner({net.side * p.x, y, p.z}, y, p.length);
      };
      add_quad(surface, {at(slope[i], k), at(slope[i], k + 1), at(slope[i + 1], k + 1), at(slope[i + 1], k)});
    }
  }
}

/// From the line down to the bars on the ground.
void add_sides(LookSurface& surface, const GoalNet& net, const std::vector<Slope>& slope) {
  for (const double y : {-net.half_width, net.half_width}) {
    for (std::size_t i = 0; i + 1 < slope.size(); ++i) {
      const auto at = [&](const Slope& p, double z) { return corner({net.side * p.x, y, z}, p.x, z); };
      add_quad(surface, {at(slope[i], slope[i].z), at(slope[i + 1], slope[i + 1].z), at(slope[i + 1], net.low),
                         at(slope[i], net.low)});
    }
  }
}

/// Wraps around at the borders.
double at(const std::vector<double>& square, int row, int column) {
  const int n = pile_side;
  return square[static_cast<std::size_t>((row + n) % n * n + (column + n) % n)];
}

/// The mean of the neighbors within reach.
std::vector<double> mean_around(const std::vector<double>& square, int rows, int columns) {
  std::vector<double> mean;
  for (int row = 0; row < pile_side; ++row) {
    for (int column = 0; column < pile_side; ++column) {
      double sum = 0;
      for (int i = -rows; i <= rows; ++i) {
        for (int k = -columns; k <= columns; ++k) sum += at(square, row + i, column + k);
      }
      mean.push_back(sum / ((2 * rows + 1) * (2 * columns + 1)));
    }
  }
  return mean;
}

/// Noise in short fibers, without slow waves: from far it becomes even, and its repetition is not seen.
std::vector<std::uint8_t> make_pile() {
  constexpr double depth = 95;  // [1] of 128
  const RandomStream random(1, "pile");
  std::vector<double> noise;
  for (std::uint64_t i = 0; i < std::uint64_t{pile_side} * pile_side; ++i) noise.push_back(random.uniform(i, -1, 1));
  const std::vector<double> fibers = mean_around(noise, 1, 0), slow = mean_around(fibers, 4, 4);
  std::vector<std::uint8_t> heights;
  for (std::size_t i = 0; i < fibers.size(); ++i) {
    heights.push_back(
        static_cast<std::uint8_t>(std::lround(std::clamp(128 + depth * (fibers[i] - slow[i]), 0.0, 255.0))));
  }
  return heights;
}

}  // namespace

HallSize hall_size(const Surroundings& surroundings, const Markings* markings) {
  MUROSIMF_ASSERT(surroundings.clear >= 0);
  if (!markings) return {usual_half + surroundings.clear, usual_half + surroundings.clear};
  return {markings->half_length + surroundings.clear, markings->half_width + surroundings.clear};
}

LookSurface hall_walls(const Surroundings& surroundings, const Markings* markings) {
  LookSurface walls;
  const auto [x, y] = hall_size(surroundings, markings);
  const double h = surroundings.height;
  const std::array<Vec3d, 5> feet{Vec3d{-x, -y, 0}, {-x, y, 0}, {x, y, 0}, {x, -y, 0}, {-x, -y, 0}};
  for (std::size_t i = 0; i + 1 < feet.size(); ++i) {  // clockwise from above: the inside is in front
    const Vec3d &a = feet[i], &b = feet[i + 1], up{0, 0, h};
    const double half = 0.5 * norm(b - a);
    add_quad(walls, {corner(a, -half, 0), corner(b, half, 0), corner(b + up, half, h), corner(a + up, -half, h)});
  }
  return walls;
}

LookSurface hall_ceiling(const Surroundings& surroundings, const Markings* markings) {
  LookSurface ceiling;
  const auto [x, y] = hall_size(surroundings, markings);
  const double h = surroundings.height;
  add_quad(ceiling, {corner({-x, -y, h}, -x, -y), corner({-x, y, h}, -x, y), corner({x, y, h}, x, y),
                     corner({x, -y, h}, x, -y)});
  return ceiling;
}

LookSurface hanging_nets(const std::vector<GoalNet>& nets) {
  LookSurface surface;
  for (const GoalNet& net : nets) {
    const std::vector<Slope> slope = slope_of(net);
    add_back(surface, net, slope);
    add_sides(surface, net, slope);
  }
  return surface;
}

const std::vector<std::uint8_t>& pile() {
  static const std::vector<std::uint8_t> made = make_pile();
  return made;
}

}  // namespace murosimf::render
