#include "murosimf/recording/foxglove_messages.h"

#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::recording {

double rounded(double value, double step) noexcept {
  MUROSIMF_ASSERT(step > 0);
  return std::nearbyint(value * (1 / step)) * step + 0.0;  // no -0
}

Vec3d rounded(const Vec3d& v, double step) noexcept {
  return {rounded(v.x, step), rounded(v.y, step), rounded(v.z, step)};
}

void put_time(ProtobufWriter& out, int field, Duration time) {
  out.message(field, [&](ProtobufWriter& in) {
    in.varint(1, static_cast<std::uint64_t>(time.count() / 1'000'000'000));
    in.varint(2, static_cast<std::uint64_t>(time.count() % 1'000'000'000));
  });
}

void put_vector(ProtobufWriter& out, int field, const Vec3d& v) {
  out.message(field, [&](ProtobufWriter& in) {
    in.number(1, v.x);
    in.number(2, v.y);
    in.number(3, v.z);
  });
}

/// Rounded, so that recordings compress well; readers normalize quaternions.
void put_rotation(ProtobufWriter& out, int field, const Mat3d& R, double step) {
  const Quaterniond q = from_matrix(R);
  out.message(field, [&](ProtobufWriter& in) {
    in.number(1, rounded(q.x, step));
    in.number(2, rounded(q.y, step));
    in.number(3, rounded(q.z, step));
    in.number(4, rounded(q.w, step));
  });
}

void put_pose(ProtobufWriter& out, int field, const Transformd& pose, double step) {
  out.message(field, [&](ProtobufWriter& in) {
    put_vector(in, 1, rounded(pose.position, step));
    put_rotation(in, 2, pose.orientation, step);
  });
}

void put_color(ProtobufWriter& out, int field, const Color& color) {
  out.message(field, [&](ProtobufWriter& in) {
    in.number(1, color.red);
    in.number(2, color.green);
    in.number(3, color.blue);
    in.number(4, color.alpha);
  });
}

/// Fields may be missing: a number that is 0 is not written.
Duration read_time(ProtobufReader in) {
  std::uint64_t seconds = 0, nanoseconds = 0;
  while (in.next()) {
    if (in.field() == 1) seconds = in.varint();
    if (in.field() == 2) nanoseconds = in.varint();
  }
  return Duration(seconds * 1'000'000'000 + nanoseconds);
}

Vec3d read_vector(ProtobufReader in) {
  Vec3d v;
  while (in.next()) {
    if (in.field() == 1) v.x = in.number();
    if (in.field() == 2) v.y = in.number();
    if (in.field() == 3) v.z = in.number();
  }
  return v;
}

/// All numbers 0 is an absent quaternion, which means no rotation.
Mat3d read_rotation(ProtobufReader in) {
  Quaterniond q{0, 0, 0, 0};
  while (in.next()) {
    if (in.field() == 1) q.x = in.number();
    if (in.field() == 2) q.y = in.number();
    if (in.field() == 3) q.z = in.number();
    if (in.field() == 4) q.w = in.number();
  }
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(length > 0)) return {};
  return to_matrix(Quaterniond{q.w / length, q.x / length, q.y / length, q.z / length});
}

}  // namespace murosimf::recording
