#include "murosimf/web/pose_message.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/web/little_endian.h"
#include "murosimf/world/time.h"

namespace murosimf::web {
namespace {

constexpr double finest_step = 0x1p-13;  // [m]
constexpr double most_steps = 32767;

/// NaN of a frozen entity becomes 0.
std::int16_t nearest_i16(double value) {
  return std::isfinite(value) ? static_cast<std::int16_t>(std::lround(std::clamp(value, -most_steps, most_steps))) : 0;
}

void put_vector(std::string& out, const Vec3d& v) {
  for (const double number : {v.x, v.y, v.z}) put_f32(out, static_cast<float>(number));
}

void put_body(std::string& out, const Vec3d& offset, const Mat3d& orientation, double step) {
  for (const double number : {offset.x, offset.y, offset.z}) put_i16(out, nearest_i16(number / step));
  Quaterniond q = from_matrix(orientation);
  const double sign = q.w < 0 ? -1 : 1;  // of two equal rotations the one with w >= 0: changes stay small
  for (const double number : {q.x, q.y, q.z, q.w}) put_i16(out, nearest_i16(sign * number * most_steps));
}

std::size_t row_bytes(const ShownEntity& shown) { return 20 + 14 * shown.objects.size(); }

void put_entity(std::string& out, const ShownEntity& shown, const PoseFrame& frame) {
  MUROSIMF_ASSERT(shown.index + 1 < frame.first.size() && !shown.objects.empty());
  const std::size_t first = frame.first[shown.index];
  const Vec3d base = frame.position[first];
  double farthest = 0;
  for (const int object : shown.objects) {
    const Vec3d offset = frame.position[first + static_cast<std::size_t>(object)] - base;
    for (const double number : {offset.x, offset.y, offset.z}) {
      if (std::isfinite(number)) farthest = std::max(farthest, std::abs(number));
    }
  }
  double step = finest_step;
  while (step * most_steps < farthest) step *= 2;
  put_u16(out, static_cast<std::uint16_t>((frame.present[shown.index] ? 1 : 0) | (frame.frozen[shown.index] ? 2 : 0)));
  put_u16(out, static_cast<std::uint16_t>(shown.objects.size()));
  put_vector(out, base);
  put_f32(out, static_cast<float>(step));
  for (const int object : shown.objects) {
    const std::size_t i = first + static_cast<std::size_t>(object);
    MUROSIMF_ASSERT(i < frame.position.size() && i < frame.orientation.size());
    put_body(out, frame.position[i] - base, frame.orientation[i], step);
  }
}

}  // namespace

std::string pose_message(const SceneDocument& document, const PoseFrame& frame, std::uint64_t jumps, bool contacts) {
  std::string out;
  put_u8(out, static_cast<std::uint8_t>(MessageKind::poses));
  put_u8(out, contacts ? 1 : 0);
  MUROSIMF_ASSERT(document.moving.size() <= 0xFFFF);
  put_u16(out, static_cast<std::uint16_t>(document.moving.size()));
  put_u32(out, static_cast<std::uint32_t>(jumps));
  put_f64(out, seconds(frame.time));
  for (const ShownEntity& shown : document.moving) put_entity(out, shown, frame);
  if (!contacts) return out;
  put_u32(out, static_cast<std::uint32_t>(frame.contacts.size()));
  for (const ContactMark& contact : frame.contacts) {
    put_vector(out, contact.point);
    put_vector(out, contact.force);
  }
  return out;
}

/// The flags of a row are its first number.
std::string rows_of_absent(const SceneDocument& document, std::size_t first, std::string rows) {
  std::size_t at = 0;
  for (std::size_t i = first; i < document.moving.size(); ++i) {
    MUROSIMF_ASSERT(at + row_bytes(document.moving[i]) <= rows.size());
    rows[at] = static_cast<char>(static_cast<unsigned char>(rows[at]) & ~1U);
    at += row_bytes(document.moving[i]);
  }
  MUROSIMF_ASSERT(at == rows.size());
  return rows;
}

}  // namespace murosimf::web
