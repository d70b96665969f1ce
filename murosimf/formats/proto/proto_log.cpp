#include "murosimf/formats/proto/proto_log.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/formats/proto/proto_schema.h"
#include "murosimf/model/error.h"

namespace murosimf::formats::proto {
namespace {

std::string line(const std::string& where, const std::string& message) {
  return files::one_line(fmt::format("{}: {}", where, message));
}

}  // namespace

void ProtoLog::note(const std::string& where, const std::string& message) {
  if (said_.insert(message).second) description_.notes.push_back(line(where, message));
}

void ProtoLog::unused(const std::string& where, const std::string& word, const std::string& message) {
  if (said_.insert(word).second) description_.unused.push_back({files::one_line(word), line(where, message)});
}

void ProtoLog::warn(const std::string& where, const std::string& message) {
  if (said_.insert(message).second) description_.warnings.push_back(line(where, message));
}

void ProtoLog::refuse(const Node& at, const std::string& message, const Field* field) {
  if (!lenient_) at.fail(message + " (--lenient reads on)", field);
  warn(field ? field->where : at.where, message);
}

void ProtoLog::check_fields(const Node& node) {
  const auto* known = fields_of(node.type);
  if (!known) return;
  for (const Field& field : node.fields) {
    if (std::ranges::find(*known, field.name) != known->end()) continue;
    refuse(node, unknown_name("field of " + node.type, field.name, *known), &field);
  }
}

}  // namespace murosimf::formats::proto
