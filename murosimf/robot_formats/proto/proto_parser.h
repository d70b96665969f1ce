/// proto_parser.h - reads one PROTO file (proto_file.h has its meaning).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/robot_formats/proto/proto_node.h"
#include "murosimf/robot_formats/proto/proto_tokens.h"

namespace murosimf::robot_formats::proto {

/// Limit of the nodes of one reading together: files of a few lines can mean billions of them.
struct ProtoBudget {
  std::size_t left = 20'000'000;  ///< numbers, strings and nodes
};

/// An EXTERNPROTO line.
struct ExternProto {
  std::string url, where;
};

class ProtoParser {
 public:
  /// Expands a node of a type that is a PROTO of another file; nothing if it is none.
  using Expand = std::function<std::optional<Node>(const Node&, const std::vector<ExternProto>&)>;

  /// `values` replace the defaults of fields of the file's PROTO.
  ProtoParser(const std::filesystem::path& file, const std::vector<Field>& values, ProtoBudget& budget, Expand expand);

  /// The nodes at the top. Throws SetupError.
  [[nodiscard]] std::vector<NodePtr> parse();
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] int year() const { return tokens_.year(); }

 private:
  void parse_extern();
  void parse_interface();
  void parse_declaration();
  void skip_restriction();
  [[nodiscard]] NodePtr parse_node();
  [[nodiscard]] NodePtr parse_use();
  void parse_fields(Node& node);
  [[nodiscard]] Field parse_value(const std::string& name);
  void refuse_malformed() const;
  void parse_element(Field& field);
  void parse_array(Field& field);
  void bind(Field& field);
  [[nodiscard]] std::string take_word(const char* what);
  void take_bracket(char bracket);
  void spend(std::size_t count = 1);

  Tokens tokens_;
  std::shared_ptr<const std::filesystem::path> file_;
  const std::vector<Field>& values_;
  ProtoBudget& budget_;
  Expand expand_;
  std::string name_;
  std::vector<ExternProto> externs_;
  std::map<std::string, Field> interface_;
  std::map<std::string, NodePtr> defined_;
  int depth_ = 0;
};

}  // namespace murosimf::robot_formats::proto
