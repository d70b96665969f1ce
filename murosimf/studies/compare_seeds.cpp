#include "murosimf/studies/compare_seeds.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::studies {
namespace {

constexpr double half_of_seeds = 0.5;

/// Exact: a seed that has no effect gives the same bits.
bool same_motion(const CompareEntry& a, const CompareEntry& b) {
  const auto equal_place = [](const auto& p, const auto& q) { return norm(p - q) == 0; };
  const auto robot = [&](const dynamics::MotionSample& s, const dynamics::MotionSample& t) {
    return equal_place(s.base, t.base) && equal_place(s.center, t.center);
  };
  const auto other = [&](const OtherRecord& s, const OtherRecord& t) {
    return std::ranges::equal(s.samples, t.samples, [&](const OtherSample& u, const OtherSample& v) {
      return equal_place(u.place, v.place);
    });
  };
  return std::ranges::equal(a.record.samples, b.record.samples, robot) &&
         std::ranges::equal(a.outcome.others, b.outcome.others, other);
}

/// Apart from servos that are made to vary.
bool same_motion(const Comparison& a, const Comparison& b) {
  MUROSIMF_ASSERT(a.entries.size() == b.entries.size());
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    const bool varied = a.as_modeled && a.entries[i].traits.servos;
    if (!varied && !same_motion(a.entries[i], b.entries[i])) return false;
  }
  return !a.as_modeled || !b.as_modeled || same_motion(*a.as_modeled, *b.as_modeled);
}

void count(const LevelVerdict& verdict, SeedsVerdict& counted) {
  MUROSIMF_ASSERT(verdict.adequate || !verdict.reasons.empty());
  counted.adequate.push_back(verdict.adequate);
  counted.reasons.push_back(verdict.adequate ? "" : verdict.reasons.front());
}

void add_seed(const Comparison& c, const Recommendation& r, const Thresholds& thresholds, SeedsComparison& result) {
  MUROSIMF_ASSERT(c.entries.size() == result.levels.size() && r.verdicts.size() == result.levels.size());
  for (std::size_t i = 0; i < c.entries.size(); ++i) count(r.verdicts[i], result.levels[i]);
  if (!c.as_modeled) return;
  if (result.yardstick.empty()) {
    result.yardstick.push_back(
        {fmt::format("{} with the model's servos", label(c, c.entries[c.reference])), {}, {}, {}});
  }
  count(judge(*c.as_modeled, c.entries[c.reference], thresholds, c.outcomes), result.yardstick.front());
}

void set_share(bool each_counts, SeedsVerdict& verdict) {
  std::vector<double> cases;
  for (const bool adequate : verdict.adequate) cases.push_back(adequate ? 1 : 0);
  MUROSIMF_ASSERT(!cases.empty());
  // Seeds without effect repeat the same run: they are one case.
  if (!each_counts) cases.resize(1);
  verdict.share = studies::mean_interval(cases);
}

std::string cost_of(const Comparison& c, const CompareEntry& entry) {
  const double reference = c.entries[c.reference].cost;
  if (!(entry.cost > 0 && reference > 0)) return {};
  return fmt::format(", at {:.2f} of the cost of {}", entry.cost / reference, label(c, c.entries[c.reference]));
}

/// The cheapest level that is adequate, as for one seed.
std::string verdict_of(const SeedsComparison& s) {
  const auto& entries = s.first.entries;
  std::size_t best = s.first.reference;
  for (std::size_t i = entries.size(); i-- > 0;) {
    if (i == s.first.reference || s.levels[i].judgement != Judgement::adequate) continue;
    if (!(entries[best].cost < clearly_cheaper * entries[i].cost)) best = i;
  }
  if (best != s.first.reference) return s.levels[best].name + " is adequate" + cost_of(s.first, entries[best]);
  const bool undecided = std::ranges::count(s.levels, Judgement::undecided, &SeedsVerdict::judgement) > 0;
  return fmt::format("only {} is adequate{}", s.levels[best].name,
                     undecided ? " for sure; more seeds would tell of others" : "");
}

void conclude(SeedsComparison& result) {
  const bool each_counts = result.seeds_differ || result.servo_tolerance > 0;
  const studies::MeanInterval* yardstick = nullptr;
  for (SeedsVerdict& verdict : result.yardstick) {
    set_share(each_counts, verdict);
    yardstick = &verdict.share;
  }
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    SeedsVerdict& level = result.levels[i];
    set_share(each_counts, level);
    level.judgement = i == result.first.reference ? Judgement::adequate : judgement(level.share, yardstick);
  }
  const bool nothing = result.of_first.level.empty();
  result.verdict = nothing ? result.of_first.verdict : verdict_of(result);
}

/// Seeds of scenes are up to the largest std::int64_t.
void check_last_seed(std::uint64_t first, int seeds) {
  MUROSIMF_ASSERT(seeds >= 1);
  constexpr auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (first > largest - static_cast<std::uint64_t>(seeds - 1)) {
    throw SetupError(fmt::format("--seeds {}: the last one would be above {}, the largest seed", seeds, largest));
  }
}

}  // namespace

std::string_view to_string(Judgement judgement) {
  constexpr std::string_view words[] = {"adequate", "not adequate", "undecided"};
  MUROSIMF_ASSERT(static_cast<std::size_t>(judgement) < std::size(words));
  return words[static_cast<std::size_t>(judgement)];
}

/// A single case has no interval: its verdict is that of the case.
Judgement judgement(const studies::MeanInterval& share, const studies::MeanInterval* yardstick) {
  if (share.count == 1) return share.mean == 1 ? Judgement::adequate : Judgement::not_adequate;
  const bool as_good = yardstick && share.mean > 0 && share.mean >= yardstick->mean;
  if (share.low > half_of_seeds || as_good) return Judgement::adequate;
  const double bar = yardstick ? std::min(half_of_seeds, yardstick->low) : half_of_seeds;
  return share.high < bar ? Judgement::not_adequate : Judgement::undecided;
}

SeedsComparison compare_seeds(const CompareOptions& options, int seeds, const Thresholds& thresholds) {
  SeedsComparison result;
  result.servo_tolerance = options.servo_tolerance;
  for (int i = 0; i < seeds; ++i) {
    CompareOptions one = options;
    if (i > 0) one.repeat = 0;  // costs do not depend on the seed
    if (i > 0) one.seed = result.seed + static_cast<std::uint64_t>(i);
    if (options.progress) {
      one.progress = [&](double share, const std::string& what) {
        options.progress((i + share) / seeds, fmt::format("seed {} of {}: {}", i + 1, seeds, what));
      };
    }
    Comparison c = compare(one);
    const Recommendation r = recommend(c, thresholds);
    result.stopped = c.stopped;
    if (i == 0) {
      result.seed = c.seed;
      check_last_seed(result.seed, seeds);
      for (const CompareEntry& entry : c.entries) result.levels.push_back({label(c, entry), {}, {}, {}});
    }
    // A seed that was stopped says nothing; the first one is needed even so, for its entries.
    if (i == 0 || !c.stopped) add_seed(c, r, thresholds, result);
    if (i > 0 && !c.stopped) result.seeds_differ = result.seeds_differ || !same_motion(result.first, c);
    if (i == 0) {
      result.first = std::move(c);
      result.of_first = r;
    }
    if (result.stopped) break;
  }
  conclude(result);
  return result;
}

}  // namespace murosimf::studies
