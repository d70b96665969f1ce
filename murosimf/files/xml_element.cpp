#include "murosimf/files/xml_element.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <tinyxml2.h>

#include "murosimf/files/file_spelling.h"
#include "murosimf/files/input_file.h"
#include "murosimf/files/text_encoding.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

constexpr std::string_view xml_blanks = " \t\r\n";

}  // namespace

/// One XML file, and the files that its include elements refer to.
struct XmlSource {
  std::string name;
  tinyxml2::XMLDocument document;
  std::map<const void*, XmlElement> included;   ///< root of the replacement of an element, by XmlElement::id
  std::map<const void*, XmlElement> originals;  ///< originals of copies, by XmlElement::id
};

namespace {

std::unique_ptr<XmlSource> parse_source(const std::filesystem::path& file, const std::string& text) {
  auto source = std::make_unique<XmlSource>();
  source->name = file.string();
  tinyxml2::XMLDocument& document = source->document;
  const auto error = document.Parse(text.data(), text.size());
  if (error != tinyxml2::XML_SUCCESS || !document.RootElement()) {
    const int line = std::max(1, document.ErrorLineNum());
    throw SetupError(one_line(fmt::format("{}:{}: not well-formed XML ({}); correct the file there", source->name, line,
                                          document.ErrorName())));
  }
  return source;
}

std::unique_ptr<XmlSource> read_source(const std::filesystem::path& file) {
  return parse_source(file, xml_to_utf8(read_input_file(file, most_xml_bytes), file));
}

tinyxml2::XMLElement* make_element(const XmlTree& tree, XmlSource& source) {
  tinyxml2::XMLElement* element = source.document.NewElement(tree.tag.c_str());
  source.originals.emplace(element, tree.original);
  for (const auto& [name, value] : tree.attributes) element->SetAttribute(name.c_str(), value.c_str());
  for (const XmlTree& child : tree.children) element->InsertEndChild(make_element(child, source));
  return element;
}

}  // namespace

std::string* XmlTree::find(std::string_view name) {
  const auto found = std::ranges::find(attributes, name, &XmlAttribute::name);
  return found == attributes.end() ? nullptr : &found->value;
}

void XmlTree::set(const std::string& name, const std::string& value) {
  if (std::string* present = find(name)) {
    *present = value;
  } else {
    attributes.push_back({name, value});
  }
}

std::size_t XmlTree::size() const {
  std::size_t size = 1;
  for (const XmlTree& child : children) size += child.size();
  return size;
}

XmlTree copy_of(const XmlElement& element) {
  XmlTree tree{element.tag(), element.attributes(), element, {}};
  for (const XmlElement& child : element.children()) tree.children.push_back(copy_of(child));
  return tree;
}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  std::size_t begin = text.find_first_not_of(xml_blanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(xml_blanks, begin), text.size());
    if (text[begin] == '+') ++begin;  // from_chars takes no plus sign
    double number = 0;
    const char* last = text.data() + end;
    const auto [stop, error] = std::from_chars(text.data() + begin, last, number);
    if (error != std::errc{} || stop != last || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
    begin = text.find_first_not_of(xml_blanks, end);
  }
  return numbers;
}

std::string XmlElement::tag() const { return element_->Name(); }

int XmlElement::line() const {
  const auto copied = source_->originals.find(id());
  return copied == source_->originals.end() ? element_->GetLineNum() : copied->second.line();
}

// A copy reports the place of its original: messages must point into the user's file.
std::string XmlElement::file() const {
  const auto copied = source_->originals.find(id());
  return copied == source_->originals.end() ? source_->name : copied->second.file();
}

std::string XmlElement::where() const { return fmt::format("{}:{}", file(), line()); }

std::optional<std::string> XmlElement::attribute(const char* name) const {
  const char* value = element_->Attribute(name);
  return value ? std::optional<std::string>(value) : std::nullopt;
}

std::vector<XmlAttribute> XmlElement::attributes() const {
  std::vector<XmlAttribute> result;
  for (const auto* a = element_->FirstAttribute(); a; a = a->Next()) result.push_back({a->Name(), a->Value()});
  return result;
}

std::string XmlElement::text() const {
  const char* start = element_->GetText();
  std::string_view text = start ? start : "";
  const std::size_t begin = std::min(text.find_first_not_of(xml_blanks), text.size());
  text.remove_prefix(begin);
  return std::string(text.substr(0, text.find_last_not_of(xml_blanks) + 1));
}

std::vector<XmlElement> XmlElement::children() const {
  std::vector<XmlElement> result;
  for (const auto* c = element_->FirstChildElement(); c; c = c->NextSiblingElement()) {
    if (const auto included = source_->included.find(c); included != source_->included.end()) {
      for (const XmlElement& child : included->second.children()) result.push_back(child);
    } else {
      result.emplace_back(c, source_);
    }
  }
  return result;
}

std::vector<XmlElement> XmlElement::children(std::string_view tag) const {
  std::vector<XmlElement> result;
  for (const XmlElement& child : children()) {
    if (child.tag() == tag) result.push_back(child);
  }
  return result;
}

void XmlElement::fail(std::string_view message) const {
  throw SetupError(one_line(fmt::format("{}: {}", where(), message)));
}

XmlFile::XmlFile(const std::filesystem::path& file, const std::string& text) {
  sources_.push_back(parse_source(file, text));
}

XmlFile::XmlFile(const std::filesystem::path& file) { sources_.push_back(read_source(file)); }

XmlFile::~XmlFile() = default;

XmlElement XmlFile::root() const {
  MUROSIMF_ASSERT(!sources_.empty() && sources_[0]->document.RootElement() != nullptr);
  return {sources_[0]->document.RootElement(), sources_[0].get()};
}

void XmlFile::follow_includes() {
  follow_includes(*sources_[0], root(), std::filesystem::path(sources_[0]->name).parent_path());
}

XmlElement XmlFile::open(const std::filesystem::path& file) {
  XmlSource& source = *sources_.emplace_back(read_source(file));
  const XmlElement root(source.document.RootElement(), &source);
  follow_includes(source, root, file.parent_path());
  return root;
}

void XmlFile::follow_includes(XmlSource& source, const XmlElement& element, const std::filesystem::path& folder) {
  for (const XmlElement& child : element.children()) {
    if (child.tag() != "include") {
      follow_includes(source, child, folder);
      continue;
    }
    const auto name = child.attribute("file");
    if (!name || name->empty()) child.fail("include without a file; add file=\"...\"");
    const auto path = find_spelled(folder, *name).value_or(folder / *name);
    // Any second inclusion is refused, so that recursion ends.
    for (const auto& other : sources_) {
      std::error_code none;
      if (std::filesystem::equivalent(other->name, path, none)) {
        child.fail(fmt::format("'{}' is included a second time; a file can be included once", *name));
      }
    }
    XmlSource& file = *sources_.emplace_back(with_context(child.where(), [&] { return read_source(path); }));
    const XmlElement included(file.document.RootElement(), &file);
    follow_includes(file, included, folder);
    source.included.emplace(child.id(), included);
  }
}

void XmlFile::replace(const XmlElement& element, const std::vector<XmlTree>& by) {
  XmlSource& source = *sources_.emplace_back(std::make_unique<XmlSource>());
  tinyxml2::XMLElement* root = source.document.NewElement("replacement");
  source.document.InsertEndChild(root);
  source.originals.emplace(root, element);
  for (const XmlTree& tree : by) root->InsertEndChild(make_element(tree, source));
  MUROSIMF_ASSERT(source.document.RootElement() == root);
  const auto owner = std::ranges::find(sources_, element.source_, [](const auto& one) { return one.get(); });
  MUROSIMF_ASSERT(owner != sources_.end());
  (*owner)->included.insert_or_assign(element.id(), XmlElement(root, &source));
}

}  // namespace murosimf::files
