#include "murosimf/formats/mjcf/mjcf_place_writer.h"

#include <cmath>

#include "murosimf/math/quaternion.h"

namespace murosimf::formats::mjcf {

void write_place(files::XmlText& xml, const Transformd& place) {
  xml.vector_unless_zero("pos", place.position);
  if (is_identity(place.orientation)) return;
  const auto clean = [](double x) { return std::fabs(x) < 1e-15 ? 0.0 : x; };  // rounding of rotations
  const Quaterniond q = from_matrix(place.orientation);
  xml.numbers("quat", {clean(q.w), clean(q.x), clean(q.y), clean(q.z)});
}

}  // namespace murosimf::formats::mjcf
