#include "murosimf/recording/mcap/message_schema.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/recording/recording_schemas.h"

namespace murosimf {
namespace {

using namespace recording;

TEST(MessageSchema, IsReadAsItIsWrittenDown) {
  const MessageSchema schema = message_schema(
      "own.Thing",
      "enum Kind { NONE = 0; SOME = 7; } Kind kind = 1; repeated own.Thing parts = 3; optional double x = 2;");
  ASSERT_EQ(schema.enums.size(), 1U);
  EXPECT_EQ(schema.enums[0].values[1], (std::pair<std::string, int>{"SOME", 7}));
  ASSERT_EQ(schema.fields.size(), 3U);
  EXPECT_EQ(schema.fields[1].type, "own.Thing");
  EXPECT_EQ(schema.fields[1].number, 3);
  EXPECT_TRUE(schema.fields[1].repeated);
  EXPECT_TRUE(schema.fields[2].optional);
}

TEST(MessageSchema, RefusesWhatIsNone) {
  EXPECT_THROW((void)message_schema("own.Thing", "double x;"), SetupError);
  EXPECT_THROW((void)message_schema("own.Thing", "double x = one;"), SetupError);
  EXPECT_THROW((void)message_schema("own.Thing", "double x = 1"), SetupError);
  EXPECT_THROW((void)find_schema("foxglove.Nothing"), SetupError);
}

TEST(Protobuf, GivesBackWhatWasWritten) {
  std::string bytes;
  ProtobufWriter out(bytes);
  out.number(1, -0.1);
  out.varint(2, 300);
  out.text(3, std::string(200, 'x'));
  out.message(4, [](ProtobufWriter& in) { in.fixed64(1, ~std::uint64_t{0}); });
  out.number(5, 0);  // is not there
  ProtobufReader in(bytes);
  ASSERT_TRUE(in.next());
  EXPECT_EQ(in.number(), -0.1);
  ASSERT_TRUE(in.next());
  EXPECT_EQ(in.varint(), 300U);
  EXPECT_THROW((void)in.bytes(), SetupError);
  ASSERT_TRUE(in.next());
  EXPECT_EQ(in.bytes(), std::string(200, 'x'));
  ASSERT_TRUE(in.next());
  EXPECT_EQ(in.field(), 4);
  ProtobufReader inner = in.message();
  ASSERT_TRUE(inner.next());
  EXPECT_EQ(inner.fixed64(), ~std::uint64_t{0});
  EXPECT_FALSE(in.next());
}

TEST(Protobuf, RefusesWhatEndsTooEarly) {
  std::string bytes;
  ProtobufWriter out(bytes);
  out.number(1, 2.5);
  out.text(2, "words");
  for (std::size_t size : {3U, 10U, 12U}) {
    ProtobufReader in(std::string_view(bytes).substr(0, size));
    EXPECT_THROW(
        {
          while (in.next()) continue;
        },
        SetupError)
        << size;
  }
}

}  // namespace
}  // namespace murosimf
