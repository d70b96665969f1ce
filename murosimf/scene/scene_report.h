/// scene_report.h - the results of a scene so far.
#pragma once

#include <string>

#include "murosimf/runtime/clock.h"
#include "murosimf/scene/run_report.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {

/// `wall`: the wall time spent.
/// "late: 12 of 1000 steps ended behind schedule, the worst 3.1 ms"
[[nodiscard]] std::string to_text(const Lateness& lateness);

[[nodiscard]] RunReport make_report(const Scene& scene, Duration wall = {}, const Lateness& lateness = {});

/// A line about events and pushes that are still to come; empty if there are none, and before the first step.
[[nodiscard]] std::string events_to_come(const Scene& scene);

}  // namespace murosimf::scene
