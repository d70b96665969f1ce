/// watched_functions.h - functions of the C library by which control software could end the program or change what belongs to the whole
/// process: in a guarded call they end the call, or save the state before it changes; everywhere else they behave as usual.
///
/// Programs that link this define them in place of the C library's (exit, _exit, _Exit, quick_exit, pthread_exit, pthread_create, and
/// chdir, signal and the like), and shared libraries that they load call those. Not noticed here are
/// system calls by hand, calls within the C library itself, libraries that have a C library of their own.
#pragma once

namespace murosimf::control_software {

/// Forces linking of the functions, and catches exit that comes from within the C library (err, error).
void watch_functions();

}  // namespace murosimf::control_software
