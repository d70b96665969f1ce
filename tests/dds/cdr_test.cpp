// CDR against bytes by hand from the specification; readers against truncated and mutated messages.
#include "murosimf/dds/cdr.h"

#include <gtest/gtest.h>

namespace murosimf::dds {
namespace {

TEST(Cdr, PutsNumbersAtMultiplesOfTheirSize) {
  CdrWriter writer;
  writer.number<std::uint8_t>(7).number<std::uint32_t>(0x01020304).number<std::uint8_t>(9).number(1.0);
  const Bytes expected{0, 1, 0, 0,                 // encapsulation: CDR, little endian
                       7, 0, 0, 0, 4, 3, 2,    1,  // padded to 4
                       9, 0, 0, 0, 0, 0, 0,    0,  // padded to 8, counted from behind the encapsulation
                       0, 0, 0, 0, 0, 0, 0xF0, 0x3F};
  EXPECT_EQ(writer.bytes(), expected);
  CdrReader reader(expected);
  EXPECT_EQ(reader.number<std::uint8_t>(), 7);
  EXPECT_EQ(reader.number<std::uint32_t>(), 0x01020304U);
  EXPECT_EQ(reader.number<std::uint8_t>(), 9);
  EXPECT_EQ(reader.number<double>(), 1.0);
  EXPECT_TRUE(reader.good());
  EXPECT_EQ(reader.number<std::uint8_t>(), 0);
  EXPECT_FALSE(reader.good());
}

TEST(Cdr, CountsTheZeroOfTexts) {
  CdrWriter writer;
  writer.text("ab").text("");
  const Bytes expected{0, 1, 0, 0, 3, 0, 0, 0, 'a', 'b', 0, 0, 1, 0, 0, 0, 0};
  EXPECT_EQ(writer.bytes(), expected);
  CdrReader reader(expected);
  EXPECT_EQ(reader.text(), "ab");
  EXPECT_EQ(reader.text(), "");
  EXPECT_TRUE(reader.good());
  writer.clear();
  EXPECT_EQ(writer.bytes(), (Bytes{0, 1, 0, 0}));
}

TEST(Cdr, RefusesOtherEncapsulations) {
  for (const Bytes& bytes : {Bytes{}, Bytes{0, 1, 0}, Bytes{0, 0, 0, 0, 1}, Bytes{0, 7, 0, 0, 1}}) {
    CdrReader reader(bytes);
    EXPECT_FALSE(reader.good());
    EXPECT_EQ(reader.number<std::uint8_t>(), 0);
  }
}

TEST(Cdr, ReadsNothingBeyondTheEnd) {
  const Bytes long_text{0, 1, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 'a', 0}, no_text{0, 1, 0, 0, 0, 0, 0, 0};
  for (const Bytes& bytes : {long_text, no_text}) {
    CdrReader reader(bytes);
    EXPECT_EQ(reader.text(), "");
    EXPECT_FALSE(reader.good());
  }
  CdrReader reader(long_text);
  EXPECT_EQ(reader.count(10), 0U);
  EXPECT_FALSE(reader.good());
}

}  // namespace
}  // namespace murosimf::dds
