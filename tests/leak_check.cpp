/// leak_check.cpp - tells the leak sanitizer where not to look. It stops all threads of a process to read their memory, and crashes
/// now and then beside those of a software OpenGL driver: a test that has passed fails. So a process that draws is not looked at.
#include <dlfcn.h>

/// Asked by the sanitizer before it looks (sanitizer/lsan_interface.h). Mesa comes with the first picture.
extern "C" int __lsan_is_turned_off() { return dlopen("libEGL_mesa.so.0", RTLD_LAZY | RTLD_NOLOAD) != nullptr ? 1 : 0; }
