#include "murosimf/io/xml_element.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <tinyxml2.h>

#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

constexpr std::string_view blanks = " \t\r\n";

}  // namespace

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  std::size_t begin = text.find_first_not_of(blanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    if (text[begin] == '+') ++begin;
    double number = 0;
    const char* last = text.data() + end;
    const auto [stop, error] = std::from_chars(text.data() + begin, last, number);
    if (error != std::errc{} || stop != last || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
    begin = text.find_first_not_of(blanks, end);
  }
  return numbers;
}

std::string XmlElement::tag() const { return element_->Name(); }

int XmlElement::line() const { return element_->GetLineNum(); }

std::string XmlElement::where() const { return fmt::format("{}:{}", *file_, line()); }

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
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(begin);
  return std::string(text.substr(0, text.find_last_not_of(blanks) + 1));
}

std::vector<XmlElement> XmlElement::children() const {
  std::vector<XmlElement> result;
  for (const auto* c = element_->FirstChildElement(); c; c = c->NextSiblingElement()) result.emplace_back(c, file_);
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

XmlFile::XmlFile(const std::filesystem::path& file)
    : name_(file.string()), document_(std::make_unique<tinyxml2::XMLDocument>()) {
  const auto error = document_->LoadFile(name_.c_str());
  if (error == tinyxml2::XML_ERROR_FILE_NOT_FOUND || std::filesystem::is_directory(file)) {
    throw SetupError(one_line(fmt::format("{}: there is no such file", name_)));
  }
  if (error != tinyxml2::XML_SUCCESS || !document_->RootElement()) {
    const int line = std::max(1, document_->ErrorLineNum());
    throw SetupError(one_line(
        fmt::format("{}:{}: not well-formed XML ({}); correct the file there", name_, line, document_->ErrorName())));
  }
}

XmlFile::~XmlFile() = default;

XmlElement XmlFile::root() const { return {document_->RootElement(), &name_}; }

}  // namespace murosimf::io
