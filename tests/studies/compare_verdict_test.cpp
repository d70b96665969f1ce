// Which level is recommended, and what the sentence says, for made-up comparisons.
#include "murosimf/studies/compare_verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "murosimf/model/error.h"

namespace murosimf::studies {
namespace {

CompareEntry entry(const std::string& level, double cost, const Deviations& deviations = {}) {
  CompareEntry e;
  e.level = level;
  if (level != "kinematic_walking") e.contact = "implicit_stick";
  e.cost = cost;
  e.deviations = deviations;
  e.measures.events = {{0, false}};
  e.measures.path_length = 2;
  if (level == "full_dynamics" || level == "articulated_dynamics") e.measures.peak_joint = "knee";
  return e;
}

/// All four levels, none of which deviates; the last one is the reference.
Comparison four_levels() {
  Comparison c;
  c.entries = {entry("kinematic_walking", 1000), entry("simplified_dynamics", 2000), entry("full_dynamics", 3000),
               entry("articulated_dynamics", 4000)};
  c.reference = 3;
  return c;
}

void fall(CompareEntry& e, double time) {
  e.measures.events.push_back({time, true});
  e.measures.falls += 1;
}

void set(Deviations& deviations, const ComparedQuantity& quantity, double value) {
  if (quantity.of_another) {
    deviations.*quantity.of_another = {value, "ball"};
  } else {
    deviations.*quantity.deviation = value;
  }
}

bool says(const Recommendation& r, const std::string& words) { return r.sentence.find(words) != std::string::npos; }

TEST(Verdict, TheCheapestLevelIsAdequateIfNothingDeviates) {
  const Recommendation r = recommend(four_levels(), {});
  EXPECT_EQ(r.level, "kinematic_walking");
  EXPECT_TRUE(says(r, "kinematic_walking is adequate: within 0 % of the path")) << r.sentence;
  EXPECT_TRUE(says(r, "at 0.25 of the cost of articulated_dynamics")) << r.sentence;
  EXPECT_TRUE(says(r, "full_dynamics and up are needed for joint torques")) << r.sentence;
}

TEST(Verdict, WhateverIsOverItsThresholdDisqualifies) {
  for (std::size_t q = 0; q < quantities().size(); ++q) {
    Comparison c = four_levels();
    const ComparedQuantity& quantity = quantities()[q];
    if (quantity.concern == Concern::sensors) continue;
    set(c.entries[0].deviations, quantity, 1.01 * quantity.threshold / quantity.scale);
    set(c.entries[1].deviations, quantity, 0.99 * quantity.threshold / quantity.scale);
    const Recommendation r = recommend(c, {});
    EXPECT_EQ(r.level, "simplified_dynamics") << quantity.name;
    EXPECT_TRUE(says(r, "simplified_dynamics and up are needed for " + std::string(quantity.words))) << r.sentence;
    ASSERT_EQ(r.verdicts[0].reasons.size(), 1U);
    EXPECT_EQ(r.verdicts[0].reasons[0].find(quantity.words), 0U) << r.verdicts[0].reasons[0];
  }
}

TEST(Verdict, NotANumberIsNotWithinAThreshold) {
  Comparison c = four_levels();
  c.entries[0].deviations.pitch = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(recommend(c, {}).level, "simplified_dynamics");
}

// What inertial sensors show decides about software that reads them, not about the motion.
TEST(Verdict, SensorsHaveAVerdictOfTheirOwn) {
  for (const ComparedQuantity& quantity : quantities()) {
    if (quantity.concern != Concern::sensors) continue;
    Comparison c = four_levels();
    for (CompareEntry& e : c.entries) e.sensors.resize(1);
    set(c.entries[0].deviations, quantity, 1.01 * quantity.threshold / quantity.scale);
    set(c.entries[1].deviations, quantity, 0.99 * quantity.threshold / quantity.scale);
    const Recommendation r = recommend(c, {});
    EXPECT_EQ(r.level, "kinematic_walking");
    EXPECT_FALSE(r.of_sensors[0].adequate) << quantity.name;
    EXPECT_TRUE(r.of_sensors[1].adequate) << quantity.name;
    EXPECT_EQ(r.sensors.find("simplified_dynamics, full_dynamics are adequate; kinematic_walking is not: " +
                             std::string(quantity.words)),
              0U)
        << r.sensors;
  }
  EXPECT_EQ(recommend(four_levels(), {}).sensors, "") << "it has none";
  Comparison falls = four_levels();
  fall(falls.entries[1], 1);
  EXPECT_FALSE(recommend(falls, {}).of_sensors[1].adequate) << "they show that, too";
}

TEST(Verdict, TheWorstReasonComesFirst) {
  Comparison c = four_levels();
  c.entries[0].deviations.pitch = 0.1;  // [rad] 1.1 times its threshold
  c.entries[0].deviations.slip = 0.1;   // [m/s] five times
  EXPECT_EQ(recommend(c, {}).verdicts[0].reasons, (std::vector<std::string>{"foot slip 100.0 mm/s off, more than 20",
                                                                            "torso pitch 5.7 deg off, more than 5"}));
}

TEST(Verdict, UsersSetThresholds) {
  Comparison c = four_levels();
  c.entries[0].deviations.rate = 0.5;
  Thresholds strict;
  strict.set("rate=0.4");
  EXPECT_EQ(recommend(c, {}).level, "kinematic_walking");
  EXPECT_EQ(recommend(c, strict).level, "simplified_dynamics");
}

TEST(Verdict, ALevelThatFallsAloneIsNotAdequate) {
  Comparison c = four_levels();
  fall(c.entries[0], 1);
  const Recommendation r = recommend(c, {});
  EXPECT_EQ(r.level, "simplified_dynamics");
  EXPECT_TRUE(says(r, "kinematic_walking is not: falls once, the reference does not")) << r.sentence;
}

// A kick, then a fall: what comes before it must agree, too.
TEST(Verdict, IfTheReferenceFallsWhatComesBeforeCounts) {
  Comparison c = four_levels();
  for (CompareEntry& e : c.entries) fall(e, 3);
  c.entries[0].deviations.others_way = {1.7, "ball"};
  c.entries[1].deviations.pitch = 0.2;
  const Recommendation r = recommend(c, {});
  EXPECT_EQ(r.level, "full_dynamics");
  EXPECT_EQ(r.verdicts[0].reasons.front(), "way of what is around 170.0 % off, more than 20 (ball)");
  EXPECT_EQ(r.verdicts[1].reasons.front(), "torso pitch 11.5 deg off, more than 5");
}

TEST(Verdict, FallsOfTheReferenceAreSaid) {
  Comparison c = four_levels();
  for (const std::size_t i : {1, 2, 3}) fall(c.entries[i], 1 + 0.1 * static_cast<double>(i));
  const Recommendation r = recommend(c, {});
  EXPECT_EQ(r.level, "simplified_dynamics");
  EXPECT_TRUE(says(r, "articulated_dynamics falls at 1.30 s, compared is what comes before: ")) << r.sentence;
  EXPECT_TRUE(says(r, "falls within 0.20 s of it")) << r.sentence;
  EXPECT_TRUE(says(r, "kinematic_walking is not: does not fall, the reference does")) << r.sentence;
  EXPECT_FALSE(says(r, "torso pitch"));
}

TEST(Verdict, FallsMustBeAtTheSameTime) {
  Comparison c = four_levels();
  fall(c.entries[0], 1.3);
  fall(c.entries[1], 1.2);
  fall(c.entries[2], 1.0);
  fall(c.entries[3], 1.0);
  Recommendation r = recommend(c, {});
  EXPECT_EQ(r.level, "simplified_dynamics");
  EXPECT_EQ(r.verdicts[0].reasons.front(), "falls 0.30 s later than the reference");
  Thresholds patient;
  patient.set("fall_time=0.5");
  EXPECT_EQ(recommend(c, patient).level, "kinematic_walking");
}

TEST(Verdict, GettingUpCountsToo) {
  Comparison c = four_levels();
  for (CompareEntry& e : c.entries) e.measures.events = {{0, true}, {1, false}};
  c.entries[0].measures.events = {{0, false}};
  c.entries[1].measures.events = {{0, true}};
  const Recommendation r = recommend(c, {});
  EXPECT_EQ(r.level, "full_dynamics");
  EXPECT_EQ(r.verdicts[0].reasons.front(), "begins upright, the reference lying");
  EXPECT_EQ(r.verdicts[1].reasons.front(), "does not get up, the reference does");
}

TEST(Verdict, OnlyTheReferenceMayBeLeft) {
  Comparison c = four_levels();
  for (const std::size_t i : {0, 1, 2}) c.entries[i].deviations.pitch = 1;
  const Recommendation r = recommend(c, {});
  EXPECT_EQ(r.level, "articulated_dynamics");
  EXPECT_TRUE(says(r, "only articulated_dynamics is adequate")) << r.sentence;
  EXPECT_TRUE(says(r, "articulated_dynamics is needed for torso pitch")) << r.sentence;
}

TEST(Verdict, CostsThatHardlyDifferDoNotDecide) {
  Comparison c = four_levels();
  c.entries[0].refusal = "no soles";
  c.entries[1].cost = 4400;
  c.entries[2].cost = 4300;
  EXPECT_EQ(recommend(c, {}).level, "simplified_dynamics");
  c.entries[1].cost = 9000;
  EXPECT_EQ(recommend(c, {}).level, "full_dynamics") << "a level that is clearly dearer is no bargain";
}

TEST(Verdict, NothingIsClaimedIfTheReferenceFroze) {
  Comparison c = four_levels();
  c.entries[3].frozen = "too fast";
  const Recommendation r = recommend(c, {});
  EXPECT_EQ(r.level, "");
  EXPECT_TRUE(says(r, "nothing can be said")) << r.sentence;
  EXPECT_TRUE(says(r, "too fast"));
  for (const LevelVerdict& verdict : r.verdicts) {
    EXPECT_FALSE(verdict.adequate);
    ASSERT_FALSE(verdict.reasons.empty());
  }
  EXPECT_EQ(r.verdicts[0].reasons.front(), "the reference froze");
}

TEST(Verdict, WhatWasStoppedHasAReason) {
  Comparison c = four_levels();
  c.stopped = true;
  for (const LevelVerdict& verdict : recommend(c, {}).verdicts) {
    EXPECT_FALSE(verdict.adequate);
    EXPECT_EQ(verdict.reasons, std::vector<std::string>{"the comparison was stopped"});
  }
}

TEST(Verdict, OneLevelAloneIsComparedWithNothing) {
  Comparison c = four_levels();
  for (const std::size_t i : {0, 1, 2}) c.entries[i].refusal = "no soles";
  const Recommendation r = recommend(c, {});
  EXPECT_EQ(r.level, "");
  EXPECT_EQ(r.sentence, "nothing can be said: only articulated_dynamics ran");
}

TEST(Verdict, LevelsThatFrozeOrDidNotStartAreNotAdequate) {
  Comparison c = four_levels();
  c.entries[0].refusal = "no soles";
  c.entries[1].frozen = "too fast";
  const Recommendation r = recommend(c, {});
  EXPECT_EQ(r.level, "full_dynamics");
  EXPECT_EQ(r.verdicts[0].reasons.front(), "could not start: no soles");
  EXPECT_EQ(r.verdicts[1].reasons.front(), "froze: too fast");
}

TEST(Verdict, LawsAreNamedIfThereAreSeveral) {
  Comparison c = four_levels();
  CompareEntry paper = entry("articulated_dynamics", 1000);
  paper.contact = "paper";
  c.entries.push_back(paper);
  for (const std::size_t i : {0, 1, 2}) c.entries[i].deviations.pitch = 1;
  const Recommendation r = recommend(c, {});
  EXPECT_EQ(r.contact, "paper");
  EXPECT_TRUE(says(r, "articulated_dynamics with paper is adequate")) << r.sentence;
}

std::string refusal(const std::string& text) {
  Thresholds thresholds;
  try {
    thresholds.set(text);
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(Thresholds, SayWhatIsWrong) {
  EXPECT_EQ(refusal("pich=3"), "--threshold 'pich=3': unknown threshold 'pich'; did you mean 'pitch'?");
  for (const char* text : {"pitch=", "pitch=x", "pitch=-1", "pitch=nan", "pitch=3x"}) {
    EXPECT_NE(refusal(text).find("must be a number from 0"), std::string::npos) << text;
  }
  EXPECT_NE(refusal("pitch").find("NAME=VALUE"), std::string::npos);
}

}  // namespace
}  // namespace murosimf::studies
