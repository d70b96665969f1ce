// Which thread does what of which entity.
#include "murosimf/runtime/thread_affinity.h"

#include <deque>

#include <gtest/gtest.h>

#include "murosimf/world/entity.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

class HomesTest : public testing::Test {
 protected:
  /// That many entities more.
  std::vector<const Entity*> more(std::size_t count) {
    static const ModelPtr model = std::make_shared<const Model>(fixtures::two_legged());
    std::vector<const Entity*> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(&entities_.emplace_back("robot", model));
    return result;
  }
  static std::vector<std::size_t> of(const ThreadAffinity& thread_affinity,
                                     const std::vector<const Entity*>& entities) {
    std::vector<std::size_t> result;
    for (const Entity* entity : entities) result.push_back(thread_affinity.of(*entity));
    return result;
  }

 private:
  std::deque<Entity> entities_;
};

using Threads = std::vector<std::size_t>;

TEST_F(HomesTest, NeighborsShareAThread) {
  ThreadAffinity thread_affinity(3);
  const auto entities = more(8);
  thread_affinity.share_out(entities);
  EXPECT_EQ(of(thread_affinity, entities), (Threads{0, 0, 0, 1, 1, 1, 2, 2}));
}

TEST_F(HomesTest, TheLargerShareGoesToWhoHasLeast) {
  ThreadAffinity thread_affinity(2);
  const auto blue = more(3), red = more(3), ball = more(1);
  thread_affinity.share_out(blue);
  thread_affinity.share_out(red);
  thread_affinity.share_out(ball);
  EXPECT_EQ(of(thread_affinity, blue), (Threads{0, 0, 1}));
  EXPECT_EQ(of(thread_affinity, red), (Threads{0, 1, 1}));
  EXPECT_EQ(of(thread_affinity, ball), (Threads{0}));
}

TEST_F(HomesTest, MoreThreadsThanEntities) {
  ThreadAffinity thread_affinity(16);
  const auto first = more(2), second = more(3);
  thread_affinity.share_out(first);
  thread_affinity.share_out(second);
  EXPECT_EQ(of(thread_affinity, first), (Threads{0, 1}));
  EXPECT_EQ(of(thread_affinity, second), (Threads{2, 3, 4}));
}

TEST_F(HomesTest, WhoWasNotSharedOutIsAtHomeInTheCallingThread) {
  EXPECT_EQ(of(ThreadAffinity(4), more(1)), (Threads{0}));
}

}  // namespace
}  // namespace murosimf
