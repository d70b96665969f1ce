// Limits of nesting in a TOML file, checked before the library parses it.
#include "murosimf/files/toml_bounds.h"

#include <gtest/gtest.h>

#include <string>

#include "murosimf/model/error.h"
#include "tests/fixtures.h"

namespace murosimf::files {
namespace {

using fixtures::error_of;
using fixtures::says;

std::string repeated(std::string_view text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

std::string complaint(const std::string& text) {
  return error_of([&] { check_toml_bounds(text, "a.toml"); });
}

TEST(TomlBounds, TakeWhatPeopleWrite) {
  for (const std::string& text :
       {std::string(), std::string("a = 1.5\n[b.c]\nd = [[1.0, 2.0], [3.0]]\ne = {f = {g = 1}}\n"),
        repeated("a.b.c = 1.5\n", 1000), "a = [" + repeated("1.5, ", 1000) + "]",
        "a = [" + repeated("[1], ", 1000) + "]", "a = \"" + repeated(".", 1000) + "\" # " + repeated(".[", 1000),
        "a = '''\n" + repeated(".[{\n", 1000) + "''' # it's\nb = \"\"\"" + repeated("[\\\"", 100) + "\"\"\"",
        repeated("a.", most_key_parts - 1) + "a = 1",
        "a = " + repeated("[", most_open_brackets) + repeated("]", most_open_brackets)}) {
    EXPECT_EQ(complaint(text), "no error") << text.substr(0, 60);
  }
}

TEST(TomlBounds, RefuseWhatWouldEndTheStack) {
  EXPECT_TRUE(says(complaint("a = 1\n " + repeated("a.", 50000) + "a = 1"), {"a.toml:2:65: more than 32 parts"}));
  EXPECT_TRUE(says(complaint("[" + repeated("'a' . ", 50000) + "a]"), {"a.toml:1:", "more than 32 parts"}));
  EXPECT_TRUE(says(complaint("a = " + repeated("[", 50000)), {"a.toml:1:69: more than 64 brackets"}));
  EXPECT_TRUE(says(complaint("a = " + repeated("{a=[", 50000)), {"more than 64 brackets"}));
  EXPECT_TRUE(says(complaint("a = \"no end\n" + repeated("[", 65)), {"a.toml:2:65: "})) << "a text ends with its line";
}

}  // namespace
}  // namespace murosimf::files
