/// plugin_interface.h - functions that a plug-in defines: a shared library with levels, laws, controllers or sensors of its own.
///
///     extern "C" const char* murosimf_plugin_version() { return murosimf::catalog::plugin_version; }
///     extern "C" void murosimf_register(murosimf::catalog::Registries& registries) { registries.controllers.add({...}); }
///
/// It is linked to no library: all symbols come from the program that loads it (docs/add_an_algorithm.md, "Plug-ins").
#pragma once

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/math/assert.h"

namespace murosimf::catalog {

#define MUROSIMF_TEXT_OF(x) #x
#define MUROSIMF_TEXT(x) MUROSIMF_TEXT_OF(x)
#ifdef NDEBUG
#define MUROSIMF_ASSERTS "without asserts"
#else
#define MUROSIMF_ASSERTS "with asserts"
#endif
#ifdef __GXX_ABI_VERSION
#define MUROSIMF_ABI "C++ ABI " MUROSIMF_TEXT(__GXX_ABI_VERSION)
#else
#define MUROSIMF_ABI "another C++ ABI"
#endif
#ifdef _GLIBCXX_RELEASE
#define MUROSIMF_STANDARD_LIBRARY "libstdc++ " MUROSIMF_TEXT(_GLIBCXX_RELEASE)
#else
#define MUROSIMF_STANDARD_LIBRARY "another standard library"
#endif

/// Version of the plug-in interface, include/murosimf/plugin: it grows with every change there, and in headers included there,
/// that makes existing plug-ins incompatible.
#define MUROSIMF_PLUGIN_INTERFACE 1
constexpr int plugin_interface = MUROSIMF_PLUGIN_INTERFACE;

/// That version, the version of the library, then settings that determine the memory layout of its types. Internal linkage: every plug-in has its own
/// copy.
constexpr const char* plugin_version =
    "plug-in interface " MUROSIMF_TEXT(MUROSIMF_PLUGIN_INTERFACE) " of murosimf 0.1.0, " MUROSIMF_ABI
                                                                  ", " MUROSIMF_STANDARD_LIBRARY ", " MUROSIMF_ASSERTS;

#undef MUROSIMF_PLUGIN_INTERFACE
#undef MUROSIMF_STANDARD_LIBRARY
#undef MUROSIMF_ABI
#undef MUROSIMF_ASSERTS
#undef MUROSIMF_TEXT
#undef MUROSIMF_TEXT_OF

}  // namespace murosimf::catalog

extern "C" {

/// Returns `plugin_version` as compiled into the plug-in.
const char* murosimf_plugin_version();

/// Adds to the registries; called once, before any scene is built. May throw: the message becomes one line.
void murosimf_register(murosimf::catalog::Registries& registries);
}
