/// xml_text.h - writes XML: nested elements with attributes, with the necessary escapes.
///
/// Numbers are the shortest decimals that read back as the same double.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>

#include "murosimf/math/vec3.h"

namespace murosimf::files {

class XmlText {
 public:
  XmlText();
  ~XmlText();
  XmlText(const XmlText&) = delete;
  XmlText& operator=(const XmlText&) = delete;

  XmlText& begin(const char* tag);
  XmlText& end();

  // Attributes of the element that was begun last and has no children yet.
  XmlText& text(const char* name, const std::string& value);
  XmlText& numbers(const char* name, std::initializer_list<double> values);
  XmlText& vector(const char* name, const Vec3d& v) { return numbers(name, {v.x, v.y, v.z}); }

  // Attributes that are omitted at their default.
  XmlText& text_unless_empty(const char* name, const std::string& value);
  XmlText& number_unless(double usual, const char* name, double value);
  XmlText& vector_unless_zero(const char* name, const Vec3d& v);

  /// The text inside of the element that was begun last.
  XmlText& content(const std::string& text);

  /// Two hyphens in a row, which XML forbids in comments, become one.
  XmlText& comment(const std::string& text);

  /// The text so far.
  [[nodiscard]] std::string result() const;

 private:
  struct Printer;
  std::unique_ptr<Printer> printer_;
};

}  // namespace murosimf::files
