// Trial steps until the law agrees: how many there are, which forces each of them meets, and what is left in the end.
#include "murosimf/dynamics/contact_trials.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/model/properties.h"
#include "tests/dynamics/part.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

using fixtures::difference;

/// Refuses some trials, each time with one newton more; what it commits is a force of its own.
struct Stubborn final : collision::ContactLaw {
  using Points = std::span<collision::ContactPoint>;
  using Velocities = std::span<const Vec3d>;
  void prepare(std::vector<collision::ContactPoint>&, const collision::ContactTerms&) const noexcept override {}
  bool accept(Points points, const collision::ContactTerms&, Velocities velocities) const noexcept override {
    ++asked;
    seen.assign(velocities.begin(), velocities.end());
    if (asked > refusals) return true;
    points[0].force.z += 1;
    return false;
  }
  void commit(Points points, const collision::ContactTerms&, Velocities velocities) const noexcept override {
    committed.assign(velocities.begin(), velocities.end());
    points[0].force = {0, 0, 50};
  }
  int refusals = 0;
  mutable int asked = 0;
  mutable std::vector<Vec3d> seen, committed;
};

/// A body at (1, 2, 3) that carries 7 N along x besides its contact, which pushes with 10 N, 0.5 m beside its origin.
struct Trials : test::Alone<ContactTrials> {
  Trials() : Alone(Chain{}.base("body").with(properties::mass, 1.0)) {
    holder.columns.r[0] = {1, 2, 3};
    std::ranges::fill(entity.column(properties::external_force).values, Wrenchd{});
    std::ranges::fill(entity.column(properties::external_damping).values, Sym6d{});
    set().points.resize(1);
    set().points[0].point = {1.5, 2, 3};
    set().points[0].force = {0, 0, 10};
    set().points[0].normal = {0, 0, 1};
    set().rest_force = {{{}, {7, 0, 0}}};
    set().loaded = {0};
    interface().law = &law;
  }
  collision::ContactSet& set() { return entity.column(collision::contacts).values[0]; }
  collision::ContactInterface& interface() { return entity.column(collision::contact_interface).values[0]; }
  [[nodiscard]] const Wrenchd& load() { return entity.column(properties::external_force).values[0]; }
  /// How many trials there were; `wanted` of them are not satisfied with themselves.
  int settle(int wanted = 0) {
    int trials = 0;
    part->settle([&] {
      ++trials;
      part->predict([&](const collision::ContactPoint& c) { return Vec3d{c.point.x, 0, 1.0 * trials}; });
      return trials > wanted;
    });
    return trials;
  }
  Stubborn law;
};

TEST(ContactTrials, OneIsEnoughIfEverybodyAgrees) {
  Trials trials;
  EXPECT_EQ(trials.settle(), 1);
  EXPECT_EQ(trials.law.asked, 1);
  ASSERT_EQ(trials.law.seen.size(), 1U);
  EXPECT_EQ(difference(trials.law.seen[0], {1.5, 0, 1}), 0);
  EXPECT_EQ(norm(trials.load().f), 0) << "loads stay as they are";
}

TEST(ContactTrials, GoOnUntilTheLawAgrees) {
  Trials trials;
  trials.law.refusals = 2;
  EXPECT_EQ(trials.settle(), 3);
  EXPECT_EQ(trials.law.asked, 3);
  EXPECT_EQ(trials.law.seen[0].z, 3) << "that of the last trial";
  EXPECT_LT(difference(trials.load().f, {7, 0, 12}), 1e-12) << "what the law said last, and the rest";
  EXPECT_LT(difference(trials.load().n, {0, -6, 0}), 1e-12);
}

TEST(ContactTrials, GoOnWhileTheMotionWantsMore) {
  Trials trials;
  EXPECT_EQ(trials.settle(3), 4);
  Trials without;
  without.interface().law = nullptr;
  EXPECT_EQ(without.settle(2), 3);
  EXPECT_EQ(without.law.asked, 0);
}

TEST(ContactTrials, EndAfterTheLastPass) {
  Trials trials;
  trials.law.refusals = 100;
  EXPECT_EQ(trials.settle(), collision::max_passes);
  Trials restless;
  EXPECT_EQ(restless.settle(100), collision::max_passes);
}

TEST(ContactTrials, CommitLeavesTheForcesThatActed) {
  Trials trials;
  EXPECT_EQ(trials.settle(), 1);
  trials.part->commit();
  ASSERT_EQ(trials.law.committed.size(), 1U);
  EXPECT_EQ(difference(trials.law.committed[0], {1.5, 0, 1}), 0);
  EXPECT_LT(difference(trials.load().f, {7, 0, 50}), 1e-12);
  EXPECT_LT(difference(trials.load().n, {0, -25, 0}), 1e-12);
}

// Rule: what an island solver has settled is not committed again; without a law there is nothing to commit.
TEST(ContactTrials, WhatIsSolvedStaysAsItIs) {
  Trials trials;
  trials.set().solved = true;
  EXPECT_TRUE(trials.part->solved());
  trials.part->commit();
  EXPECT_TRUE(trials.law.committed.empty());
  EXPECT_EQ(norm(trials.load().f), 0);
  trials.part->renew();
  EXPECT_FALSE(trials.part->solved());
  trials.interface().law = nullptr;
  trials.part->commit();
  EXPECT_EQ(norm(trials.load().f), 0);
}

TEST(ContactTrials, KnowWhetherAnythingHolds) {
  Trials trials;
  EXPECT_FALSE(trials.part->none());
  trials.set().points.clear();
  EXPECT_TRUE(trials.part->none());
  trials.set().island_stands = true;
  EXPECT_TRUE(trials.part->none()) << "of a step before";
  trials.set().solved = true;
  EXPECT_FALSE(trials.part->none());
  trials.set().island_stands = false;
  EXPECT_TRUE(trials.part->none());
}

}  // namespace
}  // namespace murosimf::dynamics
