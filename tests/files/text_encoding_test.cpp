// Texts in other encodings than UTF-8: those that are read, and the errors of others.
#include "murosimf/files/text_encoding.h"

#include <gtest/gtest.h>

#include <fstream>

#include "murosimf/files/csv_file.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/files/xml_element.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

/// ASCII and one character beyond the first 65,536, in code units of `unit` bytes.
std::string encoded(const std::string& ascii, std::size_t unit, bool low_first, bool mark) {
  std::string bytes;
  const auto put = [&](std::uint32_t value) {
    for (std::size_t i = 0; i < unit; ++i) {
      bytes += static_cast<char>(value >> 8 * (low_first ? i : unit - 1 - i) & 0xff);
    }
  };
  if (mark) put(0xfeff);
  for (const char c : ascii) put(static_cast<unsigned char>(c));
  if (unit == 4) {
    put(0x1f916);
  } else {
    put(0xd83e);
    put(0xdd16);
  }
  return bytes;
}

TEST(TextEncoding, IsToldByItsMarkOrByItsZeros) {
  for (const std::size_t unit : {2U, 4U}) {
    for (const bool low_first : {true, false}) {
      for (const bool mark : {true, false}) {
        EXPECT_EQ(to_utf8(encoded("<robot/>", unit, low_first, mark), "a.xml"), "<robot/>\xf0\x9f\xa4\x96")
            << unit << low_first << mark;
      }
    }
  }
  EXPECT_EQ(to_utf8("\xef\xbb\xbf<a/>", "a.xml"), "<a/>");
  EXPECT_EQ(to_utf8("<a/>", "a.xml"), "<a/>");
  EXPECT_EQ(to_utf8("", "a.xml"), "");
}

TEST(TextEncoding, RefusesWhatIsCutOffOrImpossible) {
  const auto refusal = [](const std::string& bytes) {
    return fixtures::error_of([&] { (void)to_utf8(bytes, "a.xml"); });
  };
  using namespace std::string_literals;
  EXPECT_EQ(refusal("\xff\xfe<\0r"s), "a.xml: the file is UTF-16 and ends within a character; save the file as UTF-8");
  for (const std::string& bytes :
       {"\xff\xfe\x16\xdd"s, "\xff\xfe\x3e\xd8"s, "\xff\xfe\x3e\xd8<\0"s, "\xff\xfe\0\0\0\0\x11\0"s}) {
    EXPECT_TRUE(fixtures::says(refusal(bytes), {"has a character that does not exist"}));
  }
}

TEST(TextEncoding, OfXmlMayBeDeclared) {
  const std::string head = "<?xml version='1.0' encoding='ISO-8859-1'?>";
  EXPECT_EQ(xml_to_utf8(head + "<a n='\xfc'/>", "a.xml"), head + "<a n='\xc3\xbc'/>");
  const std::string other = "<?xml version=\"1.0\" encoding=\"Shift_JIS\"?>";
  EXPECT_EQ(xml_to_utf8(other + "<a/>", "a.xml"), other + "<a/>");
  const auto what = fixtures::error_of([&] { (void)xml_to_utf8(other + "<a n='\x83'/>", "a.xml"); });
  EXPECT_EQ(what, "a.xml: the file is declared to be shift_jis; save the file as UTF-8");
}

TEST(TextEncoding, IsThatOfEveryReader) {
  const auto folder = fixtures::temp_folder();
  const auto write = [&](const std::string& name, const std::string& text) {
    const auto file = folder / name;
    std::string bytes = encoded(text, 2, true, true);
    bytes.resize(bytes.size() - 4);  // without the last character
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  };
  EXPECT_EQ(XmlFile(write("encoded.xml", "<?xml version='1.0' encoding='UTF-16'?>\n<robot name='r'/>")).root().line(),
            2);
  EXPECT_EQ(parse_toml_file(write("encoded.toml", "a = 3\n"))["a"].value_or(0), 3);
  EXPECT_EQ(read_csv(write("encoded.csv", "time [s];x\n0;0,5\n")).columns.at(0).values.at(0), 0.5);
}

}  // namespace
}  // namespace murosimf::files
