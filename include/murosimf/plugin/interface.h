/// interface.h - what a plug-in defines: a shared library with levels, laws, controllers, sensors, formats or commands of its own, for
/// the program `murosimf` (docs/add_an_algorithm.md, "Plug-ins").
///
///     extern "C" const char* murosimf_plugin_version() { return murosimf::catalog::plugin_version; }
///     extern "C" void murosimf_register(murosimf::catalog::Registries& registries) { registries.controllers.add({...}); }
///
/// The headers of this folder are all that a plug-in includes; what these include in turn is installed with them, apart from the public
/// headers, and may change with every version. `plugin_version` names the number of this interface (`plugin_interface`), the version of the library, the ABI of the
/// compiler, the standard library and the kind of build; a plug-in with another one is refused in one line.
#pragma once

#include "murosimf/catalog/plugin_interface.h"
