// Which algorithms step together.
#include "murosimf/runtime/lane_jobs.h"

#include <numeric>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

using namespace std::chrono_literals;

class Counting final : public LaneGroup {
 public:
  explicit Counting(std::size_t members) : members_(members) {}
  void step(LaneMask, const Instant&) noexcept override {}
  [[nodiscard]] std::size_t members() const { return members_; }

 private:
  std::size_t members_;
};

constexpr int refusing = -1;  // a kind of which no group is made

/// Goes with those of its kind.
class OfKind final : public Algorithm {
 public:
  explicit OfKind(int kind) : kind_(kind) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::motion; }
  void step(const Instant&) noexcept override {}
  [[nodiscard]] bool goes_with(const Algorithm& other) const override {
    return kind_ == static_cast<const OfKind&>(other).kind_;
  }
  [[nodiscard]] std::unique_ptr<LaneGroup> join(std::span<Algorithm* const> members) const override {
    if (kind_ == refusing) return nullptr;
    return std::make_unique<Counting>(members.size());
  }

 private:
  int kind_;
};

/// The jobs of one wave of algorithms of these kinds; neighbors are at home in the same of the threads.
class Jobs {
 public:
  Jobs(const std::vector<int>& kinds, int threads) {
    std::vector<LaneJobs::Member> members;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      algorithms_.push_back(std::make_unique<OfKind>(kinds[i]));
      members.push_back({algorithms_.back().get(), 1ms, i * static_cast<std::size_t>(threads) / kinds.size()});
    }
    use(std::move(members), threads);
  }
  /// Of one kind, with these periods. 0: it steps alone.
  explicit Jobs(const std::vector<Duration>& periods) {
    std::vector<LaneJobs::Member> members;
    for (const Duration period : periods) {
      algorithms_.push_back(std::make_unique<OfKind>(0));
      members.push_back({period == 0ms ? nullptr : algorithms_.back().get(), period});
    }
    use(std::move(members), 1);
  }

  [[nodiscard]] std::vector<std::vector<std::size_t>> all() const {
    std::vector<std::vector<std::size_t>> result;
    for (const Job& job : jobs_->jobs) {
      result.push_back(job.algorithms);
      const auto* group = static_cast<const Counting*>(job.lanes);
      EXPECT_EQ(group ? group->members() : 1, job.algorithms.size());
    }
    return result;
  }
  [[nodiscard]] std::vector<std::size_t> sizes() const {
    std::vector<std::size_t> result;
    for (const Job& job : jobs_->jobs) result.push_back(job.algorithms.size());
    return result;
  }
  /// Behind the last job of each thread.
  [[nodiscard]] const std::vector<std::size_t>& ends() const { return jobs_->ends; }
  [[nodiscard]] std::size_t in_groups() const { return lane_jobs_.members_in_groups(); }

 private:
  void use(std::vector<LaneJobs::Member> members, int threads) {
    waves_ = {Wave(members.size())};
    std::iota(waves_[0].begin(), waves_[0].end(), std::size_t{0});
    lane_jobs_ = LaneJobs(std::move(members), threads);
    jobs_ = &lane_jobs_.of(waves_)[0];
    EXPECT_EQ(&lane_jobs_.of(waves_)[0], jobs_) << "made once";
  }

  std::vector<std::unique_ptr<OfKind>> algorithms_;
  std::vector<Wave> waves_;
  LaneJobs lane_jobs_;
  const WaveJobs* jobs_ = nullptr;
};

using Sizes = std::vector<std::size_t>;

TEST(LaneJobs, ThoseThatGoTogetherStepTogether) {
  const Jobs jobs({1, 2, 1, 2, 1, 3, 2, 1, 2, 1, 2}, 1);
  EXPECT_EQ(jobs.all(), (std::vector<Sizes>{{0, 2, 4, 7, 9}, {1, 3, 6, 8, 10}, {5}}));
  EXPECT_EQ(jobs.in_groups(), 10);
}

TEST(LaneJobs, EightAtMostInEvenGroups) {
  EXPECT_EQ(Jobs(std::vector<int>(8, 1), 1).sizes(), (Sizes{8}));
  EXPECT_EQ(Jobs(std::vector<int>(9, 1), 1).sizes(), (Sizes{4, 5}));
  EXPECT_EQ(Jobs(std::vector<int>(22, 1), 1).sizes(), (Sizes{7, 7, 8}));
}

TEST(LaneJobs, EveryThreadHasThoseThatAreAtHomeThere) {
  const Jobs jobs(std::vector<int>(22, 1), 2);
  EXPECT_EQ(jobs.sizes(), (Sizes{5, 6, 5, 6}));
  EXPECT_EQ(jobs.ends(), (Sizes{2, 4}));
  const Jobs mixed({1, 2, 1, 1, 2, 2, 1, 2, 2, 2, 2, 2}, 2);
  EXPECT_EQ(mixed.all(), (std::vector<Sizes>{{0, 2, 3}, {1, 4, 5}, {6}, {7, 8, 9, 10, 11}}));
  EXPECT_EQ(mixed.ends(), (Sizes{2, 4}));
}

TEST(LaneJobs, ThreadsWithoutWork) {
  const Jobs jobs(std::vector<int>(6, 1), 16);
  EXPECT_EQ(jobs.sizes(), Sizes(6, 1)) << "a thread for each";
  EXPECT_EQ(jobs.ends().size(), 16);
  EXPECT_EQ(jobs.ends().back(), 6);
  EXPECT_EQ(Jobs(std::vector<int>(1, 1), 16).sizes(), (Sizes{1}));
}

TEST(LaneJobs, OtherPeriodsAndLonersStepAlone) {
  const Jobs jobs(std::vector<Duration>{1ms, 5ms, 0ms, 1ms, 1ms, 5ms, 0ms, 1ms, 5ms, 5ms, 1ms, 5ms});
  EXPECT_EQ(jobs.all(), (std::vector<Sizes>{{0, 3, 4, 7, 10}, {1, 5, 8, 9, 11}, {2}, {6}}));
  EXPECT_EQ(jobs.in_groups(), 10);
}

TEST(LaneJobs, WhoMakesNoGroupStepsAlone) {
  EXPECT_EQ(Jobs(std::vector<int>(8, refusing), 1).sizes(), Sizes(8, 1));
  EXPECT_EQ(Jobs(std::vector<int>(8, refusing), 1).in_groups(), 0);
}

}  // namespace
}  // namespace murosimf
