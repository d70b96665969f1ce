#include "murosimf/robot_formats/proto/proto_log.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/robot_formats/proto/proto_schema.h"

namespace murosimf::robot_formats::proto {

void ProtoLog::check_fields(const Node& node) {
  const auto* known = fields_of(node.type);
  if (!known) return;
  // Types without a list act in no way that a field could change.
  for (const Field& field : node.fields) {
    if (std::ranges::find(*known, field.name) != known->end()) continue;
    refuse(node, unknown_name("field of " + node.type, field.name, *known), &field);
  }
}

}  // namespace murosimf::robot_formats::proto
