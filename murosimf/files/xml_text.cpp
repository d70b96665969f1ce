#include "murosimf/files/xml_text.h"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tinyxml2.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"

namespace murosimf::files {

struct XmlText::Printer : tinyxml2::XMLPrinter {};

XmlText::XmlText() : printer_(std::make_unique<Printer>()) {}
XmlText::~XmlText() = default;

XmlText& XmlText::begin(const char* tag) {
  printer_->OpenElement(tag);
  return *this;
}

XmlText& XmlText::end() {
  printer_->CloseElement();
  return *this;
}

XmlText& XmlText::text(const char* name, const std::string& value) {
  MUROSIMF_ASSERT(name != nullptr);
  printer_->PushAttribute(name, value.c_str());
  return *this;
}

XmlText& XmlText::numbers(const char* name, std::initializer_list<double> values) {
  std::vector<double> shown;
  for (const double value : values) shown.push_back(value + 0.0);  // no -0
  return text(name, fmt::format("{}", fmt::join(shown, " ")));
}

XmlText& XmlText::text_unless_empty(const char* name, const std::string& value) {
  return value.empty() ? *this : text(name, value);
}

XmlText& XmlText::number_unless(double usual, const char* name, double value) {
  return value == usual ? *this : numbers(name, {value});
}

XmlText& XmlText::vector_unless_zero(const char* name, const Vec3d& v) { return is_zero(v) ? *this : vector(name, v); }

XmlText& XmlText::content(const std::string& text) {
  printer_->PushText(text.c_str());
  return *this;
}

XmlText& XmlText::comment(const std::string& text) {
  std::string safe;
  for (const char c : one_line(text)) {
    if (c != '-' || !safe.ends_with('-')) safe += c;
  }
  printer_->PushComment((" " + safe + " ").c_str());
  return *this;
}

std::string XmlText::result() const { return printer_->CStr(); }

}  // namespace murosimf::files
