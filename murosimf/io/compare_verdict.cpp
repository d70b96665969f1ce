#include "murosimf/io/compare_verdict.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

constexpr std::array all{
    Quantity{"path_length", "path length", "%", 100, 20, &Deviations::path_length},
    Quantity{"path", "path", "m", 1, 0.12, &Deviations::path},
    Quantity{"center_mean", "center of mass on average", "m", 1, 0.10, &Deviations::center_mean},
    Quantity{"center_max", "center of mass", "m", 1, 0.20, &Deviations::center_max},
    Quantity{"pitch", "torso pitch", "deg", 180 / pi, 5, &Deviations::pitch},
    Quantity{"rate", "torso angular rate", "rad/s", 1, 0.7, &Deviations::rate},
    Quantity{"slip", "foot slip", "mm/s", 1000, 20, &Deviations::slip},
    Quantity{"clearance", "foot clearance", "mm", 1000, 20, &Deviations::clearance},
};

std::string label(const Comparison& comparison, const CompareEntry& entry) {
  const auto other_law = [&](const CompareEntry& e) { return e.level == entry.level && e.contact != entry.contact; };
  const bool several = std::any_of(comparison.entries.begin(), comparison.entries.end(), other_law);
  return several ? fmt::format("{} with {}", entry.level, entry.contact) : entry.level;
}

std::string times(int count) { return count == 1 ? "once" : fmt::format("{} times", count); }

/// How the falls of a run differ from the reference's; empty: they do not.
std::string event_difference(const Measures& mine, const Measures& reference, double tolerance) {
  if (mine.events.empty() || reference.events.empty()) return "nothing was recorded";
  if (mine.events[0].down != reference.events[0].down) {
    return reference.events[0].down ? "begins upright, not lying" : "begins lying, not upright";
  }
  if (mine.falls != reference.falls) {
    const std::string should =
        reference.falls == 0 ? "the reference does not" : "the reference " + times(reference.falls);
    return mine.falls == 0 ? "does not fall, the reference does"
                           : fmt::format("falls {}, {}", times(mine.falls), should);
  }
  if (mine.events.size() != reference.events.size()) {
    return mine.events.back().down ? "does not get up, the reference does" : "gets up, the reference does not";
  }
  for (std::size_t i = 1; i < mine.events.size(); ++i) {
    const double later = mine.events[i].time - reference.events[i].time;
    if (std::abs(later) <= tolerance) continue;
    return fmt::format("{} {:.2f} s {}", mine.events[i].down ? "falls" : "gets up", std::abs(later),
                       later > 0 ? "later" : "earlier");
  }
  return {};
}

class Judge {
 public:
  Judge(const Comparison& comparison, const Thresholds& thresholds)
      : comparison_(comparison), thresholds_(thresholds), reference_(comparison.entries[comparison.reference]) {}

  [[nodiscard]] bool reference_fell() const { return reference_.measures.falls > 0; }

  [[nodiscard]] bool exceeds(const CompareEntry& entry, std::size_t q) const {
    return !(all[q].scale * (entry.deviations.*all[q].deviation) <= thresholds_.values[q]);
  }

  [[nodiscard]] LevelVerdict verdict(const CompareEntry& entry) const {
    LevelVerdict verdict;
    if (!entry.ran()) {
      verdict.reasons.push_back("could not start: " + entry.refusal);
      return verdict;
    }
    if (!entry.frozen.empty()) verdict.reasons.push_back("froze: " + entry.frozen);
    auto difference = event_difference(entry.measures, reference_.measures, thresholds_.fall_time);
    if (!difference.empty()) verdict.reasons.push_back(std::move(difference));
    for (std::size_t q = 0; !reference_fell() && q < all.size(); ++q) {
      if (!exceeds(entry, q)) continue;
      const double value = all[q].scale * (entry.deviations.*all[q].deviation);
      verdict.reasons.push_back(
          fmt::format("{} {:.3g} {} > {:.3g}", all[q].words, value, all[q].unit, thresholds_.values[q]));
    }
    verdict.adequate = verdict.reasons.empty();
    return verdict;
  }

 private:
  const Comparison& comparison_;
  const Thresholds& thresholds_;
  const CompareEntry& reference_;
};

/// How close the level is, in the terms of the experiment: by its path if it went anywhere.
std::string closeness(const CompareEntry& entry, const CompareEntry& reference) {
  const Deviations& d = entry.deviations;
  if (reference.measures.path_length < 0.5)
    return fmt::format("its center of mass within {:.0f} mm", 1e3 * d.center_max);
  return fmt::format("within {:.1f} % of the path's length, its center of mass within {:.0f} mm", 100 * d.path_length,
                     1e3 * d.center_max);
}

/// "full_dynamics and up are needed for torso angular rate, joint torques": what simpler levels do not reproduce.
std::string needs(const Comparison& comparison, const Judge& judge) {
  std::string text;
  const auto& entries = comparison.entries;
  for (std::size_t first = 1; first < entries.size(); ++first) {
    if (!entries[first].ran() || entries[first].level == entries[first - 1].level) continue;
    const auto begins_here = [&](const auto& fails) {
      bool simpler_failed = false, any_simpler = false;
      for (std::size_t i = 0; i < entries.size(); ++i) {
        if (!entries[i].ran()) continue;
        if (i >= first && fails(entries[i])) return false;
        if (i < first) {
          any_simpler = true;
          simpler_failed = fails(entries[i]);  // the nearest simpler one decides
        }
      }
      return any_simpler && simpler_failed;
    };
    std::vector<std::string_view> words;
    for (std::size_t q = 0; !judge.reference_fell() && q < all.size(); ++q) {
      if (begins_here([&](const CompareEntry& e) { return judge.exceeds(e, q); })) words.push_back(all[q].words);
    }
    if (begins_here([](const CompareEntry& e) { return e.measures.peak_joint.empty(); }))
      words.emplace_back("joint torques");
    if (words.empty()) continue;
    const bool last = entries[first].level == entries[comparison.reference].level;
    text +=
        fmt::format("; {} {} needed for {}", entries[first].level, last ? "is" : "and up are", fmt::join(words, ", "));
  }
  return text;
}

std::string what_failed(const Comparison& comparison, const std::vector<LevelVerdict>& verdicts) {
  std::string text;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const CompareEntry& entry = comparison.entries[i];
    if (!entry.ran() || verdicts[i].adequate) continue;
    text += fmt::format("; {} is not: {}", label(comparison, entry), verdicts[i].reasons.front());
  }
  return text;
}

}  // namespace

std::span<const Quantity> quantities() { return all; }

Thresholds::Thresholds() {
  for (const Quantity& quantity : all) values.push_back(quantity.threshold);
}

void Thresholds::set(const std::string& text) {
  const std::string where = fmt::format("--threshold '{}'", text);
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw SetupError(where + ": write NAME=VALUE, for example 'pitch=5'");
  const std::string name = text.substr(0, equals);
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [parsed, error] = std::from_chars(text.data() + equals + 1, end, value);
  if (error != std::errc{} || parsed != end || !(value >= 0)) {
    throw SetupError(where + ": the value must be a number from 0");
  }
  std::vector<std::string_view> names{"fall_time"};
  if (name == "fall_time") {
    fall_time = value;
    return;
  }
  for (std::size_t q = 0; q < all.size(); ++q) {
    names.push_back(all[q].name);
    if (all[q].name != name) continue;
    values[q] = value;
    return;
  }
  throw SetupError(fmt::format("{}: {}", where, unknown_name("threshold", name, names)));
}

Recommendation recommend(const Comparison& comparison, const Thresholds& thresholds) {
  Recommendation result;
  const Judge judge(comparison, thresholds);
  const auto& entries = comparison.entries;
  const CompareEntry& reference = entries[comparison.reference];
  for (const CompareEntry& entry : entries) result.verdicts.push_back(judge.verdict(entry));
  if (!reference.frozen.empty()) {
    result.sentence =
        fmt::format("nothing can be said: the reference, {}, froze ({})", reference.level, reference.frozen);
    for (LevelVerdict& verdict : result.verdicts) verdict.adequate = false;
    return result;
  }
  const auto ran = std::count_if(entries.begin(), entries.end(), [](const CompareEntry& e) { return e.ran(); });
  if (ran < 2) {
    result.sentence =
        fmt::format("nothing can be said: only {} ran, there is nothing to compare it with", reference.level);
    return result;
  }
  std::size_t best = comparison.reference;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (result.verdicts[i].adequate && entries[i].cost < entries[best].cost) best = i;
  }
  result.level = entries[best].level;
  result.contact = entries[best].contact;
  const std::string failed = what_failed(comparison, result.verdicts);
  if (judge.reference_fell()) {
    result.sentence = fmt::format("{} fell {}, so only falls are compared: ", label(comparison, reference),
                                  times(reference.measures.falls));
  }
  if (best == comparison.reference) {
    result.sentence += fmt::format("only {} is adequate", label(comparison, reference));
  } else {
    result.sentence += fmt::format("{} is adequate: {}at {:.2f} of the cost of {}", label(comparison, entries[best]),
                                   judge.reference_fell() ? "" : closeness(entries[best], reference) + ", ",
                                   entries[best].cost / reference.cost, label(comparison, reference));
  }
  result.sentence += failed + needs(comparison, judge);
  return result;
}

}  // namespace murosimf::io
