// The recommendation that ends a comparison.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/studies/compare_verdict.h"

namespace murosimf::studies {
namespace {

class Sentence {
 public:
  Sentence(const Comparison& comparison, const Thresholds& thresholds, const std::vector<LevelVerdict>& verdicts)
      : c_(comparison), thresholds_(thresholds), verdicts_(verdicts), reference_(c_.entries[c_.reference]) {
    MUROSIMF_ASSERT(verdicts.size() == c_.entries.size());
  }

  /// Cheap levels come first: a later one must be clearly cheaper to take their place.
  [[nodiscard]] std::size_t best() const {
    std::size_t best = c_.entries.size();
    for (std::size_t i = 0; i < c_.entries.size(); ++i) {
      if (!verdicts_[i].adequate) continue;
      if (best == c_.entries.size() || c_.entries[i].cost < clearly_cheaper * c_.entries[best].cost) best = i;
    }
    return best;
  }

  [[nodiscard]] std::string verdict(std::size_t best) const {
    MUROSIMF_ASSERT(best < c_.entries.size());
    const CompareEntry& entry = c_.entries[best];
    if (best != c_.reference) {
      return fmt::format("{} is adequate: {}{} {}", label(c_, entry), closeness(entry), cost_of(entry),
                         label(c_, reference_));
    }
    if (others_are_adequate()) return fmt::format("{} is adequate and costs the least", label(c_, entry));
    return fmt::format("only {} is adequate", label(c_, entry));
  }

  [[nodiscard]] std::string text(std::size_t best) const {
    std::string text = preface() + verdict(best) + failures();
    for (const std::string& need : needs()) text += "; " + need;
    return text;
  }

  /// "full_dynamics and up are needed for torso angular rate, joint torques": what simpler levels do not show.
  [[nodiscard]] std::vector<std::string> needs() const {
    const auto levels = ladder();
    MUROSIMF_ASSERT(!levels.empty());
    std::vector<std::vector<std::string>> needed(levels.size());
    const auto look = [&](std::string_view words, const auto& fails) {
      for (std::size_t i = levels.size() - 1; i-- > 0;) {
        if (!fails(*levels[i])) continue;
        needed[i + 1].emplace_back(words);  // the most detailed level that fails: the next one is needed
        return;
      }
    };
    for (const NamedOutcome& outcome : c_.outcomes) {
      look(outcome.name(), [&](const auto& e) { return !off(outcome, e).reason.empty(); });
    }
    for (std::size_t q = 0; c_.outcomes.empty() && q < quantities().size(); ++q) {
      const ComparedQuantity& quantity = quantities()[q];
      look(quantity.words, [&](const auto& e) { return quantity.of(e.deviations) > thresholds_.values[q]; });
    }
    if (!reference_.measures.peak_joint.empty()) {
      look("joint torques", [](const CompareEntry& e) { return e.measures.peak_joint.empty(); });
    }
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (needed[i].empty()) continue;
      sentences.push_back(fmt::format("{} {} needed for {}", levels[i]->level,
                                      i + 1 < levels.size() ? "and up are" : "is", fmt::join(needed[i], ", ")));
    }
    return sentences;
  }

 private:
  [[nodiscard]] bool fell() const { return reference_.measures.falls > 0; }

  [[nodiscard]] std::string preface() const {
    if (!fell() || !c_.outcomes.empty()) return {};
    return fmt::format("{} falls at {:.2f} s, compared is what comes before: ", label(c_, reference_),
                       first_fall(reference_.measures.events));
  }

  [[nodiscard]] bool others_are_adequate() const {
    return std::count_if(verdicts_.begin(), verdicts_.end(), [](const LevelVerdict& v) { return v.adequate; }) > 1;
  }

  [[nodiscard]] OutcomeOff off(const NamedOutcome& outcome, const CompareEntry& entry) const {
    return outcome_off(outcome, entry, reference_, thresholds_);
  }

  /// " at 0.30 of the cost of"; it is not known if nothing was timed.
  [[nodiscard]] std::string cost_of(const CompareEntry& entry) const {
    if (!(entry.cost > 0 && reference_.cost > 0)) return " compared with";
    return fmt::format(" at {:.2f} of the cost of", entry.cost / reference_.cost);
  }

  /// How close the level is, in the terms of the experiment.
  [[nodiscard]] std::string closeness(const CompareEntry& entry) const {
    if (!c_.outcomes.empty()) {
      std::vector<std::string> all;
      for (const NamedOutcome& outcome : c_.outcomes) all.push_back(off(outcome, entry).closeness);
      return fmt::format("{},", fmt::join(all, ", "));
    }
    if (fell()) {
      // The same falls, or the level would not be adequate.
      MUROSIMF_ASSERT(entry.measures.events.size() == reference_.measures.events.size());
      double apart = 0;
      for (std::size_t i = 0; i < entry.measures.events.size(); ++i) {
        apart = std::max(apart, std::abs(entry.measures.events[i].time - reference_.measures.events[i].time));
      }
      return apart < 0.01 ? "falls at the same time," : fmt::format("falls within {:.2f} s of it,", apart);
    }
    const std::string center = fmt::format("center of mass within {:.0f} mm,", 1e3 * entry.deviations.center_max);
    if (reference_.measures.path_length < shortest_way) return center;
    return fmt::format("within {:.0f} % of the path, {}", 100 * entry.deviations.path_length, center);
  }

  /// The first reason is the worst one.
  [[nodiscard]] std::string failures() const {
    std::string text;
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
      if (!c_.entries[i].ran() || verdicts_[i].adequate) continue;
      MUROSIMF_ASSERT(!verdicts_[i].reasons.empty());
      text += fmt::format("; {} is not: {}", label(c_, c_.entries[i]), verdicts_[i].reasons.front());
    }
    return text;
  }

  /// Levels that ran under the reference's law, or have none, from simple to detailed.
  [[nodiscard]] std::vector<const CompareEntry*> ladder() const {
    std::vector<const CompareEntry*> result;
    for (const CompareEntry& e : c_.entries) {
      if (e.ran() && (e.contact.empty() || e.contact == reference_.contact)) result.push_back(&e);
    }
    return result;
  }

  const Comparison& c_;
  const Thresholds& thresholds_;
  const std::vector<LevelVerdict>& verdicts_;
  const CompareEntry& reference_;
};

/// For which levels inertial sensors are right: software that reads them may need more than the motion does.
std::string sensors_sentence(const Comparison& c, const std::vector<LevelVerdict>& verdicts) {
  const CompareEntry& reference = c.entries[c.reference];
  if (reference.sensors.empty() || !reference.frozen.empty()) return {};
  MUROSIMF_ASSERT(verdicts.size() == c.entries.size());
  std::vector<std::string> right, wrong;
  for (std::size_t i = 0; i < c.entries.size(); ++i) {
    if (!c.entries[i].ran() || i == c.reference) continue;
    if (verdicts[i].adequate) right.push_back(label(c, c.entries[i]));
    if (!verdicts[i].adequate) {
      wrong.push_back(fmt::format("{} is not: {}", label(c, c.entries[i]), verdicts[i].reasons.front()));
    }
  }
  std::string text = right.empty() ? fmt::format("only {} is", label(c, reference))
                                   : fmt::format("{} {}", fmt::join(right, ", "), right.size() == 1 ? "is" : "are");
  text += " adequate";
  return wrong.empty() ? text : fmt::format("{}; {}", text, fmt::join(wrong, "; "));
}

/// Why there is nothing to recommend; empty: there is.
std::string nothing_to_say(const Comparison& c) {
  const CompareEntry& reference = c.entries[c.reference];
  if (c.stopped) return "nothing can be said: the comparison was stopped";
  if (!reference.frozen.empty()) {
    return fmt::format("nothing can be said: {}, with which the others are compared, froze: {}", label(c, reference),
                       reference.frozen);
  }
  const auto ran = std::ranges::count_if(c.entries, [](const CompareEntry& e) { return e.ran(); });
  return ran < 2 ? fmt::format("nothing can be said: only {} ran", label(c, reference)) : std::string{};
}

/// A comparison that was stopped shows no level to be adequate.
void withdraw(LevelVerdict& verdict) {
  if (verdict.adequate) verdict.reasons.emplace_back("the comparison was stopped");
  verdict.adequate = false;
}

}  // namespace

Recommendation recommend(const Comparison& comparison, const Thresholds& thresholds) {
  Recommendation result;
  const auto& entries = comparison.entries;
  MUROSIMF_ASSERT(comparison.reference < entries.size());
  const CompareEntry& reference = entries[comparison.reference];
  for (const CompareEntry& entry : entries) {
    result.verdicts.push_back(judge(entry, reference, thresholds, comparison.outcomes));
    result.of_sensors.push_back(judge_sensors(entry, reference, thresholds));
    if (!comparison.stopped) continue;
    withdraw(result.verdicts.back());
    withdraw(result.of_sensors.back());
  }
  result.verdict = result.sentence = nothing_to_say(comparison);
  if (!result.sentence.empty()) return result;
  const Sentence sentence(comparison, thresholds, result.verdicts);
  const std::size_t best = sentence.best();
  result.level = entries[best].level;
  result.contact = entries[best].contact;
  result.verdict = sentence.verdict(best);
  result.sentence = sentence.text(best);
  result.needs = sentence.needs();
  result.sensors = sensors_sentence(comparison, result.of_sensors);
  return result;
}

}  // namespace murosimf::studies
