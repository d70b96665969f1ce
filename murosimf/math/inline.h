/// inline.h - for functions of a few instructions that a step calls thousands of times.
///
/// Left to itself, g++ keeps such a product as a function of its own as soon as a translation unit (several sources in one with
/// MUROSIMF_UNITY) uses it often, and calls it with everything in memory. The operations and their order stay the same, and so
/// do the results.
#pragma once

#define MUROSIMF_INLINE [[gnu::always_inline]] inline
/// The same behind the parameters of a lambda.
#define MUROSIMF_INLINE_LAMBDA __attribute__((always_inline))
