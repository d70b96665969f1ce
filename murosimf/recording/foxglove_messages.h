/// foxglove_messages.h - poses, colors and instants as parts of Foxglove's messages.
///
/// Numbers are rounded to multiples of powers of two: smaller digits are noise that does not compress.
#pragma once

#include <string_view>

#include "murosimf/math/quaternion.h"
#include "murosimf/math/transform.h"
#include "murosimf/model/shape.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/world/time.h"

namespace murosimf::recording {

// Resolution of recorded numbers.
inline constexpr double pose_step = 0x1p-15;     ///< [m], [1] of quaternions: 0.03 mm, 0.06 mrad
inline constexpr double joint_step = 0x1p-14;    ///< [rad | m] 0.06 mrad: a 25th of the resolution of a 12 bit encoder
inline constexpr double velocity_step = 0x1p-5;  ///< [rad/s | m/s] about the resolution of servos
inline constexpr double torque_step = 0x1p-6;    ///< [N m | N]
inline constexpr double point_step = 0x1p-11;    ///< [m] of contacts: 0.5 mm
inline constexpr double force_step = 0x1p-4;     ///< [N] of contacts

/// Rounds to the nearest multiple of `step`. NaN and infinities are unchanged.
[[nodiscard]] double rounded(double value, double step) noexcept;
[[nodiscard]] Vec3d rounded(const Vec3d& v, double step) noexcept;

void put_time(ProtobufWriter& out, int field, Duration time);
void put_vector(ProtobufWriter& out, int field, const Vec3d& v);
void put_rotation(ProtobufWriter& out, int field, const Mat3d& R, double step = pose_step);
/// foxglove.Pose
void put_pose(ProtobufWriter& out, int field, const Transformd& pose, double step = pose_step);
void put_color(ProtobufWriter& out, int field, const Color& color);

[[nodiscard]] Duration read_time(ProtobufReader in);
[[nodiscard]] Vec3d read_vector(ProtobufReader in);
[[nodiscard]] Mat3d read_rotation(ProtobufReader in);

}  // namespace murosimf::recording
