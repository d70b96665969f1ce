/// message_schema.h - types of messages: defined in the notation of .proto files, passed on as descriptors that readers understand.
///
///     const MessageSchema point = message_schema("own.Point", "double x = 1; double y = 2; repeated own.Point next = 3;");
///
/// Fields are `[repeated | optional] TYPE NAME = NUMBER;`; an enumeration of the message is `enum NAME { ZERO = 0; ONE = 1; }`,
/// before its use. Types with a dot are messages.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace murosimf::recording {

struct FieldSchema {
  std::string type, name;
  int number = 0;
  bool repeated = false, optional = false;
};

struct EnumSchema {
  std::string name;
  std::vector<std::pair<std::string, int>> values;
};

struct MessageSchema {
  std::string name;  ///< with its package: "foxglove.Color"
  std::vector<EnumSchema> enums;
  std::vector<FieldSchema> fields;
};

/// Errors in `fields` throw SetupError.
[[nodiscard]] MessageSchema message_schema(std::string name, std::string_view fields);

/// The message of that name; the result has a stable address.
using FindSchema = std::function<const MessageSchema&(const std::string& name)>;

/// The bytes of a google.protobuf.FileDescriptorSet with the message and all its parts, one file each.
[[nodiscard]] std::string descriptor_set(const MessageSchema& message, const FindSchema& find);

}  // namespace murosimf::recording
