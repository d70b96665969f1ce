// Readers that remember columns see the same contacts as others, also when levels move columns.
#include "murosimf/recording/recorded_contacts.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/scene/contact_marks.h"
#include "murosimf/scene/scene.h"

namespace murosimf {
namespace {

using namespace std::chrono_literals;

TEST(ContactWatch, SeesWhatIsThere) {
  scene::Scene scene("three_on_three",
                     {.events = {"0.1:blue1.level=articulated_dynamics", "0.2:blue1.level=kinematic_walking",
                                 "0.3:blue1.level=articulated_dynamics"},
                      .cameras = false});
  recording::ContactWatch watch;
  std::size_t most = 0;
  for (int i = 0; i < 40; ++i) {
    scene.simulation().run(10ms);
    std::vector<ContactMark> seen, wanted;
    watch.add(scene.simulation().world(), seen);
    scene::add_contact_marks(scene.simulation().world(), wanted);
    ASSERT_EQ(seen.size(), wanted.size()) << i;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      EXPECT_EQ(norm(seen[k].point - wanted[k].point) + norm(seen[k].force - wanted[k].force), 0) << i;
      EXPECT_EQ(seen[k].ground_contact_of, wanted[k].ground_contact_of) << i;
    }
    most = std::max(most, seen.size());
  }
  EXPECT_GT(most, 10U);
}

}  // namespace
}  // namespace murosimf
