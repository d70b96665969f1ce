/// unsteady_stacks.h - columns of bodies that are unstable at any step: they buckle on the springs of their contacts.
///
/// For a column of n upright bodies that lean by the small angles theta_i, with theta_0 = 0 the ground,
///
///     V = 1/2 sum K_i (theta_i - theta_(i-1))^2 - 1/2 sum G_i theta_i^2
///     K_i = sum of k x^2 over the points of contact i,   G_i = g (m_i h_i / 2 + h_i (m_(i+1) + ... + m_n))
///
/// with the stiffness k of contact_parameters.h and x the arms of the corners of the contact area of two bodies. It is stable while
/// V has a minimum at theta = 0: while the least lambda with det(K - lambda G) = 0, K the tridiagonal matrix of the springs, is above 1. All K_i
/// are proportional to 1 / static_deflection, so springs 1 / lambda times as stiff carry it. Bodies that are round, that lean or move at the
/// start, or that carry several others, form no column here.
/// Source: Lagrange's and Dirichlet's theorem (Goldstein, "Classical Mechanics", 2nd ed., 6-1); of equal cubes the limit is
/// Greenhill's (contact_parameters.h): 11 of 10 cm stand on 0.1 mm, 12 do not.
#pragma once

#include <string>
#include <vector>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// One line for each column on the ground that is unstable at any rate. For implicit contact only: with other laws the stiffness
/// depends on the step.
[[nodiscard]] std::vector<std::string> unsteady_stacks(const SceneSpec& spec);

}  // namespace murosimf::scene_file
