#include "murosimf/viewer/input.h"

#include <gtest/gtest.h>

namespace murosimf::viewer {
namespace {

/// One letter an event: p press and r release of the left button, P R of the right one, m move, w wheel, k key, K key up, g again, t text.
std::vector<Input> events(const std::string& letters) {
  std::vector<Input> all;
  for (const char c : letters) {
    switch (c) {
      case 'p': all.push_back(ButtonInput{0, true}); break;
      case 'r': all.push_back(ButtonInput{0, false}); break;
      case 'P': all.push_back(ButtonInput{1, true}); break;
      case 'R': all.push_back(ButtonInput{1, false}); break;
      case 'm': all.push_back(MoveInput{}); break;
      case 'w': all.push_back(WheelInput{1}); break;
      case 'k': all.push_back(KeyInput{{.key = "A"}, true, false}); break;
      case 'K': all.push_back(KeyInput{{.key = "A"}, false, false}); break;
      case 'g': all.push_back(KeyInput{{.key = "A"}, true, true}); break;
      default: all.push_back(TextInput{'a'});
    }
  }
  return all;
}

/// How many events each picture gets.
std::vector<std::size_t> pictures(const std::string& letters) {
  InputQueue queue;
  queue.add(events(letters));
  std::vector<std::size_t> counts;
  while (!queue.empty()) counts.push_back(queue.next().size());
  return counts;
}

using Counts = std::vector<std::size_t>;

TEST(InputQueue, AClickOfNoLengthIsSeenPressedAndReleased) {
  EXPECT_EQ(pictures("pr"), (Counts{1, 1}));
  EXPECT_EQ(pictures("prpr"), (Counts{1, 1, 1, 1}));
  EXPECT_EQ(pictures("pPrR"), (Counts{2, 2}));
}

TEST(InputQueue, AButtonIsPressedWhereThePointerWasSeen) {
  EXPECT_EQ(pictures("mmpr"), (Counts{2, 1, 1}));
  EXPECT_EQ(pictures("pmmr"), (Counts{1, 3}));
  EXPECT_EQ(pictures("prm"), (Counts{1, 1, 1}));
}

TEST(InputQueue, TheWheelTurnsWhereThePointerIs) {
  EXPECT_EQ(pictures("mwwm"), (Counts{3, 1}));
  EXPECT_EQ(pictures("wp"), (Counts{1, 1}));
  EXPECT_EQ(pictures("pw"), (Counts{1, 1}));
}

TEST(InputQueue, KeysAndLettersKeepTheirOrder) {
  EXPECT_EQ(pictures("kK"), (Counts{1, 1}));
  EXPECT_EQ(pictures("kgggK"), (Counts{4, 1}));
  EXPECT_EQ(pictures("tttk"), (Counts{4}));
  EXPECT_EQ(pictures("kt"), (Counts{1, 1}));
}

TEST(InputQueue, NothingIsLost) {
  InputQueue queue;
  EXPECT_TRUE(queue.next().empty());
  queue.add(events("mpr"));
  EXPECT_EQ(queue.next().size(), 1U);
  queue.add(events("m"));
  std::size_t rest = 0;
  while (!queue.empty()) rest += queue.next().size();
  EXPECT_EQ(rest, 3U);
}

}  // namespace
}  // namespace murosimf::viewer
