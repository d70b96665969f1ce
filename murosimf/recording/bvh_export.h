/// bvh_export.h - motion capture of one robot of a recording: the BVH file (Biovision hierarchy) that Blender and others read.
///
///     files::write_file("blue1.bvh", bvh_of(McapReader("game.mcap"), "blue1"));
///
/// Axes are those of BVH, y up: its X, Y and Z are y (left), z (up) and x (forward) of the robot and the world; lengths are centimetres,
/// angles degrees. A joint turns by Rz(a) Rx(b) Ry(c), its channels Zrotation, Xrotation and Yrotation:
///
///     sin b = R21,  tan c = -R20 / R22,  tan a = -R01 / R11;   |b| = 90 degrees: a = 0, tan c = R02 / R00
#pragma once

#include <string>

#include "murosimf/math/mat3.h"
#include "murosimf/math/vec3.h"
#include "murosimf/recording/mcap/mcap_reader.h"

namespace murosimf::recording {

/// `robot`: its name; empty: the only one with joints. One frame for each of the recording's period from the robot's first on;
/// missing frames repeat the previous one. Throws SetupError: no such robot, a joint slides, no poses, a damaged file.
[[nodiscard]] std::string bvh_of(const McapReader& recording, const std::string& robot);

/// (a, b, c) [rad] of Rz(a) Rx(b) Ry(c) = R.
[[nodiscard]] Vec3d bvh_angles(const Mat3d& R) noexcept;

}  // namespace murosimf::recording
