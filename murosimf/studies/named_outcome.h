/// named_outcome.h - what a user names as the outcome of an experiment: that alone decides then whether a level is adequate.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace murosimf::studies {

struct CompareEntry;
struct Thresholds;

/// An entity of which outcomes can be named.
struct OutcomeOwner {
  std::string name;
  bool is_robot = false;  ///< whose level changes
  bool can_fall = false;
};

struct NamedOutcome {
  std::string owner, quantity;  ///< "ball", "end"
  bool of_robot = false;
  std::optional<double> tolerance{};  ///< in the quantity's unit; nothing: as the thresholds have it
  [[nodiscard]] std::string name() const { return owner + "." + quantity; }
};

/// "OWNER.QUANTITY" or "OWNER.QUANTITY=TOLERANCE". Throws SetupError, with all known names for an unknown one.
[[nodiscard]] NamedOutcome named_outcome(const std::string& text, const std::vector<OutcomeOwner>& owners);

/// How far an outcome is off the reference's, over the whole run.
struct OutcomeOff {
  std::string reason{};     ///< "ball.end 0.42 m off, more than 0.30 m"; empty: by no more than the tolerance
  std::string closeness{};  ///< "ball.end within 0.12 m"
  double value = 0;         ///< in the quantity's unit; NaN: it has none (falls, touches)
};

[[nodiscard]] OutcomeOff outcome_off(const NamedOutcome& outcome, const CompareEntry& entry,
                                     const CompareEntry& reference, const Thresholds& thresholds);

}  // namespace murosimf::studies
