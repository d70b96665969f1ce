/// proto_file.h - PROTO files and worlds as nodes: declarations, defaults, `IS`, `DEF` and `USE`.
///
/// Fields of the file's PROTO have their default values. A node of a type that is a PROTO of another file is expanded: that of an
/// EXTERNPROTO line, or NAME.proto in the folder of the file, in that of the outermost file, or in a folder in one of these. One that is not
/// found remains as it is, and the caller decides about it. Templates with scripts are refused.
/// Source: Webots reference manual, "PROTO Definition", "PROTO Scripting", "EXTERNPROTO".
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/robot_formats/proto/proto_node.h"

namespace murosimf::robot_formats::proto {

struct ProtoFile {
  std::vector<NodePtr> nodes;  ///< at the top: one of a PROTO, several of a world
  std::string name;            ///< of the PROTO; empty: it is a world
  int year = 0;                ///< of the version of Webots in its first line; 0: none given
  std::vector<std::pair<std::string, std::string>> notes;  ///< where, and what was not found
};

/// Throws SetupError: file:line, what is wrong, what to do.
/// With `lenient`, a PROTO inside that cannot be read is a note and its node remains.
[[nodiscard]] ProtoFile read_proto_file(const std::filesystem::path& file, bool lenient);

}  // namespace murosimf::robot_formats::proto
