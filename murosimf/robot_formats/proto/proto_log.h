/// proto_log.h - diagnostics of the reader of PROTO files (robot_formats/reader_log.h).
#pragma once

#include "murosimf/robot_formats/proto/proto_node.h"
#include "murosimf/robot_formats/reader_log.h"

namespace murosimf::robot_formats::proto {

class ProtoLog : public robot_formats::ReaderLog {
 public:
  using ReaderLog::ReaderLog;

  /// As in the base class, at the field or else at the node.
  void refuse(const Node& at, const std::string& message, const Field* field = nullptr) {
    ReaderLog::refuse(field ? field->where : at.where, message);
  }
  /// Refuses fields that the type of the node does not have, where the type acts (proto_schema.h).
  void check_fields(const Node& node);
};

}  // namespace murosimf::robot_formats::proto
