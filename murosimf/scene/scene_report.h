/// scene_report.h - what a scene has shown so far.
#pragma once

#include <string>

#include "murosimf/runtime/clock.h"
#include "murosimf/scene/run_report.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {

/// `wall`: the wall time that it took.
/// "late: 12 of 1000 steps ended behind schedule, the worst 3.1 ms"
[[nodiscard]] std::string to_text(const Lateness& lateness);

[[nodiscard]] RunReport make_report(const Scene& scene, Duration wall = {}, const Lateness& lateness = {});

/// A line about events and pushes whose time has not come; empty if all have, and before the first step.
[[nodiscard]] std::string events_to_come(const Scene& scene);

}  // namespace murosimf::scene
