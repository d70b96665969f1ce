// Plug-ins with one error each, chosen by a definition of the build.
#include <cfenv>
#include <cstdlib>
#include <stdexcept>

#include "murosimf/plugin/controller.h"

#ifdef MISTAKE_other_version
extern "C" const char* murosimf_plugin_version() { return "plug-in interface 0 of murosimf 0.0.9, C++ ABI 1"; }
#elif !defined(MISTAKE_no_version)
extern "C" const char* murosimf_plugin_version() { return murosimf::catalog::plugin_version; }
#endif

#ifdef MISTAKE_unknown_symbol
namespace murosimf {
void nobody_has_defined_this();
}
#endif

#if defined(MISTAKE_crashes_when_loaded)
namespace {
volatile int* volatile nothing = nullptr;
__attribute__((constructor)) void when_loaded() { *nothing = 1; }
}  // namespace
#elif defined(MISTAKE_crashes_in_a_step) || defined(MISTAKE_rounds) || defined(MISTAKE_none)
namespace {

[[maybe_unused]] volatile int* volatile nothing = nullptr;

/// Makes its error after a second.
class Bad final : public murosimf::Algorithm {
 public:
  explicit Bad(murosimf::Setup& setup) : command_(setup.write(murosimf::properties::walk_command)[0]) {}
  [[nodiscard]] murosimf::Phase phase() const noexcept override { return murosimf::Phase::control; }
  void step(const murosimf::Instant& instant) noexcept override {
    command_ = {0.1, 0, 0};
    if (instant.now < std::chrono::seconds(1)) return;
#ifdef MISTAKE_rounds
    std::fesetround(FE_UPWARD);
#elif defined(MISTAKE_crashes_in_a_step)
    *nothing = 1;
#endif
  }

 private:
  murosimf::Vec3d& command_;
};

void attach_bad(murosimf::Simulation& simulation, murosimf::Entity& robot,
                const murosimf::catalog::ControllerOptions&) {
  using murosimf::locomotion::WalkEngine;
  simulation.attach<Bad>("bad", robot, 100);
  simulation.attach<WalkEngine>("walk_engine", robot, WalkEngine::rate_hz);
}

}  // namespace
#endif

#ifndef MISTAKE_no_entry
extern "C" void murosimf_register([[maybe_unused]] murosimf::catalog::Registries& registries) {
#ifdef MISTAKE_unknown_symbol
  murosimf::nobody_has_defined_this();
#elif defined(MISTAKE_throws)
  throw std::runtime_error("the license has expired");
#elif defined(MISTAKE_throws_a_number)
  throw 42;
#elif defined(MISTAKE_exits)
  std::exit(0);
#elif defined(MISTAKE_crashes_in_a_step) || defined(MISTAKE_rounds) || defined(MISTAKE_none)
  registries.controllers.add({"bad", "for tests", "", attach_bad});
#elif defined(MISTAKE_taken_name)
  registries.controllers.add({"walk", "walks otherwise", "", {}});
#elif defined(MISTAKE_taken_command)
  registries.commands.add({"run", "runs otherwise", {}, 0, {}});
#endif
}
#endif
