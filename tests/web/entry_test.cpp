#include "murosimf/web/entry.h"

#include <gtest/gtest.h>

namespace murosimf::web {
namespace {

const AccessRules loopback{.loopback = true, .token = "0123456789abcdef"};
const AccessRules anywhere{.loopback = false, .token = "0123456789abcdef"};

TEST(Entry, ProgramsAndOwnPagesOnThisComputer) {
  EXPECT_TRUE(may_enter(loopback, {.host = "127.0.0.1:8080", .origin = {}, .token = {}}));
  EXPECT_TRUE(may_enter(loopback, {.host = "localhost:8080", .origin = "http://localhost:8080", .token = {}}));
  EXPECT_TRUE(may_enter(loopback, {.host = "[::1]:8080", .origin = "http://[::1]:8080", .token = {}}));
}

TEST(Entry, PagesOfOtherServersOnThisComputerNeedTheToken) {
  for (const char* origin :
       {"http://localhost:3000", "http://127.0.0.1:8081", "http://127.0.0.1", "https://localhost"}) {
    EXPECT_FALSE(may_enter(loopback, {.host = "localhost:8080", .origin = origin, .token = {}})) << origin;
    EXPECT_TRUE(may_enter(loopback, {.host = "localhost:8080", .origin = origin, .token = loopback.token})) << origin;
  }
}

TEST(Entry, PagesFromElsewhereNeedTheToken) {
  const Visitor page{.host = "127.0.0.1:8080", .origin = "https://evil.example", .token = {}};
  EXPECT_FALSE(may_enter(loopback, page));
  EXPECT_FALSE(may_enter(loopback, {.host = page.host, .origin = "null", .token = {}}));
  EXPECT_FALSE(may_enter(loopback, {.host = page.host, .origin = "http://localhost.evil.example", .token = {}}));
  EXPECT_FALSE(may_enter(loopback, {.host = page.host, .origin = "http://127.evil.example", .token = {}}));
  EXPECT_TRUE(may_enter(loopback, {.host = page.host, .origin = page.origin, .token = loopback.token}));
}

TEST(Entry, ANameThatLeadsHereNeedsTheToken) {
  EXPECT_FALSE(may_enter(loopback, {.host = "evil.example:8080", .origin = "http://evil.example:8080", .token = {}}));
  EXPECT_FALSE(may_enter(loopback, {.host = "", .origin = {}, .token = {}}));
}

TEST(Entry, OtherComputersNeedTheToken) {
  EXPECT_FALSE(may_enter(anywhere, {.host = "127.0.0.1:8080", .origin = {}, .token = {}}));
  EXPECT_FALSE(may_enter(anywhere, {.host = "10.0.0.7:8080", .origin = {}, .token = "0123456789abcdeg"}));
  EXPECT_FALSE(may_enter(anywhere, {.host = "10.0.0.7:8080", .origin = {}, .token = "0123456789abcde"}));
  EXPECT_TRUE(may_enter(anywhere, {.host = "10.0.0.7:8080", .origin = {}, .token = anywhere.token}));
}

TEST(Entry, NoTokenOpensNothing) {
  EXPECT_FALSE(may_enter({.loopback = false, .token = ""}, {.host = "10.0.0.7", .origin = {}, .token = ""}));
}

TEST(Entry, TokensAreLongAndDiffer) {
  EXPECT_EQ(new_token().size(), 32U);
  EXPECT_NE(new_token(), new_token());
}

}  // namespace
}  // namespace murosimf::web
