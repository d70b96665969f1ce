/// contact_logs.h - fits numbers of a pair of materials to recorded rolls, slides and drops, and reports them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/identification/contact_fit.h"

namespace murosimf::identification {

/// Files of comma-separated values. Columns: time, and x, y or z in m, each a name alone or the end of one ("ball.ball.position.x [m]").
struct ContactLogs {
  std::vector<std::string> rolls, slides, drops;
};

struct ContactFitOptions {
  std::string body, ground;  ///< materials
  double gravity = 9.81;     ///< [m/s^2]
  double inertia = 0.4;      ///< [1] J / (m r^2) of the ball
  double drag = 0;           ///< [1/m] k of the air
};

/// One number of the pair.
struct FittedNumber {
  std::string key;                                ///< of [[materials]]
  identification::Estimate estimate;              ///< of all runs
  std::vector<std::string> runs;                  ///< files
  std::vector<identification::Estimate> of_runs;  ///< in their order
  std::optional<identification::Lean> lean;       ///< of slides and rolls in directions all around
};

struct ContactFit {
  std::string body, ground;
  std::vector<FittedNumber> numbers;
};

/// Throws SetupError with the file's name: what read_csv and the fits refuse, a missing column, a unit that is no length.
[[nodiscard]] ContactFit fit_contact_logs(const ContactLogs& logs, const ContactFitOptions& options);

/// A section [[materials]] with all numbers of the pair: numbers that were not fitted are the table's.
[[nodiscard]] std::string to_toml(const ContactFit& fit);
[[nodiscard]] std::string to_text(const ContactFit& fit);
/// One JSON object: pair [2], numbers [{key, value, error, residual_m, runs [{file, value, error, residual_m}],
/// lean {mean, anisotropy, direction [2]} (if any)}].
[[nodiscard]] std::string to_json(const ContactFit& fit);

}  // namespace murosimf::identification
