// Tokens of servers: each is another one, and only the whole token is taken.
#include "murosimf/network/token.h"

#include <set>

#include <gtest/gtest.h>

namespace murosimf::network {
namespace {

TEST(Token, IsAnotherOneEachTime) {
  std::set<std::string> drawn;
  for (int i = 0; i < 100; ++i) {
    const std::string token = new_token();
    EXPECT_EQ(token.size(), 32U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos) << token;
    drawn.insert(token);
  }
  EXPECT_EQ(drawn.size(), 100U);
}

TEST(Token, OnlyTheWholeTokenIsTaken) {
  EXPECT_TRUE(is_token("0123456789abcdef", "0123456789abcdef"));
  for (const char* wrong : {"", "0", "0123456789abcde", "0123456789abcdef0", "1123456789abcdef", "0123456789abcdeF"}) {
    EXPECT_FALSE(is_token(wrong, "0123456789abcdef")) << wrong;
  }
}

}  // namespace
}  // namespace murosimf::network
