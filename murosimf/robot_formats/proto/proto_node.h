/// proto_node.h - a PROTO file as a tree of nodes, with `IS` and `USE` resolved.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/math/transform.h"

namespace murosimf::robot_formats::proto {

struct Node;
using NodePtr = std::shared_ptr<const Node>;

/// A field and its value; `NULL` and `[]` have none.
struct Field {
  std::string name, where;
  std::vector<double> numbers;
  std::vector<std::string> texts;
  std::vector<NodePtr> nodes;
  std::string word;  ///< TRUE or FALSE

  [[nodiscard]] bool empty() const { return numbers.empty() && texts.empty() && nodes.empty() && word.empty(); }
};

struct Node {
  std::string type, def;  ///< "Solid"; the name after DEF, may be empty
  std::string where;      ///< "robot.proto:12"
  std::shared_ptr<const std::filesystem::path> file;
  std::vector<Field> fields;

  /// Null: the file does not contain the field.
  [[nodiscard]] const Field* find(std::string_view name) const;
  /// The first node in a field; null if there is none.
  [[nodiscard]] NodePtr child(std::string_view name) const;
  /// All nodes in a field.
  [[nodiscard]] const std::vector<NodePtr>& children(std::string_view name) const;

  // Values of fields, or the fallback where the file has none. They throw SetupError (file:line) for another kind or number
  // of values.
  [[nodiscard]] double number(std::string_view name, double fallback) const;
  [[nodiscard]] double positive(std::string_view name, double fallback) const;
  [[nodiscard]] double at_least_zero(std::string_view name, double fallback) const;
  [[nodiscard]] Vec3d vector(std::string_view name, const Vec3d& fallback) const;
  [[nodiscard]] std::string text(std::string_view name, const std::string& fallback) const;
  [[nodiscard]] bool flag(std::string_view name, bool fallback) const;
  /// From `translation` and `rotation` (axis and angle).
  [[nodiscard]] Transformd pose() const;

  /// Throws SetupError: file:line of the node, or of one of its fields.
  [[noreturn]] void fail(const std::string& message, const Field* field = nullptr) const;
};

}  // namespace murosimf::robot_formats::proto
