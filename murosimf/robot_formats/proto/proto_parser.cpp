#include "murosimf/robot_formats/proto/proto_parser.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/text_lines.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats::proto {
namespace {

constexpr int most_levels = 200;

bool declares(const std::string& word) {
  for (const char* known : {"field", "vrmlField", "unconnectedField", "hiddenField", "deprecatedField", "w3dField"}) {
    if (word == known) return true;
  }
  return false;
}

}  // namespace

ProtoParser::ProtoParser(const std::filesystem::path& file, const std::vector<Field>& values, ProtoBudget& budget,
                         Expand expand)
    : tokens_(file),
      file_(std::make_shared<const std::filesystem::path>(file)),
      values_(values),
      budget_(budget),
      expand_(std::move(expand)) {}

void ProtoParser::spend(std::size_t count) {
  if (budget_.left < count) tokens_.fail("the file and the PROTOs in it mean too many nodes; make it smaller");
  MUROSIMF_ASSERT(budget_.left >= count);
  budget_.left -= count;
}

std::string ProtoParser::take_word(const char* what) {
  if (tokens_.peek().kind != Token::Kind::word) {
    const std::string& text = tokens_.peek().text;
    tokens_.fail(fmt::format("{} is missing here{}", what, text.empty() ? "" : ", before " + files::quoted(text)));
  }
  return tokens_.take().text;
}

void ProtoParser::take_bracket(char bracket) {
  if (!tokens_.peek().is(bracket)) {
    MUROSIMF_ASSERT(std::string_view("{}[]").find(bracket) != std::string_view::npos);
    const std::string& text = tokens_.peek().text;
    tokens_.fail(
        fmt::format("'{}' is missing {}", bracket, text.empty() ? "at the end" : "before " + files::quoted(text)));
  }
  (void)tokens_.take();
}

std::vector<NodePtr> ProtoParser::parse() {
  std::vector<NodePtr> nodes;
  while (tokens_.peek().kind != Token::Kind::end) {
    const Token& next = tokens_.peek();
    if (next.kind == Token::Kind::word && (next.text == "EXTERNPROTO" || next.text == "IMPORTABLE")) {
      parse_extern();
    } else if (next.kind == Token::Kind::word && next.text == "PROTO") {
      if (!name_.empty()) tokens_.fail("a second PROTO in the file; give it a file of its own");
      parse_interface();
      take_bracket('{');
      nodes.push_back(parse_node());
      take_bracket('}');
    } else {
      nodes.push_back(parse_node());
    }
  }
  if (nodes.empty()) tokens_.fail("there is no PROTO and no node in the file");
  return nodes;
}

void ProtoParser::parse_extern() {
  while (tokens_.peek().text == "IMPORTABLE") (void)tokens_.take();
  const std::string where = tokens_.where(tokens_.peek().line);
  if (take_word("EXTERNPROTO") != "EXTERNPROTO") tokens_.fail("EXTERNPROTO is missing here");
  if (tokens_.peek().kind == Token::Kind::word) (void)tokens_.take();  // the name that some versions write
  if (tokens_.peek().kind != Token::Kind::text) tokens_.fail("the address of an EXTERNPROTO is missing, in quotes");
  externs_.push_back({tokens_.take().text, where});
}

void ProtoParser::parse_interface() {
  (void)tokens_.take();
  name_ = take_word("the name of the PROTO");
  take_bracket('[');
  while (!tokens_.peek().is(']')) parse_declaration();
  take_bracket(']');
  // Values from outside replace the defaults before the body is read, which refers to them by IS.
  for (const Field& value : values_) {
    const auto found = interface_.find(value.name);
    if (found == interface_.end()) {
      std::vector<std::string_view> names;
      for (const auto& [name, field] : interface_) names.push_back(name);
      throw SetupError(fmt::format("{}: {}", value.where, unknown_name("field of " + name_, value.name, names)));
    }
    found->second = value;
  }
}

void ProtoParser::parse_declaration() {
  if (const std::string word = take_word("'field'"); !declares(word)) {
    tokens_.fail(fmt::format("{} is no declaration of a field; write: field TYPE name value", files::quoted(word)));
  }
  (void)take_word("the type of the field");
  if (tokens_.peek().is('{')) skip_restriction();
  const std::string name = take_word("the name of the field");
  interface_[name] = parse_value(name);
}

/// Skips the allowed values of a field: {1, 2, 3}.
void ProtoParser::skip_restriction() {
  int depth = 0;
  do {
    if (tokens_.peek().kind == Token::Kind::end) tokens_.fail("'}' is missing at the end");
    const Token token = tokens_.take();
    depth += token.is('{') ? 1 : token.is('}') ? -1 : 0;
    MUROSIMF_ASSERT(depth >= 0);
  } while (depth > 0);
}

NodePtr ProtoParser::parse_use() {
  const std::string name = take_word("the name after USE");
  const auto found = defined_.find(name);
  if (found != defined_.end()) return found->second;
  std::vector<std::string_view> names;
  for (const auto& [known, node] : defined_) names.push_back(known);
  tokens_.fail(unknown_name("name after USE", name, names));
}

NodePtr ProtoParser::parse_node() {
  spend();
  Node node;
  node.file = file_;
  node.type = take_word("a node");
  if (node.type == "USE") return parse_use();
  if (node.type == "DEF") {
    node.def = take_word("the name after DEF");
    node.type = take_word("a node after DEF");
  }
  node.where = tokens_.where(tokens_.peek().line);
  if (++depth_ > most_levels) tokens_.fail(fmt::format("more than {} nodes inside each other", most_levels));
  take_bracket('{');
  parse_fields(node);
  take_bracket('}');
  --depth_;
  MUROSIMF_ASSERT(depth_ >= 0);
  // Expanded after its fields: they are the values of the other PROTO's fields.
  std::optional<Node> expanded = expand_(node, externs_);
  if (expanded && !node.def.empty()) expanded->def = node.def;
  const auto result = std::make_shared<const Node>(expanded ? *std::move(expanded) : std::move(node));
  // A later DEF of the same name replaces the earlier one, as in VRML.
  if (!result->def.empty()) defined_[result->def] = result;
  return result;
}

void ProtoParser::parse_fields(Node& node) {
  while (!tokens_.peek().is('}')) {
    refuse_malformed();
    std::string name = take_word(tokens_.peek().kind == Token::Kind::end ? "'}'" : "the name of a field");
    const bool hidden = name == "hidden";  // written by Webots for its own state: read over
    if (hidden) name = take_word("the name of a field");
    Field field = parse_value(name);
    if (hidden) continue;
    if (node.find(name)) node.fail(fmt::format("{} is written twice in {}; remove one", name, node.type), &field);
    node.fields.push_back(std::move(field));
  }
}

Field ProtoParser::parse_value(const std::string& name) {
  Field field;
  field.name = name;
  field.where = tokens_.where(tokens_.peek().line);
  const Token& next = tokens_.peek();
  if (next.is('[')) {
    parse_array(field);
  } else if (next.kind == Token::Kind::number) {
    // Vectors stand without brackets: all numbers up to the next word belong to the field.
    while (tokens_.peek().kind == Token::Kind::number) parse_element(field);
  } else if (next.kind == Token::Kind::word && next.text == "IS") {
    (void)tokens_.take();
    bind(field);
  } else {
    parse_element(field);
  }
  return field;
}

void ProtoParser::refuse_malformed() const {
  const Token& next = tokens_.peek();
  if (next.malformed) tokens_.fail(fmt::format("{} is no number; correct it", files::quoted(next.text)));
}

void ProtoParser::parse_array(Field& field) {
  take_bracket('[');
  while (!tokens_.peek().is(']')) parse_element(field);
  take_bracket(']');
}

void ProtoParser::parse_element(Field& field) {
  spend();
  refuse_malformed();
  const Token& next = tokens_.peek();
  if (next.kind == Token::Kind::number) {
    field.numbers.push_back(tokens_.take().number);
  } else if (next.kind == Token::Kind::text) {
    field.texts.push_back(tokens_.take().text);
  } else if (next.kind != Token::Kind::word) {
    tokens_.fail(fmt::format("the value of {} is missing", field.name));
  } else if (next.text == "TRUE" || next.text == "FALSE") {
    field.word = tokens_.take().text;
  } else if (next.text == "NULL") {
    (void)tokens_.take();
  } else {
    field.nodes.push_back(parse_node());
  }
}

/// Resolves `name IS other`: copies the value of the PROTO's field.
void ProtoParser::bind(Field& field) {
  const std::string source = take_word("the name after IS");
  const auto found = interface_.find(source);
  if (found == interface_.end()) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : interface_) names.push_back(name);
    throw SetupError(fmt::format("{}: {}", field.where, unknown_name("field after IS", source, names)));
  }
  const Field& value = found->second;
  // Copies count as well: IS in a chain of PROTOs doubles a value each time.
  spend(value.numbers.size() + value.texts.size() + value.nodes.size());
  field = Field{field.name, field.where, value.numbers, value.texts, value.nodes, value.word};
}

}  // namespace murosimf::robot_formats::proto
