// Registries: entries are found by their names, for good, also by concurrent readers.
#include "murosimf/model/registry.h"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "murosimf/model/find_entry.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

struct Tool {
  std::string name;
  std::function<int()> use = {};
};

using fixtures::error_of;

TEST(Registry, FindsWhatWasAdded) {
  Registry<Tool> tools("tool", {{"hammer", [] { return 1; }}, {"saw", [] { return 2; }}});
  EXPECT_EQ(tools.find("saw").use(), 2);
  EXPECT_EQ(tools.look_for("file"), nullptr);
  EXPECT_EQ(tools.add({"file", [] { return 3; }}).use(), 3);
  EXPECT_EQ(tools.find("file").use(), 3);
  EXPECT_EQ(tools.names(), (std::vector<std::string_view>{"hammer", "saw", "file"}));
}

TEST(Registry, NamesTheNearestOfWhatIsNotThere) {
  const Registry<Tool> tools("tool", {{"hammer"}, {"saw"}});
  EXPECT_EQ(error_of([&] { (void)tools.find("hamer"); }), "unknown tool 'hamer'; did you mean 'hammer'?");
  EXPECT_EQ(error_of([&] { (void)find_entry(tools, "machine", "xyz"); }), "unknown machine 'xyz'; known: hammer, saw");
}

TEST(Registry, RefusesNamesTwiceAndNoName) {
  Registry<Tool> tools("tool", {{"hammer"}, {"saw"}});
  EXPECT_EQ(error_of([&] {
              tools.add({"saw", [] { return 7; }});
            }),
            "there is a tool 'saw' already; choose another name");
  EXPECT_EQ(error_of([&] { tools.add({""}); }), "a tool without a name cannot be added");
  EXPECT_FALSE(tools.find("saw").use) << "the first one stays";
  EXPECT_EQ(tools.names().size(), 2u);
}

TEST(Registry, ReferencesStay) {
  Registry<Tool> tools("tool", {{"hammer"}});
  const Tool* hammer = &tools.find("hammer");
  const std::string_view name = tools.names().front();
  for (int i = 0; i < 1000; ++i) tools.add({"tool_" + std::to_string(i)});
  EXPECT_EQ(hammer, &tools.find("hammer"));
  EXPECT_EQ(name.data(), hammer->name.data());
}

// Threads that read see whole entries, and never fewer than before. The thread sanitizer looks on, too.
TEST(Registry, IsReadWhileItGrows) {
  constexpr int last = 2000;
  Registry<Tool> tools("tool");
  std::vector<std::thread> readers;
  for (int reader = 0; reader < 3; ++reader) {
    readers.emplace_back([&tools] {
      for (int seen = 0; seen < last;) {
        int number = 0;
        for (const Tool& tool : tools) EXPECT_EQ(tool.use(), number++);
        EXPECT_GE(number, seen);
        seen = number;
      }
    });
  }
  for (int i = 0; i < last; ++i) tools.add({"tool_" + std::to_string(i), [i] { return i; }});
  for (std::thread& reader : readers) reader.join();
}

}  // namespace
}  // namespace murosimf
