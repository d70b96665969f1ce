// The recommendation that ends a comparison.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/compare/compare_verdict.h"

namespace murosimf::compare {
namespace {

constexpr double clearly_cheaper = 0.8;  // [1] repeated timings of one level differ by a tenth

class Sentence {
 public:
  Sentence(const Comparison& comparison, const Thresholds& thresholds, const std::vector<LevelVerdict>& verdicts)
      : c_(comparison), thresholds_(thresholds), verdicts_(verdicts), reference_(c_.entries[c_.reference]) {}

  [[nodiscard]] std::size_t best() const {
    std::size_t best = c_.entries.size();
    for (std::size_t i = 0; i < c_.entries.size(); ++i) {
      if (!verdicts_[i].adequate) continue;
      if (best == c_.entries.size() || c_.entries[i].cost < clearly_cheaper * c_.entries[best].cost) best = i;
    }
    return best;
  }

  [[nodiscard]] std::string text(std::size_t best) const {
    std::string text = preface();
    const CompareEntry& entry = c_.entries[best];
    if (best != c_.reference) {
      text += fmt::format("{} is adequate: {} at {:.2f} of the cost of {}", label(c_, entry), closeness(entry),
                          entry.cost / reference_.cost, label(c_, reference_));
    } else if (others_are_adequate()) {
      text += fmt::format("{} is adequate and costs the least", label(c_, entry));
    } else {
      text += fmt::format("only {} is adequate", label(c_, entry));
    }
    return text + failures() + needs();
  }

 private:
  [[nodiscard]] bool fell() const { return reference_.measures.falls > 0; }

  [[nodiscard]] std::string preface() const {
    if (!fell()) return {};
    return fmt::format("{} falls at {:.2f} s, compared is what comes before: ", label(c_, reference_),
                       first_fall(reference_.measures.events));
  }

  [[nodiscard]] bool others_are_adequate() const {
    return std::count_if(verdicts_.begin(), verdicts_.end(), [](const LevelVerdict& v) { return v.adequate; }) > 1;
  }

  /// How close the level is, in the terms of the experiment.
  [[nodiscard]] std::string closeness(const CompareEntry& entry) const {
    if (fell()) {
      double apart = 0;
      for (std::size_t i = 0; i < entry.measures.events.size(); ++i) {
        apart = std::max(apart, std::abs(entry.measures.events[i].time - reference_.measures.events[i].time));
      }
      return apart < 0.01 ? "falls at the same time," : fmt::format("falls within {:.2f} s of it,", apart);
    }
    const std::string center = fmt::format("center of mass within {:.0f} mm", 1e3 * entry.deviations.center_max);
    if (reference_.measures.path_length < shortest_way) return center;
    return fmt::format("within {:.0f} % of the path, {},", 100 * entry.deviations.path_length, center);
  }

  [[nodiscard]] std::string failures() const {
    std::string text;
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
      if (!c_.entries[i].ran() || verdicts_[i].adequate) continue;
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

  /// "; full_dynamics and up are needed for torso angular rate, joint torques": what simpler levels do not show.
  [[nodiscard]] std::string needs() const {
    const auto levels = ladder();
    std::vector<std::vector<std::string>> needed(levels.size());
    const auto look = [&](std::string_view words, const auto& fails) {
      for (std::size_t i = levels.size() - 1; i-- > 0;) {
        if (!fails(*levels[i])) continue;
        needed[i + 1].emplace_back(words);  // the most detailed level that fails: the next one is needed
        return;
      }
    };
    for (std::size_t q = 0; q < quantities().size(); ++q) {
      const ComparedQuantity& quantity = quantities()[q];
      look(quantity.words, [&](const auto& e) { return quantity.of(e.deviations) > thresholds_.values[q]; });
    }
    if (!reference_.measures.peak_joint.empty()) {
      look("joint torques", [](const CompareEntry& e) { return e.measures.peak_joint.empty(); });
    }
    std::string text;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (needed[i].empty()) continue;
      text += fmt::format("; {} {} needed for {}", levels[i]->level, i + 1 < levels.size() ? "and up are" : "is",
                          fmt::join(needed[i], ", "));
    }
    return text;
  }

  const Comparison& c_;
  const Thresholds& thresholds_;
  const std::vector<LevelVerdict>& verdicts_;
  const CompareEntry& reference_;
};

}  // namespace

Recommendation recommend(const Comparison& comparison, const Thresholds& thresholds) {
  Recommendation result;
  const auto& entries = comparison.entries;
  const CompareEntry& reference = entries[comparison.reference];
  for (const CompareEntry& entry : entries) result.verdicts.push_back(judge(entry, reference, thresholds));
  const auto ran = std::count_if(entries.begin(), entries.end(), [](const CompareEntry& e) { return e.ran(); });
  if (comparison.stopped) {
    result.sentence = "nothing can be said: the comparison was stopped";
    for (LevelVerdict& verdict : result.verdicts) {
      if (verdict.adequate) verdict.reasons.emplace_back("the comparison was stopped");
      verdict.adequate = false;
    }
  } else if (!reference.frozen.empty()) {
    result.sentence = fmt::format("nothing can be said: {}, with which the others are compared, froze: {}",
                                  label(comparison, reference), reference.frozen);
  } else if (ran < 2) {
    result.sentence = fmt::format("nothing can be said: only {} ran", label(comparison, reference));
  } else {
    const Sentence sentence(comparison, thresholds, result.verdicts);
    const std::size_t best = sentence.best();
    result.level = entries[best].level;
    result.contact = entries[best].contact;
    result.sentence = sentence.text(best);
  }
  return result;
}

}  // namespace murosimf::compare
