// Plug-ins with one mistake each, chosen by a definition of the build.
#include <stdexcept>

#include "murosimf/catalog/plugin_interface.h"

#ifdef MISTAKE_other_version
extern "C" const char* murosimf_plugin_version() { return "murosimf 0.0.9, C++ ABI 1"; }
#elif !defined(MISTAKE_no_version)
extern "C" const char* murosimf_plugin_version() { return murosimf::catalog::plugin_version; }
#endif

#ifdef MISTAKE_unknown_symbol
namespace murosimf {
void nobody_has_defined_this();
}
#endif

#ifndef MISTAKE_no_entry
extern "C" void murosimf_register([[maybe_unused]] murosimf::catalog::Registries& registries) {
#ifdef MISTAKE_unknown_symbol
  murosimf::nobody_has_defined_this();
#elif defined(MISTAKE_throws)
  throw std::runtime_error("the license has expired");
#elif defined(MISTAKE_throws_a_number)
  throw 42;
#elif defined(MISTAKE_taken_name)
  registries.controllers.add({"walk", "walks otherwise", "", {}});
#elif defined(MISTAKE_taken_command)
  registries.commands.add({"run", "runs otherwise", {}, 0, {}});
#endif
}
#endif
