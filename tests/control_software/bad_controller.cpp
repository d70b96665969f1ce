// Control software that is refused before it runs: one error each, chosen by a definition of the build.
#include "murosimf/control_software/murosimf_controller.h"

namespace {

[[maybe_unused]] int robot;
void* create(const murosimf_robot*, char*, size_t) { return &robot; }
void destroy(void*) {}
[[maybe_unused]] void step(void*, int64_t) {}
[[maybe_unused]] size_t save(void*, void*, size_t) { return 0; }

#ifdef MISTAKE_other_abi
constexpr uint32_t abi = 7;
#elif defined(MISTAKE_version_1)
constexpr uint32_t abi = 1;  // no error: as compiled with the first header
#else
constexpr uint32_t abi = MUROSIMF_CONTROLLER_ABI;
#endif
#ifdef MISTAKE_no_step
constexpr auto steps = nullptr;
#else
constexpr auto steps = step;
#endif
#ifdef MISTAKE_save_alone
constexpr auto saves = save;
#else
constexpr auto saves = nullptr;
#endif
#ifdef MISTAKE_rate
constexpr double rate = -1;
#else
constexpr double rate = 0;
#endif

[[maybe_unused]] const murosimf_controller functions{abi, 0, rate, create, destroy, nullptr, steps, saves, nullptr};

}  // namespace

#ifdef MISTAKE_unknown_symbol
extern "C" void nobody_has_defined_this();
#endif

#ifndef MISTAKE_no_entry
extern "C" const murosimf_controller* murosimf_controller_entry() {
#ifdef MISTAKE_unknown_symbol
  nobody_has_defined_this();
#endif
#ifdef MISTAKE_nothing
  return nullptr;
#else
  return &functions;
#endif
}
#endif
