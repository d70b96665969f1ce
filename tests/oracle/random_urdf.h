/// random_urdf.h - URDF files of random trees: every type of joint, turned masses, boxes.
#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "murosimf/math/random.h"

namespace murosimf::oracle {

/// Draws the numbers of a robot of 2 to 16 links.
class RandomUrdf {
 public:
  explicit RandomUrdf(std::uint64_t seed) : random_(seed, "random_robot") {}

  std::string text() {
    std::string text = "<robot name='random'>" + link(0);
    const int links = 2 + static_cast<int>(uniform(0, 15));
    for (int i = 1; i < links; ++i) text += link(i) + joint(i);
    return text + "</robot>";
  }

 private:
  double uniform(double low, double high) { return random_.uniform(number_++, low, high); }
  std::string three(double size) {
    return fmt::format("{:.17g} {:.17g} {:.17g}", uniform(-size, size), uniform(-size, size), uniform(-size, size));
  }
  std::string origin() { return fmt::format("<origin xyz='{}' rpy='{}'/>", three(1), three(4)); }

  std::string link(int number) {
    const double x = uniform(1, 2), y = uniform(1, 2), z = uniform(1, 2);  // as of a box
    return fmt::format(
        "<link name='l{}'><inertial>{}<mass value='{}'/><inertia ixx='{}' iyy='{}' izz='{}' ixy='{}' ixz='{}' "
        "iyz='{}'/></inertial><collision>{}<geometry><box size='{} {} {}'/></geometry></collision></link>",
        number, origin(), uniform(0.1, 3), y + z, x + z, x + y, uniform(-0.2, 0.2), uniform(-0.2, 0.2),
        uniform(-0.2, 0.2), origin(), x, y, z);
  }

  std::string joint(int number) {
    constexpr const char* types[] = {"revolute", "continuous", "prismatic", "fixed"};
    const int parent = static_cast<int>(uniform(0, number));
    return fmt::format(
        "<joint name='j{0}' type='{1}'><parent link='l{2}'/><child link='l{0}'/>{3}<axis xyz='{4}'/><limit lower='{5}' "
        "upper='{6}' effort='{7}' velocity='{8}'/><dynamics damping='{9}' friction='{10}'/></joint>",
        number, types[static_cast<int>(uniform(0, 4))], parent, origin(), three(2), uniform(-3, 0), uniform(0, 3),
        uniform(0, 9), uniform(0, 9), uniform(0, 2), uniform(0, 2));
  }

  RandomStream random_;
  std::uint64_t number_ = 0;
};

}  // namespace murosimf::oracle
