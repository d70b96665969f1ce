#include "murosimf/world/state_archive.h"

#include <array>
#include <cstdint>
#include <map>

#include <gtest/gtest.h>

#include "murosimf/math/spatial.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::error_of;

struct Inner {
  int number = 0;
  std::string name;
  void state(StateArchive& archive) { archive(number, name); }
  friend bool operator==(const Inner&, const Inner&) = default;
};

struct Outer {
  double x = 0;
  std::vector<Inner> inner;
  std::vector<double> numbers;
  std::optional<std::string> text;
  std::vector<std::pair<int, Vec3d>> pairs;
};
void state(StateArchive& archive, Outer& outer) {
  archive(outer.x, outer.inner, outer.numbers, outer.text, outer.pairs);
}

std::vector<std::byte> saved(Outer outer) {
  std::vector<std::byte> bytes;
  StateArchive archive(bytes);
  archive(outer);
  return bytes;
}

const Outer full{1.5, {{3, "three"}, {-4, ""}}, {1, 2, 3}, "text", {{7, {1, 2, 3}}}};

TEST(StateArchive, LoadsWhatItSaved) {
  const auto bytes = saved(full);
  Outer loaded{9, {{1, "old"}}, {}, std::nullopt, {}};
  StateArchive archive{std::span(bytes)};
  EXPECT_TRUE(archive.loads());
  archive(loaded);
  EXPECT_EQ(archive.left(), 0U);
  EXPECT_EQ(loaded.x, 1.5);
  EXPECT_EQ(loaded.inner, full.inner);
  EXPECT_EQ(loaded.numbers, full.numbers);
  EXPECT_EQ(loaded.text, full.text);
  ASSERT_EQ(loaded.pairs.size(), 1U);
  EXPECT_EQ(loaded.pairs[0].first, 7);
  EXPECT_EQ(loaded.pairs[0].second.z, 3);
  EXPECT_EQ(saved(loaded), bytes);
  const auto empty = saved({});
  StateArchive again{std::span(empty)};
  again(loaded);
  EXPECT_EQ(saved(loaded), empty) << "what is not there goes";
}

// Truncated bytes are reported wherever they end; sizes that they contain are checked.
TEST(StateArchive, NoticesThatBytesEnd) {
  const auto bytes = saved(full);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Outer loaded;
    StateArchive archive{std::span(bytes).first(size)};
    EXPECT_EQ(error_of([&] { archive(loaded); }), "it ends too early") << size;
  }
  const std::vector<std::byte> huge(sizeof(std::uint64_t), std::byte{0xff});
  std::vector<double> numbers;
  StateArchive archive{std::span(huge)};
  EXPECT_EQ(error_of([&] { archive(numbers); }), "it ends too early");
}

enum class Kind : std::uint8_t { none, some };
struct Gap {
  bool first = false;
  double second = 0;
};
struct Tail {
  Vec3d place;
  float end = 0;
};
struct Full {
  Kind kind = Kind::some;
  std::uint8_t small = 0;
  std::uint16_t large = 0;
  float number = 0;
  std::array<Vec3d, 2> places;
};

// Bytes of no member differ between equal values.
static_assert(WithoutPadding<double> && WithoutPadding<bool> && WithoutPadding<Vec3d> && WithoutPadding<Full>);
static_assert(!WithoutPadding<Gap> && !WithoutPadding<Tail> && !WithoutPadding<std::array<Gap, 2>>);

TEST(StateArchive, ElementsStayAsManyAsTheyAre) {
  std::vector<double> three{1, 2, 3}, loaded{7, 8, 9}, two(2);
  std::vector<std::byte> bytes;
  StateArchive saving(bytes);
  saving.elements(std::span(three));
  const double* place = loaded.data();
  StateArchive loading{std::span(std::as_const(bytes))};
  loading.elements(std::span(loaded));
  EXPECT_EQ(loaded, three);
  EXPECT_EQ(loaded.data(), place);
  StateArchive wrong{std::span(std::as_const(bytes))};
  EXPECT_EQ(error_of([&] { wrong.elements(std::span(two)); }), "it has 3 values, not 2");
}

}  // namespace
}  // namespace murosimf
