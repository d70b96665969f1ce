/// description_checks.h - what tests of readers of robot files ask of a description and of what is told about a file.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::description_checks {

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline bool any_contains(const std::vector<std::string>& texts, const std::string& part) {
  return std::ranges::any_of(texts, [&](const std::string& text) { return contains(text, part); });
}

/// Whether something without effect is told so.
inline bool names_unused(const robot_formats::RobotDescription& description, const std::string& part) {
  return std::ranges::any_of(description.unused, [&](const auto& unused) { return contains(unused.line, part); });
}

inline void expect_near(const Vec3d& a, const Vec3d& b, double tolerance = 1e-12) {
  EXPECT_LT(norm(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z << " instead of " << b.x << ' ' << b.y << ' '
                                    << b.z;
}

}  // namespace murosimf::robot_formats::description_checks
