#include "murosimf/recording/mcap/message_schema.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/protobuf.h"

namespace murosimf::recording {
namespace {

/// Splits a text into words and signs.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : left_(text) { skip_space(); }
  [[nodiscard]] bool empty() const { return left_.empty(); }
  std::string take() {
    std::size_t size = 0;
    while (size < left_.size() && is_word(left_[size])) ++size;
    size = std::max<std::size_t>(size, 1);
    std::string token(left_.substr(0, size));
    left_.remove_prefix(std::min(size, left_.size()));
    skip_space();
    return token;
  }
  void want(std::string_view sign) {
    const std::string token = take();
    if (token != sign) throw SetupError(fmt::format("'{}' where '{}' should be", token, sign));
  }
  int take_number() {
    const std::string token = take();
    int number = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), number);
    if (error != std::errc{}) throw SetupError(fmt::format("'{}' is no number of a field", token));
    return number;
  }
  /// ` = NUMBER;`
  int take_assignment() {
    want("=");
    const int number = take_number();
    want(";");
    return number;
  }

 private:
  static bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; }
  void skip_space() {
    while (!left_.empty() && std::isspace(static_cast<unsigned char>(left_.front())) != 0) left_.remove_prefix(1);
  }
  std::string_view left_;
};

EnumSchema take_enum(Tokens& tokens) {
  EnumSchema schema{.name = tokens.take(), .values = {}};
  tokens.want("{");
  for (std::string name = tokens.take(); name != "}"; name = tokens.take()) {
    schema.values.emplace_back(name, tokens.take_assignment());
  }
  return schema;
}

/// "repeated" and "optional" stand before the type.
FieldSchema take_field(Tokens& tokens, std::string first) {
  FieldSchema field;
  field.repeated = first == "repeated";
  field.optional = first == "optional";
  field.type = field.repeated || field.optional ? tokens.take() : std::move(first);
  field.name = tokens.take();
  field.number = tokens.take_assignment();
  return field;
}

bool is_message(const FieldSchema& field) { return field.type.find('.') != std::string::npos; }

/// FieldDescriptorProto.Type
std::uint64_t type_number(const FieldSchema& field) {
  static const std::vector<std::pair<std::string, int>> numbers = {{"double", 1}, {"int64", 3},   {"uint64", 4},
                                                                   {"int32", 5},  {"fixed64", 6}, {"fixed32", 7},
                                                                   {"bool", 8},   {"string", 9},  {"bytes", 12},
                                                                   {"uint32", 13}};
  for (const auto& [name, number] : numbers) {
    if (name == field.type) return static_cast<std::uint64_t>(number);
  }
  return is_message(field) ? 11 : 14;
}

std::string package_of(const std::string& name) { return name.substr(0, name.rfind('.')); }

std::string file_of(const std::string& name) {
  if (name == "google.protobuf.Timestamp") return "google/protobuf/timestamp.proto";  // the usual name of this file
  if (name == "google.protobuf.Duration") return "google/protobuf/duration.proto";
  std::string file = name;
  std::ranges::replace(file, '.', '/');
  return file + ".proto";
}

void append_field(ProtobufWriter& out, const MessageSchema& message, const FieldSchema& field) {
  MUROSIMF_ASSERT(field.number > 0);
  out.text(1, field.name);
  out.varint(3, static_cast<std::uint64_t>(field.number));
  out.varint(4, field.repeated ? 3 : 1);
  out.varint(5, type_number(field));
  if (is_message(field)) out.text(6, "." + field.type);
  if (type_number(field) == 14) out.text(6, fmt::format(".{}.{}", message.name, field.type));
}

/// An optional field is the only member of its own "oneof": the encoding of proto3 optional.
void append_fields(ProtobufWriter& out, const MessageSchema& message) {
  std::uint64_t optional = 0;
  for (const FieldSchema& field : message.fields) {
    out.message(2, [&](ProtobufWriter& one) {
      append_field(one, message, field);
      if (!field.optional) return;
      one.present_varint(9, optional++);
      one.varint(17, 1);
    });
  }
  for (const FieldSchema& field : message.fields) {
    if (field.optional) out.message(8, [&](ProtobufWriter& one) { one.text(1, "_" + field.name); });
  }
}

void append_enum(ProtobufWriter& out, const EnumSchema& schema) {
  out.text(1, schema.name);
  for (const auto& named : schema.values) {
    out.message(2, [&](ProtobufWriter& value) {
      const auto& [name, number] = named;
      value.text(1, name);
      value.present_varint(2, static_cast<std::uint64_t>(number));
    });
  }
}

/// DescriptorProto
void append_message(ProtobufWriter& out, const MessageSchema& message) {
  out.text(1, message.name.substr(message.name.rfind('.') + 1));
  append_fields(out, message);
  for (const EnumSchema& schema : message.enums) {
    out.message(4, [&](ProtobufWriter& one) { append_enum(one, schema); });
  }
}

/// The messages that it contains, each once.
std::set<std::string> parts_of(const MessageSchema& message) {
  std::set<std::string> parts;
  for (const FieldSchema& field : message.fields) {
    if (is_message(field) && field.type != message.name) parts.insert(field.type);
  }
  return parts;
}

/// FileDescriptorProto; files follow those that they depend on.
void append_file(ProtobufWriter& out, const MessageSchema& message, const FindSchema& find,
                 std::set<std::string>& written) {
  if (!written.insert(message.name).second) return;
  const std::set<std::string> parts = parts_of(message);
  for (const std::string& part : parts) append_file(out, find(part), find, written);
  out.message(1, [&](ProtobufWriter& file) {
    file.text(1, file_of(message.name));
    file.text(2, package_of(message.name));
    for (const std::string& part : parts) file.text(3, file_of(part));
    file.message(4, [&](ProtobufWriter& one) { append_message(one, message); });
    file.text(12, "proto3");
  });
}

}  // namespace

/// Errors of the text are errors of this program: they name the message.
MessageSchema message_schema(std::string name, std::string_view fields) {
  return with_context(name, [&] {
    MessageSchema schema{.name = name, .enums = {}, .fields = {}};
    for (Tokens tokens(fields); !tokens.empty();) {
      std::string first = tokens.take();
      if (first == "enum") {
        schema.enums.push_back(take_enum(tokens));
      } else {
        schema.fields.push_back(take_field(tokens, std::move(first)));
      }
    }
    return schema;
  });
}

std::string descriptor_set(const MessageSchema& message, const FindSchema& find) {
  std::string bytes;
  ProtobufWriter out(bytes);
  std::set<std::string> written;
  append_file(out, message, find, written);
  return bytes;
}

}  // namespace murosimf::recording
